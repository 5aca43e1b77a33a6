"""Models and scenes of others, and what is made of them: asset folders that builds can use."""
