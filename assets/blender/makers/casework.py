"""A kit for furniture of boards: drawers, doors, flaps and bays that open on a real inside."""

from __future__ import annotations

import numpy as np
from toolkit.materials import Material, metal, plain, shade
from toolkit.model import Container, Joint, Model, Support, rectangle
from toolkit.shapes import lathe, tube

from .joinery import (
    Assembly,
    bar_handle,
    carcass,
    drawer_box,
    finish,
    front,
    leg,
    open_closed,
    steel,
    surface,
)

Offset = tuple[float, float, float]
Span = tuple[float, float]


def metal_or(name: str, axis: int = 2, offset: Offset = (0, 0, 0)) -> Material:
    """A finish by name, with "brass", "steel", "copper" and "iron" besides."""
    if name == "brass":
        return metal("c9a45c", "8a6a2c", (1, 1, 8), 30)
    if name == "copper":
        return metal("c4825c", "84492c", (1, 1, 8), 30)
    if name == "steel":
        return steel()
    if name == "iron":
        return plain("#2c2e30", 0.06, 25, offset)
    return finish(name, axis, offset)


def striped(colour: str, dark: str, period: float, axis: int = 2) -> Material:
    """Louvres or grooves painted on: thin dark lines along an axis."""
    m = Material()
    phase = m.math("FRACT", m.math("MULTIPLY", m.axis(axis), 1.0 / period))
    line = m.remap(phase, 0.7, 0.86, 0, 1)
    return m.colour(m.mix(line, m.mottle(colour, 0.03, 12), dark))


def slatted(colour: str, dark: str, period: float) -> Material:
    """Louvres painted on: every slat falls from its light lip into the shade of the next one,
    softly, for the texture has few texels a slat."""
    m = Material()
    phase = m.math("FRACT", m.math("MULTIPLY", m.axis(2), 1.0 / period))
    shaded = m.ramp(phase, [(0, 1.0), (0.16, 0.12), (0.3, 0.0), (0.72, 0.2), (1, 1.0)])
    return m.colour(m.mix(shaded, m.mottle(colour, 0.015, 12), dark))


def cane(light: str = "d9bd8c", dark: str = "8a6a3c") -> Material:
    """Woven cane or rattan."""
    m = Material()
    a = m.math("SINE", m.math("MULTIPLY", m.math("ADD", m.axis(1), m.axis(2)), 260.0))
    b = m.math("SINE", m.math("MULTIPLY", m.math("SUBTRACT", m.axis(1), m.axis(2)), 260.0))
    hole = m.remap(m.math("MULTIPLY", a, b), 0.05, 0.5, 0, 0.9)
    return m.colour(m.mix(hole, m.mottle(light, 0.08, 30), dark))


def smoked_glass(tint: str = "3c4244") -> Material:
    """A pane of dark glass, opaque: the renderer adds what shines on it."""
    m = Material(occlusion=0.4)
    tones = [(at, shade(tint, level)) for at, level in ((0, 0.94), (0.5, 1.06), (1, 0.97))]
    return m.colour(m.ramp(m.math("FRACT", m.math("DIVIDE", m.axis(1), 1.7)), tones))


