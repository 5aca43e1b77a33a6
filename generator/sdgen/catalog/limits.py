"""How much a catalogue may hold: against folders that are not meant to be read.

With all packs ours has 45 hazards of up to 48 recipes, which stand for 7,303 placements, 1,294 at
most of one hazard; 18 terms in a predicate, 316 categories, a file an entry, 0.4 MB. At these
limits a catalogue is read in a minute or two.
"""

from __future__ import annotations

#: Files in one folder of a catalogue, and bytes of all its files.
MAX_FILES = 500
MAX_BYTES = 10_000_000
#: Hazards in all, and entries of any other kind.
MAX_HAZARDS = 500
MAX_ENTRIES = 2000
#: Recipes in one list of a hazard, and terms in its predicate.
MAX_RECIPES = 1000
MAX_TERMS = 1000
#: Placements (a category, its target and room) that the recipes of a hazard stand for, or the
#: members of an activity; and those of all hazards.
MAX_PLACEMENTS = 20_000
MAX_PLACEMENTS_IN_ALL = 50_000
