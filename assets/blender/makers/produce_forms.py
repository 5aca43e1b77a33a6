"""Ways to serve any fruit: whole, in groups, halved, in wedges or slices, in a net, in a tray."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from toolkit import labels
from toolkit.materials import label, plain
from toolkit.mesh import Mesh
from toolkit.model import Model
from toolkit.sampling import noise_offset
from toolkit.shapes import box, tube

from makers.produce_kit import (
    cut_face,
    footed,
    fresh_produce,
    ground,
    halve,
    layout,
    one_hull,
    patches,
    punnet,
    skin,
    spread,
    turned,
)
from makers.spoilage import wither

Top = Callable[[str, str, float], list[Mesh]]


@dataclass(frozen=True)
class Fruit:
    """What a fruit is; its axis is z, it stands on z = 0 unless it `lies`.

    skins: by kind, the arguments of `skin`. face: picture of the cut for a kind, cut `along` the
    axis or across. top: what grows on it, for (look, kind, height).
    """

    name: str
    plural: str
    outline: list[tuple[float, float]]
    mass: float
    skins: dict[str, dict]
    face: Callable[[str], object] | None = None
    along: bool = True
    top: Top | None = None
    lies: bool = False
    lobes: tuple = (0, 0.0, 0.0)
    detail: tuple[int, int] = (12, 10)
    bend: float = 0.0
    stone: Callable[[str], list[Mesh]] | None = None
    wrinkle: float = 0.15
    tray: str = "cfd8c8"
    net: str = "d8362c"
    cut_at: float = 0.0  # how far off the axis it is cut

    @property
    def r(self) -> float:
        return max(q for q, _ in self.outline)

    @property
    def middle(self) -> float:
        return max(self.outline)[1]

    @property
    def height(self) -> float:
        return max(z for _, z in self.outline)


def lying_patches(fruit: Fruit) -> list[tuple[float, ...]]:
    """For a fruit that lies with its +y side up."""
    r, h = fruit.r, fruit.height
    return [
        (r * 0.5, r * 0.7, h * 0.3, 0.95),
        (-r * 0.4, r * 0.75, h * 0.66, 0.85),
        (r * 0.75, r * 0.2, h * 0.75, 0.6),
        (r * 0.85, -r * 0.1, h * 0.45, 0.5),
        (-r * 0.8, r * 0.1, h * 0.3, 0.7),
    ]


def serve(fruit: Fruit, form="one", kind="", seed=0, size=1.0, texture=128) -> Model:
    """A fruit in one of its forms."""
    rng = np.random.default_rng(seed)
    o, phase = noise_offset(rng), rng.uniform(0, 6.28)
    kind = kind or next(iter(fruit.skins))
    r, zc = fruit.r, fruit.middle
    many = form in ("pair", "three", "pile", "row", "five", "net", "tray", "wedges", "crowd")
    lies = fruit.lies and form != "upright"
    spots = lying_patches(fruit) if lies else patches(r, zc * 0.95, seed)
    mid = fruit.height / 2
    if fruit.along:
        inner = [(r * 0.35, 0, mid + r * 0.4, 0.75), (-r * 0.45, 0, mid - r * 0.45, 0.6)]
    else:
        inner = [(r * 0.4, r * 0.25, zc, 0.75), (-r * 0.5, -r * 0.3, zc, 0.55)]

    def body(look: str) -> Mesh:
        n, m = fruit.detail
        if many:
            n, m = max(8, n * 2 // 3), max(6, m * 2 // 3)
        settings = dict(fruit.skins[kind])
        if form == "net":
            settings["grid"] = fruit.net
        lobes = (*fruit.lobes[:2], fruit.lobes[2] + phase) if fruit.lobes[0] else (0, 0, 0)
        mesh = turned(fruit.outline, n, m, skin(look, r=r, spots=spots, o=o, **settings), 1, lobes)
        if fruit.bend:
            h = fruit.height
            mesh.warp(lambda x, y, z: (x + fruit.bend * h * (2 * z / h - 1) ** 2, y, z))
        return wither(look, mesh, r, spots, fruit.wrinkle)

    def top(look: str) -> list[Mesh]:
        return fruit.top(look, kind, fruit.height) if fruit.top else []

    def whole(look: str, upright: bool = False) -> list[Mesh]:
        out = [m.keep_pattern() for m in (body(look), *top(look))]
        if fruit.lies and not upright:
            out = ground([m.turn(rx=math.pi / 2).move(y=fruit.height / 2) for m in out])
        return out

    def centred(group: list[Mesh]) -> list[Mesh]:
        low, high = group[0].v.min(0), group[0].v.max(0)
        x, y = (low[:2] + high[:2]) / 2
        return ground([m.move(-x, -y) for m in group])

    def half(look: str, lean: float = 0.0) -> list[Mesh]:
        """Cut face up, or leaning towards the front."""
        face = cut_face(look, fruit.face(kind), r, inner, o)
        if fruit.along:
            mesh = halve(body(look), (0, fruit.cut_at, 0), (0, 1, 0), face)
        else:
            mesh = halve(body(look), (0, 0, zc), (0, 0, 1), face, up=(-1, 0, 0))
        out = [mesh.keep_pattern()]
        if fruit.stone and fruit.along:
            out += [m.keep_pattern() for m in fruit.stone(look)]
        for m in out:
            if fruit.along:
                m.turn(rx=math.pi / 2)
            if lean:
                m.turn(ry=lean)
        return centred(out)

    def wedge(look: str) -> list[Mesh]:
        face = cut_face(look, fruit.face(kind), r, inner, o)
        mesh = halve(body(look), (0, 0, 0), (0, 1, 0), face)
        mesh = halve(mesh, (0, 0, 0), (math.sin(1.1), -math.cos(1.1), 0), face)
        mesh.keep_pattern().turn(rx=math.pi / 2).turn(ry=-0.55)
        return centred([mesh])

    def slice_(look: str, thick: float, at: float) -> list[Mesh]:
        face = cut_face(look, fruit.face(kind), r, inner, o)
        mesh = halve(body(look), (0, 0, at + thick), (0, 0, 1), face, up=(-1, 0, 0))
        return centred([halve(mesh, (0, 0, at), (0, 0, -1), face, up=(1, 0, 0)).keep_pattern()])

    def shape(look: str) -> list[Mesh]:
        if form == "one":
            return whole(look)
        if form == "upright":
            return whole(look, True)
        if form == "lying":
            return ground([m.turn(rx=math.pi / 2).turn(rz=0.5) for m in whole(look)])
        if form == "half":
            return half(look)
        if form == "halves":
            near = spread(half(look, 0.85), [(r * 0.75, -r * 0.85, 0, -0.35)])
            return near + spread(half(look), [(-r * 0.35, r * 1.15, 0, 0.5)])
        if form == "whole_half":
            near = spread(half(look, 0.8), [(r * 1.0, r * 0.95, 0, 0.3)])
            return near + spread(whole(look), [(-r * 0.4, -r * 0.9, 0, 2.0)])
        if form == "wedges":
            return spread(wedge(look), [(0, -r, 0, 0.5), (0, r * 1.0, 0, -0.4), (-r, 0, 0, 2.6)])
        if form == "slices":
            piece = slice_(look, r * 0.26, zc - r * 0.13)
            places = [
                (i * r * 0.45, (i - 1) * r * 1.05, r * (0.02 + 0.13 * i), i, -0.02)
                for i in range(3)
            ]
            if fruit.lies and not fruit.along and fruit.height > 3 * r:
                face = cut_face(look, fruit.face(kind), r, inner, o)
                rest = halve(body(look), (0, 0, zc), (0, 0, 1), face, up=(-1, 0, 0))
                lying = centred([rest.keep_pattern().turn(rx=-math.pi / 2)])
                near = spread(lying, [(-r * 1.9, -r * 1.6, 0, -0.75)])
            else:
                near = spread(half(look, 0.75), [(-r * 1.1, r * 0.7, 0, -0.2)])
            flat = [(x, y, 0.0 if i == 0 else z, yaw) for i, (x, y, z, yaw, _) in enumerate(places)]
            return near + spread(piece, flat)
        if form == "net":
            return in_net(whole(look), fruit, look)
        if form == "tray":
            return in_tray(whole(look), fruit)
        if fruit.lies and fruit.height > 3.6 * r:
            return spread(whole(look), lying_layout(form, r, fruit.height))
        if fruit.lies:  # egg-shaped: askew, so that each shows its length
            d = (r + fruit.height / 2) * 0.52
            skew = [
                (x, y, z, (0.9, -0.75, 2.6)[i % 3])
                for i, (x, y, z, _) in enumerate(layout(form, d))
            ]
            return spread(whole(look), skew)
        return spread(whole(look), layout(form, r))

    title = {
        "one": fruit.name,
        "upright": fruit.name,
        "lying": fruit.name,
        "half": f"half a {fruit.name}",
        "halves": f"{fruit.name} cut in two",
        "whole_half": f"{fruit.name} and a half",
        "wedges": f"wedges of {fruit.name}",
        "slices": f"slices of {fruit.name}",
        "pair": f"two {fruit.plural}",
        "net": f"net of {fruit.plural}",
        "tray": f"tray of {fruit.plural}",
        "three": f"three {fruit.plural}",
    }.get(form, fruit.plural)
    count = {"half": 0.5, "whole_half": 1.5, "pair": 2, "three": 3, "row": 3, "pile": 4}
    mass = fruit.mass * count.get(form, {"five": 5, "net": 5, "tray": 6}.get(form, 1))
    solids = one_hull if form in ("net", "tray", "wedges", "slices") else footed
    if form == "net":
        texture = 256
    title = f"{kind} {title}" if len(fruit.skins) > 1 and form == "one" else title

    def scaled(look: str) -> list[Mesh]:
        out = shape(look)
        if size != 1.0:
            for m in out:
                if m.rest is None:
                    m.keep_pattern()
                m.v = m.v * size
        return out

    return fresh_produce(title, scaled, round(mass * size**3, 3), solids, texture)


def lying_layout(form: str, r: float, h: float) -> list[tuple[float, ...]]:
    """Places of long things of radius r and length h (lying along y)."""
    if form == "pair":
        return [(-r * 1.05, 0, 0, 0.1), (r * 1.1, 0.1 * h, 0, -0.2)]
    if form == "three":
        return [(-r * 2.1, 0, 0, 0.15), (0, 0.05 * h, 0, -0.05), (r * 2.15, -0.05 * h, 0, -0.3)]
    if form == "pile":
        base = [(-r * 2.0, 0, 0, 0.06), (0, 0.05 * h, 0, -0.05), (r * 2.0, -0.05 * h, 0, 0.04)]
        return [*base, (-r * 0.9, 0.06 * h, r * 1.6, 0.5), (r * 1.1, -0.08 * h, r * 1.65, -0.3)]
    if form == "five":
        base = [(r, -h * 0.52, 0, 0.3), (r, h * 0.52, 0, 2.9), (-1.2 * r, 0, 0, 1.9)]
        return [*base, (-2.2 * r, -h * 0.9, 0, 1.2), (0, 0.02 * h, 1.6 * r, 1.1)]
    raise ValueError(form)


def in_net(group: list[Mesh], fruit: Fruit, look: str) -> list[Mesh]:
    """Five in a mesh bag along y, gathered at one end, with a paper tag."""
    body = group[:1]
    r = fruit.r if not fruit.lies else max(fruit.r, fruit.height * 0.42)
    d = r * 0.94
    top = 2 * fruit.r * 0.72 if fruit.lies else fruit.height * 0.72
    places = [(d, -d, 0, 0.4), (d, d, 0, 2.9), (-d, -d, 0, 4.4), (-d, d, 0, 1.2)]
    places += [(0, -0.45 * d, top, 0.8), (0.1 * d, 1.15 * d, top * 0.9, 2.2)]
    out = spread(body, places)
    cord = plain(fruit.net, 0.25, 400)
    z = fruit.r * 1.1
    path = [
        (0, -1.4 * d, z * 1.1),
        (0, -2.1 * d, z * 0.95),
        (0, -2.7 * d, z * 0.7),
        (0, -2.9 * d, z * 0.55),
        (0, -3.6 * d, z * 0.35),
    ]
    out.append(tube(path, [1.15 * r, 0.7 * r, 0.24 * r, 0.16 * r, 0.55 * r], 8, mat=cord))
    tag = paper(fruit, fruit.net, 0.62 * r * 1.6, 2.6 * r)
    high = max(m.v[:, 2].max() for m in out)
    tag.turn(ry=0.75).move(1.35 * d, 0.15 * d, high * 0.72)
    return [*out, tag]


def paper(fruit: Fruit, edge: str, width: float, length: float) -> Mesh:
    """A card that names the fruit along y."""
    image, pen = labels.canvas(300, 130, "#fbf6e4")
    pen.rectangle((0, 0, 300, 22), fill=f"#{edge}")
    pen.rectangle((0, 112, 300, 130), fill=f"#{edge}")
    labels.text(pen, fruit.plural.upper(), (8, 28, 292, 106), "bold", "#1f5a2a")
    return box(
        width, length, 0.0015, mat=plain("fbf6e4", 0), labels={"+z": label(image)}, weight=2.2
    )


def in_tray(group: list[Mesh], fruit: Fruit) -> list[Mesh]:
    """Six in a shallow tray, a paper over them: without, brown ones were taken for meatballs."""
    body = group
    a, b = fruit.r * 2.04, (fruit.height * 1.02 if fruit.lies else fruit.r * 2.04)
    places = [
        ((i - 0.5) * a, (j - 1) * b, 0.004, 0.25 * math.sin(3 * i + j))
        for i in range(2)
        for j in range(3)
    ]
    out = spread(body, places)
    shell = punnet(a * 2 + 0.024, b * 3 + 0.024, fruit.r * 1.0, plain(fruit.tray, 0.06, 120))
    high = max(m.v[:, 2].max() for m in out)
    strap = paper(fruit, fruit.tray, a * 1.3, b * 1.7).turn(ry=-0.2).move(0.3 * a, 0, high + 0.004)
    return [*out, shell, strap]


def with_forms(make: Callable[..., Model]) -> Callable[..., Model]:
    """A maker that also serves a table fruit where a preset says so (see `served`)."""

    @functools.wraps(make)
    def maker(table: dict | None = None, **parameters) -> Model:
        return serve(**table) if table else make(**parameters)

    return maker


def served(fruit: Fruit, form: str, kind="", seed=0, size=1.0) -> dict:
    """The preset of a model that `serve` makes."""
    return {"table": {"fruit": fruit, "form": form, "kind": kind, "seed": seed, "size": size}}
