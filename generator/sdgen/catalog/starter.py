"""The files that a new hazard begins with: an example that works, to be changed line by line."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Literal

from sdgen.catalog.words import NOT_A_NAME, WORD
from sdgen.errors import UsageError

Kind = Literal["place", "set"]

#: What YAML reads as no text.
_NO_TEXT = ("true", "false", "null")

_HEAD = """\
# {title}: what it is, when it is true, and how homes come by it.
# Every line is one to change; what is here is an example that builds ({example}).
# All fields: hazard_catalog/README.md. What may be named: sdgen catalog categories.

{id:<26}# the file's name
{heading:<26}# what people call it
group: safety             # or sanitation, child_safety
concerns: {{who: everyone}} # or children (max_age), older_people (min_age), living_with
urgency: medium           # high, medium or low: how soon one wants to hear of it
"""

_PLACE = """\
# What a household is told; {{object}}, {{target}} and {{room}} are filled in.
message: There is a {{object}} on the {{target}} in the {{room}}; somebody may step on it.
# The guidance that the rule follows: who gives it, in what one can look it up, and what it says.
source: To be named (an example)

# When it is true: all of these must hold. Whatever satisfies this is labelled, in every home,
# whoever put it there.
predicate:
  category: drinking_glass
  relation: ON
  target: floor
relation: ON              # the relation that labels name, and what {{target}} stands for

# How to make it: what to place where. Each category with each target is a way of its own.
anomalies:
  - {{place: drinking_glass, relation: ON, target: floor, avoid_zones: [doorway, walkway]}}

# Near misses that are fine: the same thing elsewhere, and another thing there.
lookalikes:
  - {{place: drinking_glass, relation: ON, target: [coffee_table, nightstand, kitchen_table]}}
  - {{place: pet_bowl, relation: ON, target: floor, avoid_zones: [doorway, walkway]}}

# What undoes it, the first that works.
remedy:
  - {{action: put_on, target: [kitchen_counter, sink_cabinet]}}
"""

_SET = """\
# What a household is told; {{object}} and {{room}} are filled in.
message: The {{object}} in the {{room}} stands open; somebody may fall over its door.
# The guidance that the rule follows: who gives it, in what one can look it up, and what it says.
source: To be named (an example)

# When it is true: all of these must hold. Whatever satisfies this is labelled, in every home.
predicate:
  category: dishwasher
  state: OPEN             # states are UPPER CASE
evidence_state: OPEN      # the parts that show this state (an open leaf) must be seen

# How to make it: what stands there already is brought into a state.
anomalies:
  - {{set: dishwasher, state: OPEN}}

# Near misses that are fine: another thing in that state.
lookalikes:
  - {{set: washing_machine, state: OPEN}}

# What undoes it, the first that works.
remedy:
  - {{action: close}}
"""

_EXAMPLES = {"place": "a glass on the floor", "set": "a dishwasher left open"}

_README = """\
# A catalogue of my own

`hazards/` holds one file a hazard. Change one, then:

    sdgen catalog validate {folder}
    sdgen catalog test {folder} --out tried
    sdgen build --n 6 --catalog {folder} --only {name} --hazards 1-1 --out my_homes
    sdgen view my_homes

An object that no category names yet (`sdgen catalog categories` lists them) needs an entry in
`categories/mine.yaml`:

    snow_globe:
      superclass: Decor
      source: 8-15 cm globes on a base
      size_m: [[0.06, 0.06, 0.08], [0.16, 0.16, 0.2]]   # the smallest and the largest
      mass_kg: [0.1, 1.2]
      properties: [GRABBABLE]
      lives:
        - {{relation: ON, target: [bookshelf, console_table], weight: 0.5}}

and a model. `sdgen assets import folder PATH --out my_models` makes one of a mesh; or write
`my_models/manifest.yaml` yourself (its fields are in `assets/README.md`), and name the folder with
`--assets my_models` in each of these commands.
"""


def check_new_name(name: str, taken: Iterable[str]) -> None:
    """Raise UsageError for what cannot be the id of a new hazard; ``taken`` are names of hazards
    and packs that are shipped."""
    if not WORD.fullmatch(name) or name in _NO_TEXT:
        raise UsageError(f"{name[:80]!r} {NOT_A_NAME}")
    if name in taken:
        raise UsageError(f"{name!r} is the name of a hazard or a pack that is shipped")


def starter_files(name: str, kind: Kind, folder: str) -> dict[str, str]:
    """Text of each file, by its path in a catalogue folder, which is called ``folder`` in it: the
    hazard, by which a thing is placed or furniture set to a state, and a README."""
    title = name.replace("_", " ").capitalize()
    body = _PLACE if kind == "place" else _SET
    hazard = (_HEAD + body).format(
        title=title, id=f"id: {name} ", heading=f"title: {title} ", example=_EXAMPLES[kind]
    )
    return {
        f"hazards/{name}.yaml": hazard,
        "README.md": _README.format(name=name, folder=folder),
    }
