"""Place mats and coasters, with what they are for printed on them."""

from __future__ import annotations

import math

import numpy as np
from labels import prints
from toolkit.labels import canvas
from toolkit.materials import Material, blend, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import (
    Maker,
    Model,
    Part,
    Support,
    box_piece,
    cylinder_piece,
    prism_piece,
    rectangle,
    round_polygon,
)
from toolkit.sampling import uniform
from toolkit.shapes import TAU, box, extrude, lathe, superellipse

from makers.projection import project_label


def place_setting(picture, colours: list[str], scale: float = 1.0):
    """A plate between a fork and a knife, drawn on a mat (u to the right, seen from the front)."""
    image = picture.convert("RGBA")
    w, h = image.size
    over, draw = canvas(w, h)
    ink, white = colours[1], "#fbf8f0"
    cx, cy, r = w / 2, h / 2, 0.3 * h * scale
    ry = r
    draw.ellipse((cx - r, cy - ry, cx + r, cy + ry), fill=white, outline=ink, width=7)
    draw.ellipse(
        (cx - 0.66 * r, cy - 0.66 * ry, cx + 0.66 * r, cy + 0.66 * ry), outline=ink, width=4
    )
    x, top, low = cx - 1.55 * r, cy - 0.95 * r, cy + 0.95 * r
    for k in (-1.5, -0.5, 0.5, 1.5):  # fork
        draw.rectangle((x + k * 11 - 3, top, x + k * 11 + 3, top + 0.6 * r), fill=white)
    draw.rounded_rectangle((x - 20, top + 0.5 * r, x + 20, top + 0.85 * r), 12, fill=white)
    draw.rounded_rectangle((x - 6, top + 0.7 * r, x + 6, low), 6, fill=white)
    x = cx + 1.5 * r
    draw.polygon(
        [
            (x - 9, top + 0.1 * r),
            (x + 4, top),
            (x + 12, top + 0.3 * r),
            (x + 12, cy + 0.1 * r),
            (x - 9, cy + 0.1 * r),
        ],
        fill=white,
    )
    draw.rounded_rectangle((x - 7, cy + 0.05 * r, x + 9, low), 8, fill=white)
    image.alpha_composite(over)
    return image.convert("RGB")


def fringed(sx: float, sy: float, teeth: int) -> list[tuple[float, float]]:
    """A rectangle with tassels at both short ends (+Y and -Y)."""
    x, y, long = sx / 2, sy / 2 - 0.02, 0.02
    step, points = sx / teeth, []
    for k in range(teeth):
        a = x - k * step
        points += [
            (a, y),
            (a - 0.15 * step, y + long),
            (a - 0.55 * step, y + long),
            (a - 0.7 * step, y),
        ]
    back = [(-px, -py) for px, py in points]
    return [*points, *back]


def placemat(
    size=(0.31, 0.43),
    colours=("#f2ecdc", "#3a6a9c", "#c8402c"),
    pattern="check",
    form="rect",
    setting=False,
) -> Model:
    """A mat; form: rect, round, oval, fringed, scalloped or slats."""
    thick, edge = 0.005, plain(colours[1], 0.08, 150)
    picture = prints.woven(list(colours), pattern).resize((512, 384))
    if setting:
        picture = place_setting(picture, list(colours))
    cloth = printed(picture)
    if form in ("round", "scalloped"):
        r = size[0] / 2
        n = 28 if form == "round" else 48
        rib = (
            None
            if form == "round"
            else lambda k, i: 1 - 0.045 * (i % 4 == 0) - 0.012 * (i % 4 != 2)
        )
        profile = [(0, 0), (r, 0), (r, thick - 0.001), (r - 0.004, thick), (0, thick)]
        meshes = [lathe(profile, n, mats=[edge], rib=rib)]
        whole, polygon = cylinder_piece(r, 0, thick, 16), round_polygon(r - 0.012)
    elif form == "oval":
        ring = superellipse(size[0] / 2, size[1] / 2, 2.3, 36)[:, :2]
        meshes = [extrude(ring, thick, edge)]
        whole = prism_piece(ring[::3], 0, thick)
        polygon = [
            tuple(p) for p in superellipse(size[0] / 2 - 0.02, size[1] / 2 - 0.02, 2.2, 16)[:, :2]
        ]
    else:
        if form == "fringed":
            meshes = [extrude(fringed(*size, 15), thick, edge)]
        elif form == "slats":  # bamboo sticks held by two threads
            count, meshes = 26, []
            step = size[0] / count
            for k in range(count):
                stick = plain(colours[k % 2 * 2], 0.12, 60, (k, 0, 0))
                at = (-size[0] / 2 + (k + 0.5) * step, 0, 0)
                meshes.append(box(step * 0.86, size[1], thick, at, stick))
            for s in (-1, 1):
                thread = box(
                    size[0],
                    0.006,
                    0.001,
                    (0, s * size[1] * 0.3, thick - 0.0003),
                    plain(colours[1], 0.05),
                )
                meshes.append(thread)
        else:
            meshes = [box(size[0], size[1], thick, (0, 0, 0), edge, 0.002)]
        whole = box_piece((0, 0, thick / 2), (*size, thick))
        polygon = rectangle(size[0] - 0.03, size[1] - 0.07)
    if form != "slats":
        project_label(meshes[0], cloth, "+z", (0, 0), (size[1], size[0]), 0.9)
    return Model(
        f"place mat, {form}",
        {"body": Part(meshes, collision=[whole])},
        mass=0.12,
        friction=0.8,
        supports=[Support("top", thick, polygon)],
        texture_size=256 if form != "slats" else 128,
    )


