"""Gives models a state by a new texture that Blender bakes: rotten, dirty, wet and the like."""
