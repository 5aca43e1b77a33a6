"""A scene of one model on a bare floor: how a model is looked at and put to the test."""

from __future__ import annotations

from collections.abc import Mapping

from sdgen.library.library import Library
from sdgen.library.states import derive_states
from sdgen.scene import (
    AgentStart,
    Box,
    Home,
    ObjectInstance,
    Outdoors,
    Pose,
    Room,
    Scene,
    Structure,
)

#: Id of the model, and of the floor it stands on.
MODEL_ID, FLOOR_ID = 3, 2
#: Half the floor: what rolls off a model under test does not fall off the world.
_REACH_M = 9.0


def alone_on_floor(
    library: Library,
    asset_id: str,
    variant: str = "default",
    joints: Mapping[str, float] | None = None,
    surface: str | None = None,
) -> Scene:
    """The model upright in the middle of an 18 m floor of ``surface`` (the first of the library).

    Raises KeyError for an unknown model, variant or surface.
    """
    info = library.info(asset_id)
    floors = [s.id for s in library.surfaces.values() if s.kind == "floor"]
    chosen = floors[0] if surface is None else library.surfaces[surface].id
    size = (2 * _REACH_M, 2 * _REACH_M, 0.1)
    corners = ((-_REACH_M, -_REACH_M), (_REACH_M, -_REACH_M), (_REACH_M, _REACH_M))
    outline = (*corners, (-_REACH_M, _REACH_M))
    floor = Structure(
        id=FLOOR_ID,
        category="floor",
        room_id=1,
        surface=chosen,
        pieces=(Box(center_m=(0.0, 0.0, -0.05), size_m=size),),
    )
    room = Room(id=1, name="studio", type="studio", polygon_m=outline, height_m=2.5)
    values = dict(joints or {})
    model = ObjectInstance(
        id=MODEL_ID,
        category=info.category,
        asset=asset_id,
        pose=Pose(position_m=(0.0, 0.0, 0.0), quat_xyzw=(0.0, 0.0, 0.0, 1.0)),
        room_id=1,
        joints=values,
        variant=variant,
        states=derive_states(info, variant, values),
        parts=info.variants[variant],
    )
    # No sun: soft light from all sides.
    home = Home(
        id="studio",
        kind="base",
        outdoors=Outdoors(weather="overcast"),
        rooms=(room,),
        structures=(floor,),
        openings=(),
    )
    return Scene(
        id=f"studio_{asset_id}",
        index=0,
        home=home,
        zones=(),
        free_space=(),
        agent_start=AgentStart(position_m=(1.0, 0.0, 0.0), yaw_rad=0.0, room_id=1),
        objects=(model,),
    )
