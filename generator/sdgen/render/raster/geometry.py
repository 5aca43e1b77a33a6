"""A scene's triangles on the renderer, and which of them a camera may see."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Sequence

import moderngl
import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.render.raster.drawn import Drawn
from sdgen.render.raster.shelf import Shelf, Size

#: Position, normal, place on the texture, colour factor by half (up to 2) with glow, and layer of
#: the texture with the part's number.
_CORNER = np.dtype(
    [("at", "f4", 3), ("normal", "f4", 3), ("uv", "f4", 2), ("colour", "u1", 4), ("tag", "f4", 2)]
)
_LAYOUT = ("3f 3f 2f 4f1 2f", "at", "normal", "uv", "colour", "tag")


class Batch:
    """Parts that wear textures of one size: their buffers, and where each part's corners are."""

    def __init__(
        self,
        context: moderngl.Context,
        program: moderngl.Program,
        size: Size,
        parts: Sequence[tuple[int, Drawn]],
        shelf: Shelf,
    ) -> None:
        self.size = size
        #: Numbers of the parts among all of the scene's, in the order in which they are drawn.
        self.parts = np.array([number for number, _ in parts])
        ends = np.cumsum([3 * len(part.faces) for _, part in parts])
        self._first, self._end = np.concatenate([[0], ends[:-1]]), ends
        corners = np.zeros(sum(len(part.vertices) for _, part in parts), dtype=_CORNER)
        faces, start = [], 0
        for number, part in parts:
            own = corners[start : start + len(part.vertices)]
            own["at"], own["normal"], own["uv"] = part.vertices, part.normals, part.uvs
            tint = np.rint(np.clip(np.array(part.rgb) / 2, 0, 1) * 255)
            own["colour"] = (*tint, 255 * part.glows)
            own["tag"] = (shelf.place(part.texture).layer, number + 1)
            faces.append(part.faces + np.uint32(start))
            start += len(part.vertices)
        self._corners = context.buffer(corners.tobytes())
        self._faces = context.buffer(np.concatenate(faces).tobytes())
        self._array = context.vertex_array(
            program, [(self._corners, *_LAYOUT)], self._faces, index_element_size=4
        )

    def draw(self, wanted: npt.NDArray[np.bool_]) -> None:
        """Draw those of all parts of the scene that are wanted."""
        for first, end in self._runs(wanted[self.parts]):
            self._array.render(vertices=end - first, first=first)

    def _runs(self, wanted: npt.NDArray[np.bool_]) -> Iterator[tuple[int, int]]:
        """From where to where there are corners of wanted parts, those side by side as one."""
        edges = np.flatnonzero(np.diff(np.concatenate([[False], wanted, [False]]).astype(np.int8)))
        for begin, end in edges.reshape(-1, 2).tolist():
            yield int(self._first[begin]), int(self._end[end - 1])

    def release(self) -> None:
        """Let go of the buffers."""
        for held in (self._array, self._corners, self._faces):
            held.release()


class Geometry:
    """The parts of one scene, numbered in their order."""

    def __init__(
        self,
        context: moderngl.Context,
        program: moderngl.Program,
        parts: Sequence[Drawn],
        shelf: Shelf,
    ) -> None:
        shelf.bring(part.texture for part in parts)
        self.nodes = np.array([0, *(part.node_id for part in parts)], dtype=np.uint16)
        self.numbers = np.array([0, *(part.number for part in parts)], dtype=np.uint8)
        self._boxes = np.array([part.box() for part in parts]).reshape(-1, 2, 3)
        self._shelf = shelf
        by_size: dict[Size, list[tuple[int, Drawn]]] = {}
        for number, part in enumerate(parts):
            by_size.setdefault(shelf.place(part.texture).size, []).append((number, part))
        self._batches = [
            Batch(context, program, size, some, shelf) for size, some in sorted(by_size.items())
        ]
        self._shown = np.ones(len(parts), dtype=np.bool_)

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw these nodes alone, by id; None: all."""
        every = node_ids is None
        self._shown[:] = every or np.isin(self.nodes[1:], [*(node_ids or ())])

    def draw(self, clip_from_world: Array) -> None:
        """Draw what this camera may see."""
        wanted = self._shown & ~_outside(self._boxes, clip_from_world)
        for batch in self._batches:
            self._shelf.use(batch.size, 0)
            batch.draw(wanted)

    def release(self) -> None:
        """Let go of all buffers."""
        for batch in self._batches:
            batch.release()


def _outside(boxes: Array, clip_from_world: Array) -> npt.NDArray[np.bool_]:
    """Which boxes (N, 2, 3) lie wholly beyond one of the six planes of what a camera sees."""
    if len(boxes) == 0:
        return np.zeros(0, dtype=np.bool_)
    rows = clip_from_world
    planes = np.stack([rows[3] + sign * rows[k] for k in range(3) for sign in (1, -1)])
    # Of each box the corner that lies furthest on the inner side decides.
    normals, offsets = planes[:, :3], planes[:, 3]
    furthest = np.where(normals[:, None] > 0, boxes[None, :, 1], boxes[None, :, 0])
    return np.asarray(
        (((furthest * normals[:, None]).sum(axis=2) + offsets[:, None]) < 0).any(axis=0)
    )
