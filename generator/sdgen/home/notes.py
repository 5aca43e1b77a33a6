"""What a home exported to a format of others says of itself, so that it can come back.

The shapes are the format's own business. What no shape tells (what a room is for, of which model a
thing is) goes along as one small JSON object for the home and for each thing: as ``extras`` of glTF
nodes, as ``custom`` text of MJCF. Who reads such files must do without them, too.
"""

from __future__ import annotations

from collections.abc import Iterator

from pydantic import Field

from sdgen.catalog.records import HomeSpec
from sdgen.geometry import Coordinate
from sdgen.scene import ObjectInstance, Record, Scene

#: Under this key, that nobody else uses, of extras or of names of custom text.
KEY = "sdgen"
#: Changed when what is written here would be misread by who reads an earlier one.
NOTES_FORMAT = 1


class HomeNote(Record):
    """Of the home: all that its rooms and things do not tell."""

    format: int = NOTES_FORMAT
    title: str
    style: str = ""
    height_m: float = Field(gt=0)
    rooms: dict[str, str]
    """Name of each room to its type, in the order in which the home is drawn."""


class ThingNote(Record):
    """Of a thing: its model, how it stands, and where. ``fixed``: furniture, or of the building."""

    category: str
    model: str
    room: str
    variant: str = "default"
    joints: dict[str, Coordinate] = Field(default_factory=dict)
    fixed: bool = False


def home_note(scene: Scene, spec: HomeSpec | None = None) -> HomeNote:
    """The note of a scene's home; its title, and the order of its rooms, are those of ``spec``."""
    home = scene.home
    types = {room.name: room.type for room in home.rooms}
    names = [room.name for room in (home.rooms if spec is None else spec.rooms)]
    return HomeNote(
        title=home.id if spec is None else spec.title,
        style=home.style,
        height_m=max(room.height_m for room in home.rooms),
        rooms={name: types[name] for name in names},
    )


def thing_notes(scene: Scene) -> Iterator[tuple[ObjectInstance, ThingNote]]:
    """Every object of a scene with its note."""
    names = {room.id: room.name for room in scene.home.rooms}
    for item in scene.objects:
        yield (
            item,
            ThingNote(
                category=item.category,
                model=item.asset,
                room=names[item.room_id],
                variant=item.variant,
                joints=item.joints,
                fixed=item.fixed,
            ),
        )