class Case:
    """Boards, joints, states, containers and supports of one piece, gathered as it is built.

    Spans are (low, high); `x` is (back, front of the carcass): fronts lie before it.
    """

    def __init__(
        self,
        wood: str,
        face: str | None = None,
        inside: str = "birch",
        pulls: str = "bar",
        style: str = "slab",
        pull_finish: str = "steel",
        offset: Offset = (0, 0, 0),
        t: float = 0.018,
    ) -> None:
        self.asm = Assembly()
        self.wood, self.across = finish(wood, 2, offset), finish(wood, 1, offset)
        self.face, self.face_up = finish(face or wood, 1, offset), finish(face or wood, 2, offset)
        self.inside, self.metal = finish(inside, 1, offset), metal_or(pull_finish)
        self.pulls, self.style, self.t, self.offset = pulls, style, t, offset
        self.panel: Material | None = None  # what the panels of shaker doors are made of
        self.joints: dict[str, Joint] = {}
        self.settings: dict[str, dict] = {}
        self.states: list[dict] = []
        self.supports: list[Support] = []
        self.containers: list[Container] = []

    def board(self, x: Span, y: Span, z: Span, mat=None, bevel=0.0, part="body", solid=True):
        """A board over three spans."""
        low, high = (x[0], y[0], z[0]), (x[1], y[1], z[1])
        return self.asm.board(part, low, high, mat or self.wood, bevel, solid=solid)

    def carcass(self, x: Span, y: Span, z: Span, top: bool = True, outside=None) -> None:
        low, high = (x[0], y[0], z[0]), (x[1], y[1], z[1])
        carcass(self.asm, "body", low, high, outside or self.wood, self.inside, self.t, top=top)

    def top(self, x: Span, y: Span, z: Span, mat=None, bevel: float = 0.004, name="top") -> None:
        """A top board and the support on it."""
        low, high = (x[0], y[0], z[0]), (x[1], y[1], z[1])
        board = self.asm.board("body", low, high, mat or self.across, bevel, segments=2)
        board.weigh(1.2)
        self.supports.append(surface(name, (x[0], y[0]), (x[1], y[1]), z[1]))

    def legs(
        self, x: Span, y: Span, height: float, inset=0.05, r=(0.014, 0.022), mat=None, sides=10,
        splay=0.0,
    ) -> None:  # fmt: skip
        for sx, px in ((-1, x[0] + inset), (1, x[1] - inset)):
            for sy, py in ((-1, y[0] + inset), (1, y[1] - inset)):
                foot = (px + sx * splay, py + sy * splay)
                leg(self.asm, "body", foot, (px, py), (0, height), r, mat or self.wood, sides)

    def plinth(self, x: Span, y: Span, height: float, mat=None) -> None:
        low, high = (x[0], y[0] + 0.012, 0), (x[1] - 0.03, y[1] - 0.012, height)
        self.asm.board("body", low, high, mat or plain("#3f3d3a", 0.05, 10))

    def pull(
        self, part: str, x: float, y: float, z: float, upright: bool, wide: float, kind=None
    ) -> None:
        """A handle, centred on (y, z), on a front whose outer face lies at x."""
        kind = kind or self.pulls
        if kind == "bar":
            length = min(0.3, 0.4 * wide)
            bar_handle(self.asm, part, x, y, z, length, self.metal, upright, 0.026)
        elif kind in ("knob", "knobs"):
            spots = (-0.26, 0.26) if kind == "knobs" and wide > 0.5 and not upright else (0.0,)
            profile = [(0, 0), (0.007, 0), (0.007, 0.008), (0.015, 0.014), (0.013, 0.023)]
            for s in spots:
                mesh = lathe([*profile, (0, 0.026)], 10, mat=self.metal).turn(ry=np.pi / 2)
                self.asm.add(part, mesh.move(x - 0.001, y + s * wide, z))
        elif kind == "cup":
            low, high = (x - 0.001, y - 0.045, z - 0.012), (x + 0.022, y + 0.045, z + 0.014)
            self.asm.board(part, low, high, self.metal, 0.008, solid=False)
        elif kind == "ring":
            a = np.arange(10) * 2 * np.pi / 10
            ring = np.c_[np.full(10, x + 0.006), y + 0.024 * np.sin(a), z + 0.024 * np.cos(a)]
            self.asm.add(part, tube(ring, 0.004, 5, closed=True, mat=self.metal))
        elif kind == "groove":
            h = (0.012, 0.07) if upright else (0.07, 0.012)
            low, high = (x - 0.01, y - h[0], z - h[1]), (x + 0.0015, y + h[0], z + h[1])
            self.asm.board(part, low, high, plain("#3a2c22", 0.05, 20), 0.003, solid=False)

    def drawer(
        self, name: str, x: Span, y: Span, z: Span, stroke: float | None = None, thick=0.02,
        upper: float = 0.78, pull_at: float = 0.5, kind: str | None = None, face=None,
    ) -> tuple[tuple, tuple]:  # fmt: skip
        """A drawer with its front; returns the inner corners of its box."""
        asm, depth = self.asm, x[1] - x[0]
        (y0, y1), (z0, z1) = (y[0] + 0.002, y[1] - 0.002), (z[0] + 0.002, z[1] - 0.002)
        if self.style == "slab":
            box = (x[1], y0, z0), (x[1] + thick, y1, z1)
            asm.board(name, *box, face or self.face, 0.002, weight=1.2)
        else:
            front(asm, name, x[1], (y0, y1), (z0, z1), face or self.face, "shaker", thick, 0.04)
        middle = (y0 + y1) / 2, z0 + pull_at * (z1 - z0)
        self.pull(name, x[1] + thick, *middle, False, y1 - y0, kind)
        low = (x[0] + 0.022, y0 + 0.024, z0 + 0.018)
        high = (x[1], y1 - 0.024, z0 + upper * (z1 - z0))
        seen = len(asm.meshes[name])
        drawer_box(asm, name, low, high, self.inside)
        for mesh in asm.meshes[name][seen:]:
            mesh.weigh(0.4)
        inner = (low[0] + 0.012, low[1] + 0.012), (high[0], high[1] - 0.012)
        room = z1 - 0.01 - low[2] - 0.008
        floor = surface(f"{name}_floor", *inner, low[2] + 0.008, room, name, name)
        self.supports.append(floor)
        center, size = np.add(low, high) / 2, np.subtract(high, low) - [0.012, 0.024, 0]
        self.containers.append(Container(name, tuple(center), tuple(size), name, name))
        travel = round(stroke or 0.62 * depth, 3)
        self.joints[name] = Joint("prismatic", (0.0, sum(y) / 2, z0), (1, 0, 0), 0.0, travel)
        self.settings[name] = {"joint": name}
        self.states += open_closed(name, name, 0.01, min(0.14, 0.55 * travel))
        return low, high

    def door(
        self, name: str, x: float, y: Span, z: Span, right: bool, thick=0.02, pull_z=None,
        style: str | None = None, rail: float = 0.06, upper: float = 1.9, kind=None,
    ) -> None:  # fmt: skip
        """A hinged leaf whose back lies at x; `right`: hung on its right (+y) side."""
        y0, y1, z0, z1 = y[0] + 0.0015, y[1] - 0.0015, z[0] + 0.002, z[1] - 0.002
        style = style or self.style
        look = "slab" if style == "slab" else "shaker"
        front(self.asm, name, x, (y0, y1), (z0, z1), self.face_up, look, thick, rail, self.panel)
        side = y0 + 0.04 if right else y1 - 0.04
        at = pull_z if pull_z is not None else z0 + 0.55 * (z1 - z0)
        self.pull(name, x + thick, side, at, True, 0.5 * (z1 - z0), kind)
        hinge_y = y1 if right else y0
        axis = (0, 0, 1 if right else -1)
        self.joints[name] = Joint("revolute", (x + thick, hinge_y, 0.0), axis, 0.0, upper)
        self.settings[name] = {"joint": name}
        self.states += open_closed(name, name)

    def flap(self, name: str, x: float, y: Span, z: Span, upper: float = 1.4, thick=0.018) -> None:
        """A front that falls forward about its lower edge."""
        y0, y1, z0, z1 = y[0] + 0.002, y[1] - 0.002, z[0] + 0.002, z[1] - 0.002
        front(self.asm, name, x, (y0, y1), (z0, z1), self.face, self.style, thick, 0.05, self.panel)
        self.pull(name, x + thick, (y0 + y1) / 2, z1 - 0.05, False, y1 - y0)
        joint = Joint("revolute", (x + thick, 0.0, z0), (0, 1, 0), 0.0, upper)
        self.joints[name], self.settings[name] = joint, {"joint": name}
        self.states += open_closed(name, name)

    def bay(
        self, name: str, x: Span, y: Span, z: Span, shelves: int = 0, closed_by: str | None = None,
        prefix: str | None = None, container: bool = True, floor: str = "floor", setback=0.02,
        mat=None,
    ) -> None:  # fmt: skip
        """The hollow between spans (inner faces): floor, `shelves` boards, a container if wanted.

        Supports are <prefix>_<floor> and <prefix>_shelf_<k>; without a prefix shelf_<k>.
        """
        t, levels = self.t, shelves + 1
        step = (z[1] - z[0] + t) / levels
        held = name if container else None
        for k in range(levels):
            level = z[0] + k * step
            if k:
                span = (x[0] + 0.006, x[1] - setback)
                self.board(span, y, (level - t, level), mat or self.inside)
            label = f"{prefix}_shelf_{k}" if k else f"{prefix}_{floor}"
            label = label if prefix else f"shelf_{len(self.supports) + 1}"
            deep = x[1] - (setback if k else 0.0)
            self.supports.append(
                surface(label, (x[0] + 0.008, y[0]), (deep, y[1]), level, step - t, held)
            )
        if container:
            center = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2)
            size = (x[1] - x[0] - 0.012, y[1] - y[0] - 0.004, z[1] - z[0] - 0.004)
            self.containers.append(Container(name, center, size, "body", closed_by))

    def model(self, title: str, mass: float, **more) -> Model:
        return Model(
            title=title,
            parts=self.asm.parts(**self.settings),
            mass=mass,
            joints=self.joints,
            states=self.states,
            supports=self.supports,
            containers=self.containers,
            ground_shadow=True,
            **more,
        )


def spot(name: str, cx: float, cy: float, r: float, z: float, n: int = 14) -> Support:
    """A round support away from the origin."""
    a = np.arange(n) * 2 * np.pi / n
    points = zip(cx + r * np.cos(a), cy + r * np.sin(a), strict=True)
    return Support(name, z, [(float(x), float(y)) for x, y in points])


def oval(name: str, rx: float, ry: float, z: float, n: int = 20, margin: float = 0.012) -> Support:
    """An elliptic support about the origin."""
    a = np.arange(n) * 2 * np.pi / n
    points = zip((rx - margin) * np.cos(a), (ry - margin) * np.sin(a), strict=True)
    return Support(name, z, [(float(x), float(y)) for x, y in points])


__all__ = [
    "Case", "cane", "metal_or", "oval", "rectangle", "slatted", "smoked_glass", "spot", "striped",
]  # fmt: skip
