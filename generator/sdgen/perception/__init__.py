"""What can be made out of a home from its pictures."""
