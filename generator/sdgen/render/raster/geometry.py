"""A scene's triangles on the renderer, and which of them a camera may see."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from typing import Any, Literal

import moderngl
import numpy as np
import numpy.typing as npt

from sdgen.geometry import Array
from sdgen.render.raster.context import release_all
from sdgen.render.raster.drawn import Drawn
from sdgen.render.raster.textures import Textures

Bools = npt.NDArray[np.bool_]

#: The programs by what they draw: what is opaque, its colours, and what is seen through.
Programs = Mapping[Literal["solid", "colours", "veils"], moderngl.Program]

#: Position, normal, place on the texture, colour factor by half (up to 2) with how much of the part
#: is seen through or, of what is not, whether it glows, and the part's number.
_CORNER = np.dtype(
    [("at", "f4", 3), ("normal", "f4", 3), ("uv", "f4", 2), ("colour", "u1", 4), ("number", "f4")]
)
_LAYOUT = "3f 3f 2f 4f1 1f"
_NAMES = ("at", "normal", "uv", "colour", "number")


class Geometry:
    """The parts of one scene, numbered from 1 in their order, in one buffer. Those that wear one
    texture lie side by side; those that are seen through come last."""

    def __init__(
        self,
        context: moderngl.Context,
        programs: Programs,
        parts: Sequence[Drawn],
        textures: Textures,
    ) -> None:
        self.nodes = np.array([0, *(part.node_id for part in parts)], dtype=np.uint16)
        self.numbers = np.array([0, *(part.number for part in parts)], dtype=np.uint8)
        self.veils = np.array([False, *(part.translucent for part in parts)], dtype=np.bool_)
        worn = textures.bring(list(dict.fromkeys(part.texture for part in parts)))
        place = {path: k for k, path in enumerate(worn)}
        order = sorted(
            range(len(parts)), key=lambda k: (parts[k].translucent, place[parts[k].texture], k)
        )
        self._order = np.array(order, dtype=np.int64)
        self._boxes = np.array([parts[k].box for k in order]).reshape(-1, 2, 3)
        self._late = self.veils[1:][self._order]
        self._shown = np.ones(len(parts), dtype=np.bool_)
        sorts = np.array([place[parts[k].texture] for k in order], dtype=np.int64)
        self._worn = [*worn.values()]
        #: Which texture each wears, and whether it is the first to.
        self._sorts = sorts.tolist()
        self._turns = np.diff(sorts, prepend=-1) != 0
        ends = np.cumsum([3 * len(parts[k].faces) for k in order])
        self._first, self._end = np.concatenate([[0], ends[:-1]]).astype(int), ends
        corners = np.zeros(sum(len(part.vertices) for part in parts), dtype=_CORNER)
        faces, start = [], 0
        for k in order:
            part = parts[k]
            own = corners[start : start + len(part.vertices)]
            own["at"], own["normal"], own["uv"] = part.vertices, part.normals, part.uvs
            tint = np.rint(np.clip(np.array(part.rgb) / 2, 0, 1) * 255) * (not part.painted)
            # Opaque parts use the fourth byte to say whether they give light.
            own["colour"] = (
                *tint,
                round(255 * part.alpha) if part.translucent else 255 * part.glows,
            )
            own["number"] = k + 1
            faces.append(part.faces + np.uint32(start))
            start += len(part.vertices)
        self._corners = context.buffer(corners.tobytes())
        self._faces = context.buffer(np.concatenate(faces).tobytes())
        self._arrays = {
            name: context.vertex_array(
                program, [_bound(self._corners, program)], self._faces, index_element_size=4
            )
            for name, program in programs.items()
        }

    def show_only(self, node_ids: Collection[int] | None) -> None:
        """Draw these nodes alone, by id; None: all."""
        every = node_ids is None
        self._shown[:] = every or np.isin(self.nodes[1:][self._order], [*(node_ids or ())])

    def seen(self, clip_from_world: Array) -> tuple[Bools, Bools]:
        """What this camera may see: the parts that are opaque, and those that are not."""
        wanted = self._shown & ~_outside(self._boxes, clip_from_world)
        return wanted & ~self._late, wanted & self._late

    def draw(self, wanted: Bools, what: Literal["solid", "colours", "veils"]) -> None:
        """Draw those parts that are wanted."""
        array, textured = self._arrays[what], what != "solid"
        for begin, end in self._runs(wanted, textured):
            if textured:
                self._worn[self._sorts[begin]].use(0)
            first = int(self._first[begin])
            array.render(vertices=int(self._end[end - 1]) - first, first=first)

    def _runs(self, wanted: Bools, textured: bool) -> Iterator[tuple[int, int]]:
        """From where to where there are wanted parts; ``textured``: that wear one texture."""
        starts = wanted.copy()
        starts[1:] &= ~wanted[:-1]
        if textured:
            starts |= wanted & self._turns
        begins = np.flatnonzero(starts)
        # A run ends where the next begins or, before that, where a part is not wanted.
        gaps = np.append(np.flatnonzero(~wanted), len(wanted))
        stops = np.minimum(np.append(begins[1:], len(wanted)), gaps[np.searchsorted(gaps, begins)])
        yield from zip(begins.tolist(), stops.tolist(), strict=True)

    def release(self) -> None:
        """Let go of the buffers; textures stay."""
        release_all([*self._arrays.values(), self._corners, self._faces])


def _bound(corners: moderngl.Buffer, program: moderngl.Program) -> tuple[Any, ...]:
    """The corners as a program takes them: what it does not use is left out, which OpenGL does."""
    padded = " ".join(
        kind if name in program else f"{int(kind[0]) * (1 if kind == '4f1' else 4)}x"
        for kind, name in zip(_LAYOUT.split(), _NAMES, strict=True)
    )
    return (corners, padded, *(name for name in _NAMES if name in program))


def _outside(boxes: Array, clip_from_world: Array) -> Bools:
    """Which boxes (N, 2, 3) lie wholly beyond one of the six planes of what a camera sees."""
    rows = clip_from_world
    planes = np.stack([rows[3] + sign * rows[k] for k in range(3) for sign in (1, -1)])
    # Of each box the corner that lies furthest on the inner side decides.
    normals, offsets = planes[:, :3], planes[:, 3]
    furthest = np.where(normals[:, None] > 0, boxes[None, :, 1], boxes[None, :, 0])
    return np.asarray(
        (((furthest * normals[:, None]).sum(axis=2) + offsets[:, None]) < 0).any(axis=0)
    )
