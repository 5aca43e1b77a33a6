"""Pixels of a mask that the EGL plugin reads wrongly, and whose they are.

The plugin interpolates an instance's handle over each triangle like a colour and cuts off what is
behind the point. Where a triangle is seen edge-on that is off by one or more: of 2,000 views some
ten pixels were another thing's, each alone among others. And where two things meet, colours and
depth may be the one's and the mask the other's: one pixel of 3,200 views.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Sequence
from itertools import product

import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array, rotation_matrix
from sdgen.render.part_bodies import NOBODY, Part
from sdgen.scene import Camera

#: What a pixel is wide of a thing, what depth is rounded by, and some more.
_SLACK_M, _SLACK_SHARE = 0.02, 0.003
#: Of its depth, by how much a surface seen at a slant is deeper from one pixel to the next.
_EDGE_SHARE = 0.01
#: Of the way to the far plane; a pixel as deep as that shows nothing.
_FAR_SHARE = 0.99
_AROUND = tuple(at for at in product((0, 1, 2), repeat=2) if at != (1, 1))


def read_again(
    index: npt.NDArray[np.int32],
    nodes: npt.NDArray[np.uint16],
    depth_m: Array,
    camera: Camera,
    world_from_camera: Array,
    parts: Sequence[Part],
) -> npt.NDArray[np.int32]:
    """Which of the ``parts`` every pixel shows, (H, W), NOBODY: none, where ``index`` says
    what was read and ``nodes`` whose that is; ``world_from_camera`` is of the world of the parts.

    A pixel is read again when its object shows at none of the eight around it, or nowhere there as
    deep, and its part is not there, at ``depth_m``: then it is of the part that most of these are
    of and that is.
    """
    out = index
    k = np.asarray(camera.K)
    for row, column in sorted({*_alone(nodes), *_odd(nodes, depth_m)}):
        ray = ((column - k[0, 2]) / k[0, 0], (row - k[1, 2]) / k[1, 1], 1.0)
        depth = float(depth_m[row, column])
        # With the pixel itself: if that is not there, others are more.
        around = index[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2]
        near = Counter(around.ravel().tolist())
        there = {
            number: depth > _FAR_SHARE * camera.far_m
            if number == NOBODY
            else _meets(parts[number], world_from_camera, ray, depth)
            for number in near
        }
        if there[int(index[row, column])]:
            continue
        if out is index:
            out = index.copy()
        out[row, column] = max(near, key=lambda n: (there[n], near[n], n))
    return out


def _alone(nodes: npt.NDArray[np.uint16]) -> list[tuple[int, int]]:
    """Row and column of the pixels unlike all eight around them."""
    around = np.pad(nodes.astype(np.int32), 1, constant_values=-1)
    steps = around[1:-1, 1:] != around[1:-1, :-1]
    row, column = np.nonzero(steps[:, 1:] & steps[:, :-1])
    own = nodes[row, column]
    for y, x in _AROUND:
        unlike = around[row + y, column + x] != own
        row, column, own = row[unlike], column[unlike], own[unlike]
    return list(zip(row.tolist(), column.tolist(), strict=True))


def _odd(nodes: npt.NDArray[np.uint16], depth_m: Array) -> list[tuple[int, int]]:
    """Row and column of the pixels that are as deep as two or more of other things around them, and
    as none of their own."""
    own = nodes.astype(np.int32)
    edge = np.zeros(nodes.shape, dtype=bool)
    across, down = own[:, 1:] != own[:, :-1], own[1:] != own[:-1]
    edge[:, 1:] |= across
    edge[:, :-1] |= across
    edge[1:] |= down
    edge[:-1] |= down
    row, column = np.nonzero(edge)
    around, deep = np.pad(own, 1, constant_values=-1), np.pad(depth_m, 1, constant_values=np.inf)
    here, depth = own[row, column], depth_m[row, column]
    alike = np.zeros(len(row), dtype=bool)
    others = np.zeros(len(row), dtype=np.int8)
    for y, x in _AROUND:
        close = np.abs(deep[row + y, column + x] - depth) <= _SLACK_M + _EDGE_SHARE * depth
        same = around[row + y, column + x] == here
        alike |= same & close
        others += ~same & close
    found = ~alike & (others >= 2)
    return list(zip(row[found].tolist(), column[found].tolist(), strict=True))


def _meets(part: Part, world_from_camera: Array, ray: Sequence[float], depth_m: float) -> bool:
    """Whether a pixel's ray, (3,) in the camera's frame with z 1, is in a part's box at a depth."""
    turn = rotation_matrix(part.orientation)
    start = (world_from_camera[:3, 3] - part.position_m) @ turn
    along = world_from_camera[:3, :3] @ ray @ turn
    along = np.where(np.abs(along) < 1e-9, 1e-9, along)
    slack = _SLACK_M + _SLACK_SHARE * depth_m
    ends = (part.box_m + np.array([[-slack], [slack]]) - start) / along
    enters, leaves = ends.min(axis=0).max(), ends.max(axis=0).min()
    if enters > leaves or leaves < 0:
        return False
    return bool(not part.deep or enters <= depth_m <= leaves)
