"""Pictures of one home in a folder: its plan, and what its cameras see."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from PIL import Image

from sdgen.gallery.plan_picture import plan_picture
from sdgen.library import Library
from sdgen.render import Choice, open_renderer
from sdgen.render.frames import render_frames
from sdgen.scene import SceneBundle

PLAN = "plan.png"


def write_pictures(
    bundle: SceneBundle, library: Library, folder: Path, renderer: Choice
) -> Iterator[Path]:
    """Write ``plan.png`` and ``NN_room.jpg`` for every camera, each yielded when it is there.

    ``folder`` is made; what lies in it under other names stays.
    """
    folder.mkdir(parents=True, exist_ok=True)
    scene = bundle.scene
    plan_picture(scene, library.infos, bundle.cameras).save(folder / PLAN)
    yield folder / PLAN
    rooms = {room.id: room.name for room in scene.home.rooms}
    with open_renderer(renderer) as drawing:
        for frame in render_frames(drawing, library, scene, bundle.cameras, ("rgb",)):
            camera = frame.camera
            path = folder / f"{camera.index:02d}_{rooms[camera.room_id]}.jpg"
            Image.fromarray(frame.rgb).save(path, quality=90)
            yield path
