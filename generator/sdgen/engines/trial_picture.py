"""A small picture of an anomaly that fits, drawn as a data set's pictures are."""

from __future__ import annotations

from itertools import compress

import numpy as np
import numpy.typing as npt

from sdgen.cameras.closeup import close_up, in_picture
from sdgen.cameras.nearest import drawn_boxes, with_near_planes
from sdgen.cameras.parts import part_points
from sdgen.cameras.sight import rectangle_pixels
from sdgen.cameras.view import poses_of
from sdgen.library import Library
from sdgen.pipeline.trial import Fits
from sdgen.render.frames import render_frames
from sdgen.render.protocol import Renderer

#: Pixels, across and down.
SIZE = (320, 240)


def trial_picture(found: Fits, library: Library, renderer: Renderer) -> npt.NDArray[np.uint8]:
    """The thing and what is around it, (H, W, 3), from the view in which it is largest."""
    facts, scene = found.facts, found.facts.scene
    item = scene.object(found.anomaly.object_id)
    # With what makes it an anomaly: the bowl that a trap is beside.
    shown_with = [scene.object(key) for key in found.anomaly.evidence_objects]
    points = np.concatenate([part_points(library, one, ()) for one in (item, *shown_with)])
    poses = poses_of(found.views)
    best = poses[int(rectangle_pixels(poses, points).argmax())]
    camera = close_up(best, points, item.room_id, SIZE)
    boxes = np.array([facts.bounding_box(thing.id) for thing in scene.objects])
    low, high = boxes[:, 0] - boxes[:, 1] / 2, boxes[:, 0] + boxes[:, 1] / 2
    # Loading is dear, and nothing else is drawn of this scene.
    seen = in_picture(camera, np.stack([low, high], axis=1)).tolist()
    shown = scene.model_copy(update={"objects": tuple(compress(scene.objects, seen))})
    cameras = with_near_planes([camera], drawn_boxes(library, shown))
    (frame,) = render_frames(renderer, library, shown, cameras, ("rgb",))
    return frame.rgb