def placemat_random(rng: np.random.Generator) -> dict:
    return {}


def cup_icon(ground: str, ink: str, kind: str = "cup"):
    """A steaming cup, rings or a mandala, seen from the front."""
    image, draw = canvas(256, 256, ground)
    if kind == "cup":
        draw.rounded_rectangle((70, 104, 162, 190), 26, fill=ink)
        draw.rectangle((70, 104, 162, 140), fill=ink)
        draw.ellipse((144, 116, 196, 168), outline=ink, width=13)
        draw.rounded_rectangle((54, 198, 182, 210), 5, fill=ink)
        for x in (92, 116, 140):
            draw.line([(x, 88), (x - 9, 74), (x + 7, 58), (x - 3, 42)], fill=ink, width=8)
    elif kind == "ring":
        for r, q in ((84, 7), (76, 3)):
            draw.ellipse((128 - r, 128 - r, 128 + r, 128 + r), outline=ink, width=q)
    else:
        for k in range(12):
            a = k * TAU / 12
            x, y = 128 + 74 * math.cos(a), 128 + 74 * math.sin(a)
            draw.ellipse((x - 24, y - 24, x + 24, y + 24), outline=ink, width=7)
        draw.ellipse((78, 78, 178, 178), outline=ink, width=9)
        draw.ellipse((104, 104, 152, 152), fill=ink)
    return image


def cork(light: str, dark: str) -> Material:
    m = Material()
    grains = m.ramp(m.voronoi(420), [(0, dark), (0.35, light), (1, blend(light, "#ffffff", 0.2))])
    return m.colour(m.mix(m.remap(m.noise(90, 3), 0.35, 0.65, 0, 0.4), grains, light))


def one_coaster(
    size: float, kind: str, light: str, dark: str, motif: str
) -> tuple[Mesh, np.ndarray, float]:
    """Mesh, collision piece and height of a single coaster."""
    r = size / 2
    if kind in ("cork", "slice"):
        edge = cork(light, dark) if kind == "cork" else plain(dark, 0.15, 200)
        z = 0.0075
        profile = [(0, 0), (r, 0), (r, 0.006), (r - 0.002, z), (0, z)]
        n = 24 if kind != "slice" else 20
        rib = (
            None
            if kind != "slice"
            else lambda k, i: 1 + 0.035 * math.sin(3 * i * TAU / 20) + 0.02 * math.sin(i * 2.6)
        )
        mesh = lathe(profile, n, mats=[edge], rib=rib)
        if kind == "slice":  # growth rings
            m = Material()
            far = m.distance((0.004, 0.003, z), (1, 1, 0))
            wave = m.math(
                "SINE",
                m.math(
                    "ADD", m.math("MULTIPLY", far, 1500.0), m.math("MULTIPLY", m.noise(40, 2), 5.0)
                ),
            )
            mesh.mats.append(
                m.colour(m.mix(m.remap(wave, -0.3, 0.8), light, blend(light, dark, 0.6)))
            )
            for i, face in enumerate(mesh.f):
                if mesh.v[list(face)][:, 2].min() > z - 0.0001:
                    mesh.mi[i] = 1
        else:
            top = cup_icon(light, dark, motif)
            project_label(mesh, printed(top), "+z", (0, 0), (size, size), 0.9)
        return mesh, cylinder_piece(r, 0, z, 14), z
    if kind == "hexagon":
        ring = [(r * 1.06 * math.cos(a), r * 1.06 * math.sin(a)) for a in np.arange(6) * TAU / 6]
        mesh = extrude(ring, 0.008, plain(dark, 0.12, 60), bevel_width=0.0012)
        project_label(mesh, printed(cup_icon(dark, light, motif)), "+z", (0, 0), (size, size), 0.9)
        return mesh, prism_piece(ring, 0, 0.008), 0.008
    if kind == "flower":
        n = 32
        profile = [(0, 0), (r, 0), (r, 0.005), (r - 0.003, 0.0065), (0, 0.0065)]
        mesh = lathe(
            profile, n, mats=[plain(dark, 0.1, 300)], rib=lambda k, i: 1 - 0.1 * (i % 4 == 0)
        )
        project_label(
            mesh, printed(cup_icon(light, dark, "mandala")), "+z", (0, 0), (size, size), 0.9
        )
        return mesh, cylinder_piece(r, 0, 0.0065, 14), 0.0065
    picture = (
        cup_icon(light, dark, motif) if motif else prints.woven([light, dark, light], "diamonds")
    )
    tile = printed(picture)
    top = {"+z": tile if motif else (tile, (0, 0, 0.5, 0.5))}
    mesh = box(size, size, 0.008, (0, 0, 0), plain(dark, 0.03), 0.002, labels=top)
    return mesh, box_piece((0, 0, 0.004), (size, size, 0.008)), 0.008


