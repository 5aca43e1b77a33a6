"""What an agent did and saw, kept: as files, as a video, as a data set to learn from."""
