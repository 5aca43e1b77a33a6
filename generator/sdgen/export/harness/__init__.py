"""Files that go into a folder of questions as they are."""