def coaster(
    size=0.098, kind="cork", light="#c99a62", dark="#6a4526", motif="cup", arranged=""
) -> Model:
    """A drinks coaster; arranged: '', "stack" in a holder, or a "fan" of three on one another."""
    mesh, piece, z = one_coaster(size, kind, light, dark, motif)
    meshes, pieces, top, middle = [mesh], [piece], z, (0.0, 0.0)
    if arranged == "stack":
        for k in range(1, 6):
            other, hull, _ = one_coaster(size, kind, light, dark, motif)
            if k < 5:  # only edges of the lower ones are seen
                other.keep_faces(
                    [i for i, f in enumerate(other.f) if np.ptp(other.v[list(f)][:, 2]) > 1e-4]
                )
            lift = z * 1.12 * k
            meshes.append(
                other.keep_pattern().turn(rz=0.12 * (k % 3 - 1)).move(0.002 * (k % 2), 0, lift)
            )
            pieces.append(hull + np.array([0, 0, lift]))
        top = z * 1.12 * 5 + z
        steel = plain("#2a2a2c", 0.03)
        for k in range(4):
            a = TAU * (k + 0.5) / 4
            at = ((size / 2 + 0.006) * math.cos(a), (size / 2 + 0.006) * math.sin(a), 0)
            meshes.append(box(0.006, 0.006, top + 0.012, at, steel))
            pieces.append(box_piece((at[0], at[1], top / 2 + 0.006), (0.006, 0.006, top + 0.012)))
    elif arranged == "fan":
        for k in (1, 2):  # each lies on the one below; side by side they pass for coins
            other, hull, _ = one_coaster(size, kind, light, dark, motif)
            shift = (0.018 * k, 0.036 * k, z * k)
            meshes.append(other.keep_pattern().turn(rz=0.3 * k).move(*shift))
            pieces.append(hull + np.array(shift))
        top, middle = 3 * z, shift[:2]
    polygon = [(x + middle[0], y + middle[1]) for x, y in round_polygon(size / 2 - 0.012)]
    return Model(
        "stack of coasters"
        if arranged == "stack"
        else "set of coasters"
        if arranged
        else f"{kind} coaster",
        {"body": Part(meshes, collision=pieces)},
        mass=0.05 if not arranged else 0.15,
        supports=[Support("top", top, polygon)],
        texture_size=128 if kind == "slice" else 256,
    )


def coaster_random(rng: np.random.Generator) -> dict:
    return {"size": round(uniform(rng, 0.092, 0.1), 3)}


MODELS = {
    "placemat": Maker(
        placemat,
        placemat_random,
        7,
        [
            {},
            {"form": "fringed", "pattern": "stripes", "size": (0.33, 0.47)}
            | {"colours": ("#d9c7a2", "#7a5a34", "#a8402c")},
            {"form": "round", "size": (0.36, 0.36), "pattern": "leaves"}
            | {"colours": ("#8fb8a0", "#f4f0e0", "#3f6a4c")},
            {"form": "oval", "size": (0.32, 0.46), "pattern": "plain", "setting": True}
            | {"colours": ("#c8402c", "#7a1c14", "#f2ecdc")},
            {"form": "slats", "size": (0.3, 0.42), "colours": ("#d0a868", "#6a4a24", "#b88a4a")},
            {"form": "scalloped", "size": (0.38, 0.38), "pattern": "diamonds"}
            | {"colours": ("#e9e2d2", "#3a6a9c", "#c8a050")},
            {"pattern": "plain", "setting": True, "colours": ("#2f7f8f", "#14444e", "#f2ecdc")},
        ],
    ),
    "coaster": Maker(
        coaster,
        coaster_random,
        8,
        [
            {"kind": "cork", "size": 0.098},
            {"kind": "tile", "light": "#eef2f0", "dark": "#2f5f8a", "motif": "", "size": 0.096},
            {"kind": "cork", "arranged": "stack", "size": 0.098},
            {"kind": "slice", "light": "#d8b07a", "dark": "#5a3a20", "size": 0.108},
            {"kind": "hexagon", "light": "#f2efe6", "dark": "#3a3e44", "size": 0.1},
            {"kind": "flower", "light": "#f6eee0", "dark": "#c8486a", "size": 0.118},
            {"kind": "tile", "light": "#f6f2e6", "dark": "#b5442f", "motif": "cup", "size": 0.096},
            {"kind": "cork", "light": "#c08a50", "dark": "#4a2e1a", "motif": "cup", "size": 0.1}
            | {"arranged": "fan"},
        ],
    ),
}
