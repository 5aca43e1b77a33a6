"""A scene's cameras as frames: what a renderer draws, completed for the data set."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import numpy as np
import numpy.typing as npt

from sdgen.library import Library
from sdgen.render.alone import AlonePixels
from sdgen.render.landing import landings
from sdgen.render.opengl import to_millimetres
from sdgen.render.outdoors import clear_panes, paint_outdoors
from sdgen.render.protocol import Renderer
from sdgen.scene import Camera, Frame, Scene


def render_frames(
    renderer: Renderer,
    library: Library,
    scene: Scene,
    cameras: Sequence[Camera],
    sensors: Collection[str] = ("rgb", "depth", "instance"),
    supersample: int = 1,
) -> Iterator[Frame]:
    """One frame a camera, in order; none when ``sensors`` is empty.

    With ``supersample`` 2 the colours are drawn at twice the size and averaged; masks and
    depth never are. The scene stays loaded until the iterator is done: finish one before
    beginning the next.
    """
    if not sensors or not cameras:
        return
    renderer.load(library, scene)
    alone_pixels = AlonePixels(library, scene)
    panes, behind = clear_panes(library, scene), landings(scene.home)
    for camera in cameras:
        picture = renderer.draw(camera)
        rgb, seen = picture.rgb, picture.instance > 0
        if "rgb" in sensors:
            if supersample > 1:
                rgb = box_filter(renderer.draw_colours(camera, supersample), supersample)
            world = scene.home.outdoors, scene.home.daylight
            drawn = rgb, picture.instance, picture.part
            rgb = paint_outdoors(*drawn, panes, *world, camera, behind)
        yield Frame(
            camera=camera,
            rgb=rgb,
            depth_mm=to_millimetres(picture.depth_m, seen),
            instance=picture.instance,
            part=picture.part,
            alone_pixels=alone_pixels(camera, picture.instance),
        )


def box_filter(image: npt.NDArray[np.uint8], factor: int) -> npt.NDArray[np.uint8]:
    """Mean of every ``factor`` x ``factor`` block, rounded half up."""
    height, width = image.shape[0] // factor, image.shape[1] // factor
    blocks = image.reshape(height, factor, width, factor, 3).astype(np.uint16)
    area = factor * factor
    mean = (blocks.sum(axis=(1, 3)) + area // 2) // area
    return np.asarray(mean, dtype=np.uint8)
