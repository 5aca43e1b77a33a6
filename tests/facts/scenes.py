"""A kitchen and a hall with a doorway between them, and models to put in them."""

from sdgen.facts import Facts
from sdgen.geometry import quat_from_yaw
from sdgen.library.records import AssetInfo
from sdgen.scene import (
    AgentStart,
    Box,
    Home,
    ObjectInstance,
    Opening,
    Pose,
    Room,
    Scene,
    Structure,
    Zone,
)

ROOM, HALL, FLOOR, HALL_FLOOR, DOOR = 10, 11, 12, 13, 14


def asset(name, extents, **more):
    data = {
        "id": name,
        "category": name,
        "licence": "CC-BY-4.0",
        "source": "test",
        "extents_m": extents,
        "mass_kg": 1,
        "parts": [{"name": "body", "faces": 12}, {"name": "door", "faces": 12, "joint": "door"}],
        "joints": [
            {
                "name": "door",
                "type": "revolute",
                "origin_m": (0, 0, 0),
                "axis": (0, 0, 1),
                "lower": 0,
                "upper": 2,
            }
        ],
        "variants": {"default": ["body", "door"]},
    }
    return AssetInfo.model_validate({**data, **more})


def square(half):
    return [(-half, -half), (half, -half), (half, half), (-half, half)]


INFOS = {
    a.id: a
    for a in (
        asset("apple", (0.08, 0.08, 0.08)),
        asset("box", (0.3, 0.3, 0.3)),
        asset("rug", (1.5, 1.0, 0.01)),
        asset(
            "plate",
            (0.2, 0.2, 0.02),
            supports=[{"name": "top", "part": "body", "z_m": 0.01, "polygon_m": square(0.09)}],
        ),
        asset(
            "table",
            (1.0, 1.0, 0.75),
            supports=[{"name": "top", "part": "body", "z_m": 0.75, "polygon_m": square(0.49)}],
        ),
        asset(
            "fridge",
            (0.6, 0.6, 1.7),
            containers=[
                {
                    "name": "inside",
                    "part": "body",
                    "center_m": (0, 0, 0.85),
                    "size_m": (0.5, 0.5, 1.5),
                    "closed_by": "door",
                }
            ],
            supports=[
                {
                    "name": "shelf",
                    "part": "body",
                    "z_m": 0.5,
                    "polygon_m": square(0.24),
                    "headroom_m": 0.4,
                    "container": "inside",
                }
            ],
            states=[
                {"state": "CLOSED", "joint": "door", "max": 0.03},
                {"state": "OPEN", "joint": "door", "min": 0.5},
            ],
        ),
        asset(
            "sink_cabinet",
            (0.6, 0.6, 0.9),
            containers=[
                {
                    "name": "cupboard",
                    "part": "body",
                    "center_m": (0, 0, 0.35),
                    "size_m": (0.5, 0.5, 0.6),
                    "closed_by": "door",
                },
                {
                    "name": "basin",
                    "part": "body",
                    "center_m": (0, 0, 0.8),
                    "size_m": (0.5, 0.5, 0.2),
                },
            ],
            states=[
                {"state": "CLOSED", "joint": "door", "max": 0.03},
                {"state": "OPEN", "joint": "door", "min": 0.5},
            ],
        ),
        asset("sofa", (0.9, 2.0, 0.8)),
        asset("tv", (0.1, 1.0, 0.6)),
        asset("stove", (0.6, 0.6, 0.9)),
        asset("door", (0.12, 0.9, 2.1)),
    )
}
PROPERTIES = {"sofa": ("SITTABLE",), "tv": ("LOOKABLE",), "table": ("SAT_AT",)}
FIXED = {"table", "sink_cabinet", "fridge", "sofa", "tv", "stove", "rug", "door"}


def thing(number, name, x, y, z=0.0, yaw=0.0, room=ROOM, **more):
    pose = Pose(position_m=(x, y, z), quat_xyzw=quat_from_yaw(yaw))
    return ObjectInstance(
        id=number,
        category=name,
        asset=name,
        pose=pose,
        room_id=room,
        fixed=name in FIXED,
        **more,
    )


def scene(*objects, zones=()):
    rooms = (
        Room(
            id=ROOM,
            name="a",
            type="kitchen",
            polygon_m=((0, 0), (4, 0), (4, 4), (0, 4)),
            height_m=2.6,
        ),
        Room(
            id=HALL,
            name="b",
            type="hall",
            polygon_m=((4.12, 0), (6, 0), (6, 4), (4.12, 4)),
            height_m=2.6,
        ),
    )
    floors = tuple(
        Structure(
            id=i,
            category="floor",
            room_id=r,
            surface="s",
            pieces=(Box(center_m=(2, 2, -0.05), size_m=(4, 4, 0.1)),),
        )
        for i, r in ((FLOOR, ROOM), (HALL_FLOOR, HALL))
    )
    door = Opening(
        object_id=DOOR,
        kind="door",
        room_ids=(ROOM, HALL),
        center_m=(4.06, 2, 0),
        along="y",
        width_m=0.9,
        height_m=2.1,
    )
    return Scene(
        id="000000",
        index=0,
        home=Home(id="h", kind="base", rooms=rooms, structures=floors, openings=(door,)),
        zones=tuple(zones),
        free_space=(),
        agent_start=AgentStart(position_m=(1, 1, 0), yaw_rad=0, room_id=ROOM),
        objects=tuple(objects),
    )


def facts(*objects, zones=(), more=()):
    infos = {**INFOS, **{info.id: info for info in more}}
    return Facts(scene(*objects, zones=zones), infos, PROPERTIES)


def zone(kind, polygon, low, high, source):
    """A zone of the kitchen."""
    return Zone(
        name=f"{kind}:a",
        kind=kind,
        polygon_m=polygon,
        z_min_m=low,
        z_max_m=high,
        room_id=ROOM,
        source_id=source,
    )
