"""A world around a home: places, their light by the time of day, and what stands in them."""
