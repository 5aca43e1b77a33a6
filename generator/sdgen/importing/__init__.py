"""Other people's models and scenes, brought into libraries and homes of ours."""
