"""Pillow drawings for labels, covers and screens. All brands, titles and names are invented."""
