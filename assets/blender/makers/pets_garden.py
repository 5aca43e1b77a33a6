"""Pet bowls, with water or kibble; watering cans."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels
from toolkit.materials import Material, metal, plain, shade, wood
from toolkit.mesh import Mesh
from toolkit.model import Container, Maker, Model, Part, box_piece, cylinder_piece, ring_pieces
from toolkit.sampling import noise_offset, pick
from toolkit.shapes import TAU, box, ellipsoid, extrude, lathe, rounded_rectangle, spline, tube

# foot radius, rim radius, height
BOWLS = {
    "sloped": (0.105, 0.086, 0.06),
    "crock": (0.088, 0.088, 0.07),
    "steel": (0.1, 0.092, 0.05),
    "cat": (0.082, 0.07, 0.04),
    "stand": (0.072, 0.082, 0.05),
}


def pet_print(words: str, ink: str):
    """DOG or CAT with paws and bones, all round (u = 0.5 faces the front)."""
    w, h = 1024, 160
    image, draw = labels.canvas(w, h)
    for k in range(4):
        x = 256 * k
        labels.text(draw, words, (x + 66, 20, x + 190, 140), "bold", ink)
        for cx in (x + 6, x + 250):
            draw.ellipse((cx - 24, 74, cx + 24, 122), fill=ink)
            for dx, dy in ((-30, 62), (-11, 42), (11, 42), (30, 62)):
                draw.ellipse((cx + dx - 9, dy - 11, cx + dx + 9, dy + 11), fill=ink)
    return image


def water_top(radius: float, z: float) -> Mesh:
    """Still water with ripples."""
    water = Material(occlusion=0.3)
    stops = [(0.3, "7fb0c8"), (0.5, "a9cfde"), (0.56, "e6f4fa"), (0.6, "a9cfde"), (0.8, "8fbdd2")]
    water.colour(water.ramp(water.noise(22, 2, distortion=1.5), stops))
    return lathe([(radius, z), (0.97 * radius, z + 0.002), (0, z + 0.002)], 18, mat=water)


def kibble(radius: float, z: float, rng, count: int = 11) -> list[Mesh]:
    """A heap of dry food."""
    heap = [(radius, z), (radius * 0.7, z + 0.007), (radius * 0.35, z + 0.013), (0, z + 0.014)]
    base = Material()
    lumps = base.ramp(base.voronoi(95), [(0, "b07a44"), (0.45, "8a5a30"), (0.75, "4f2f16")])
    found = [lathe(heap, 14, mat=base.colour(lumps))]
    shades = [plain(c, 0.12) for c in ("#9a6636", "#7a4a26", "#b07a44")]
    for k in range(count):
        a, far = 2.4 * k, radius * 0.84 * math.sqrt((k + 0.5) / count)
        at = z + 0.0135 - 0.012 * far / radius
        piece = lathe([(0.0075, 0), (0.0075, 0.004), (0, 0.0065)], 5, mat=shades[k % 3], weight=0.6)
        found.append(
            piece.turn(ry=float(rng.uniform(-0.4, 0.4))).move(
                far * math.cos(a), far * math.sin(a), at
            )
        )
    return found


def one_bowl(
    form: str, colour: str, words: str, ink: str, n: int
) -> tuple[Mesh, list, float, float]:
    """Shell, collision pieces, radius inside at the filling's level, and that level."""
    foot, rim, height = BOWLS[form]
    steel = colour == "steel"
    shell = metal("b4b9be", "565c62") if steel else Material()
    if not steel:
        base = shell.mottle(colour, 0.04, 60)
        shell.colour(shell.image(pet_print(words, ink), base) if words else base)
    inner = metal("c4c9cd", "72787e") if steel else plain(shade(colour, 1.12), 0.03)
    wall, floor = 0.0075, 0.01
    profile = [(0, 0.002), (foot * 0.94, 0.002), (foot, 0), (foot, 0.005), (rim, height - 0.004)]
    profile += [(rim - 0.003, height), (rim - wall, height - 0.003)]
    profile += [(rim * 0.72, floor + 0.003), (rim * 0.6, floor), (0, floor)]
    kinds = [0] * 5 + [1] * 4
    body = lathe(
        profile,
        n,
        mats=[shell, inner],
        mat_of_segment=kinds,
        label_z=(0.004, height - 0.004),
        start=-math.pi,
    )
    pieces = [cylinder_piece(foot, 0, floor, 14)]
    pieces += ring_pieces(
        [(foot, 0), (rim, height)], [(foot * 0.75, floor), (rim - wall, height)], 10
    )
    level = 0.68 * height
    share = (level - floor - 0.003) / (height - floor - 0.006)
    inside = rim * 0.72 + (rim - wall - rim * 0.72) * share
    return body, pieces, inside, level


def pet_bowl(form="sloped", colour="#c8302c", words="", ink="#f7f4ea", content="", look=0) -> Model:
    """A pet's bowl; content: "" or "water" in the default variant. Full: heaped with dry food."""
    rng = np.random.default_rng(look)
    foot, rim, height = BOWLS[form]
    body, pieces, inside, level = one_bowl(form, colour, words, ink, 18)
    meshes, lift, spots = [body], 0.0, [(0.0, 0.0)]
    bone = plain("#f7f4ea", 0.0)
    if form == "sloped":
        lean = math.atan2(foot - rim, height)
        for k in range(2):
            mark = [box(0.002, 0.045, 0.012, (0, 0, -0.006), bone)]
            mark += [
                ellipsoid((0.0012, 0.009, 0.009), (0, q * 0.022, w * 0.007), 5, 3, bone)
                for q in (-1, 1)
                for w in (-1, 1)
            ]
            for mesh in mark:
                meshes.append(
                    mesh.turn(ry=-lean).move((foot + rim) / 2, 0, height / 2).turn(rz=math.pi * k)
                )
    elif form == "cat":  # two ears at the back of the rim
        for s in (-1, 1):
            ear = extrude(
                [(-0.02, 0), (0.02, 0), (0.004, 0.034), (-0.004, 0.034)],
                0.007,
                plain(colour, 0.03),
                axis="x",
                bevel_width=0.002,
            )
            meshes.append(ear.turn(ry=-0.2).move(-rim + 0.004, 0, height - 0.012).turn(rz=0.5 * s))
    elif form in ("stand", "double"):
        lift = 0.12 if form == "stand" else 0.026
        plate = (
            wood("b98552", "7d5230", 1, 9, noise_offset(rng))
            if form == "stand"
            else plain(colour if colour != "steel" else "#3a8fa0", 0.05)
        )
        gap = 0.17 if form == "stand" else 0.155
        spots = [(0.0, -gap / 2), (0.0, gap / 2)]
        bowls = []
        for x, y in spots:
            shell = one_bowl(form, "steel", "", ink, 15)[0]
            bowls.append(shell.keep_pattern().move(x, y, lift))
        meshes = bowls
        wide, long = 2 * rim + 0.035, gap + 2 * rim + 0.035
        top = lift + height - 0.012
        board = rounded_rectangle(wide, long, 0.03, 4)
        if form == "double":
            meshes.append(extrude(board * 1.0, top, plate, bevel_width=0.006))
        else:
            meshes.append(extrude(board, 0.016, plate, bevel_width=0.003).move(z=top - 0.016))
            for sx in (-1, 1):
                for sy in (-1, 1):
                    leg = box(
                        0.022,
                        0.022,
                        top - 0.01,
                        (sx * (wide / 2 - 0.024), sy * (long / 2 - 0.024), 0),
                        plate,
                        0.003,
                    )
                    meshes.append(leg)
        pieces = [box_piece((0, 0, top / 2), (wide, long, top))]
        for x, y in spots:
            ring = ring_pieces(
                [(rim, top), (rim, lift + height)],
                [(rim - 0.008, top), (rim - 0.008, lift + height)],
                8,
            )
            pieces += [p + np.array([x, y, 0]) for p in ring]
        # the steel is seen from inside only: what is under the board is left out
        for mesh in bowls:
            heights = [mesh.v[list(f)][:, 2].max() for f in mesh.f]
            radii = [np.hypot(*(mesh.v[list(f)].mean(0)[:2] - mesh.v.mean(0)[:2])) for f in mesh.f]
            up = [
                z > top or (r < rim * 0.95 and z > lift + 0.006)
                for z, r in zip(heights, radii, strict=True)
            ]
            mesh.keep_faces([i for i, u in enumerate(up) if u])
        if form == "double":
            lid = meshes[-1]
            low = [lid.v[list(f)][:, 2].min() for f in lid.f]
            lid.keep_faces([i for i, z in enumerate(low) if z < top - 0.001])
            deck = deck_with_holes(board * 0.965, spots, rim - 0.004, top, plate)
            meshes.append(deck)
        else:
            slab = meshes[2]
            low = [slab.v[list(f)][:, 2].min() for f in slab.f]
            slab.keep_faces([i for i, z in enumerate(low) if z < top - 0.001])
            meshes.append(deck_with_holes(board * 0.97, spots, rim - 0.004, top, plate))
    parts = {"body": Part(meshes, collision=pieces)}
    x, y = spots[0]
    food = [m.keep_pattern().move(x, y, lift) for m in kibble(inside, level, rng)]
    shown, full = ["body"], ["body", "filling"]
    if len(spots) > 1:  # the other bowl holds water
        parts["water"] = Part(
            [water_top(inside, level + lift).keep_pattern().move(*spots[1], 0)],
            collision="none",
            open=True,
        )
        shown, full = ["body", "water"], ["body", "water", "filling"]
    elif content == "water":
        parts["water"] = Part([water_top(inside, level)], collision="none", open=True)
        shown = ["body", "water"]
    parts["filling"] = Part(food, collision="none", open=True)
    hollow = Container(
        "inside", (x, y, lift + (0.01 + height) / 2), (rim * 1.0, rim * 1.0, height - 0.014)
    )
    return Model(
        "pet bowls in a stand"
        if len(spots) > 1
        else "pet bowl with water"
        if content
        else "pet bowl",
        parts,
        variants={"default": shown, "full": full},
        states=[{"state": "FULL", "variants": ["full"], "parts": ["filling"]}],
        mass=0.5 if len(spots) == 1 else 1.3,
        containers=[hollow],
        ground_shadow=True,
        texture_size=256 if words else 128,
    )


def deck_with_holes(outline, spots, radius: float, z: float, mat: Material) -> Mesh:
    """The upper side of a board with two round holes: a fan of quads round each hole."""
    outline = np.asarray(outline)
    vertices, faces = [], []
    n = 16
    x_half, y_half = np.abs(outline).max(0)
    for x, y in spots:
        low, high = (-y_half, 0.0) if y < 0 else (0.0, y_half)
        start = len(vertices)
        for i in range(n):
            a = TAU * i / n
            c, s = math.cos(a), math.sin(a)
            vertices.append((x + radius * c, y + radius * s, z))
            reach_x = x_half / abs(c) if abs(c) > 1e-6 else 1e9
            edge = (high - y) if s > 0 else (y - low)
            reach = min(reach_x, edge / abs(s) if abs(s) > 1e-6 else 1e9)
            vertices.append((x + reach * c, y + reach * s, z))
        for i in range(n):
            j = (i + 1) % n
            faces.append((start + 2 * i, start + 2 * i + 1, start + 2 * j + 1, start + 2 * j))
        for sx in (-1, 1):  # the corners that the rays leave out
            for edge in (low, high):
                a = math.atan2(edge - y, sx * x_half - x) % TAU
                i = int(a / (TAU / n))
                p, q = start + 2 * i + 1, start + 2 * ((i + 1) % n) + 1
                k = len(vertices)
                vertices.append((sx * x_half, edge, z))
                faces.append((p, k, q))
    return Mesh(
        vertices,
        faces,
        None,
        [mat],
        None,
        [[(vertices[i][0], vertices[i][1]) for i in f] for f in faces],
    )


def pet_bowl_random(rng: np.random.Generator) -> dict:
    return {"look": int(rng.integers(1_000_000))}


def _double_sided(sheet: Mesh, thickness: float) -> Mesh:
    """Give a thin open dome an inner side (back faces are not drawn), a little further in."""
    n, faces = len(sheet.v), len(sheet.f)
    inner = sheet.v - [0, 0, thickness]
    inner[:, :2] *= 1 - thickness / np.abs(sheet.v[:, :2]).max()
    sheet.v = np.r_[sheet.v, inner]
    sheet.f = sheet.f + [tuple(i + n for i in face[::-1]) for face in sheet.f]
    sheet.mi = sheet.mi * 2
    apart = 3 * np.ptp([u for face in sheet.bake_uv for u, _ in face])
    sheet.label_uv = sheet.label_uv + [face[::-1] for face in sheet.label_uv]
    sheet.bake_uv = sheet.bake_uv + [
        [(apart - u, v) for u, v in face[::-1]] for face in sheet.bake_uv[:faces]
    ]
    return sheet


# body outline (z from the foot), flattening in y, where the spout starts, bends and ends, handle,
# has a rose, radius of the spout at both ends
CANS = {
    "classic": (
        [(0.088, 0), (0.086, 0.08), (0.08, 0.15), (0.082, 0.156)],
        1.0,
        [(0.07, 0.035), (0.12, 0.08), (0.18, 0.16), (0.21, 0.2)],
        [
            (0.03, 0.178),
            (0.0, 0.235),
            (-0.08, 0.245),
            (-0.135, 0.19),
            (-0.13, 0.1),
            (-0.082, 0.045),
        ],
        True,
        (0.019, 0.0105),
    ),
    "indoor": (
        [(0.062, 0), (0.068, 0.03), (0.056, 0.085), (0.03, 0.11)],
        1.0,
        [(0.05, 0.03), (0.1, 0.05), (0.14, 0.13), (0.215, 0.175)],
        [(-0.02, 0.108), (-0.06, 0.15), (-0.115, 0.13), (-0.12, 0.06), (-0.06, 0.025)],
        False,
        (0.011, 0.005),
    ),
    "plastic": (
        [(0.11, 0), (0.118, 0.04), (0.112, 0.13), (0.075, 0.19)],
        0.56,
        [(0.1, 0.03), (0.16, 0.07), (0.21, 0.17), (0.235, 0.23)],
        [(0.055, 0.19), (0.03, 0.255), (-0.05, 0.26), (-0.1, 0.2), (-0.112, 0.09)],
        True,
        (0.022, 0.012),
    ),
    "conical": (
        [(0.09, 0), (0.088, 0.01), (0.045, 0.15), (0.04, 0.16)],
        1.0,
        [(0.075, 0.02), (0.13, 0.07), (0.17, 0.15), (0.2, 0.165)],
        [(-0.04, 0.15), (-0.1, 0.165), (-0.125, 0.11), (-0.085, 0.03)],
        False,
        (0.013, 0.006),
    ),
    "ball": (
        [(0.04, 0), (0.075, 0.03), (0.084, 0.075), (0.06, 0.125), (0.034, 0.14)],
        1.0,
        [(0.075, 0.06), (0.115, 0.08), (0.14, 0.12), (0.165, 0.16)],
        [(0.03, 0.135), (0.0, 0.215), (-0.06, 0.19), (-0.08, 0.1)],
        True,
        (0.014, 0.008),
    ),
}


def watering_can(form="classic", colour="#2f8a5a", look=0) -> Model:
    """A watering can; colour: zinc, brass or a paint."""
    rng = np.random.default_rng(look)
    outline, flat, nose, grip, rosy, (thick, thin) = CANS[form]
    if colour in ("zinc", "brass"):
        light, dark = ("b9c0c4", "767e84") if colour == "zinc" else ("d8b25a", "8f6a24")
        paint, deep = metal(light, dark, (1, 1, 8), 40, noise_offset(rng)), plain("3a3c3c", 0.02)
    else:
        paint, deep = plain(colour, 0.04, 40, noise_offset(rng)), plain(shade(colour, 0.45), 0.02)
    rim_r, rim_z = outline[-1]
    low = 0.4 * rim_z
    inner = [(rim_r - 0.006, rim_z), (max(rim_r - 0.006, 0.02), low), (0, low)]
    profile = [(0, 0), *outline, *inner]
    kinds = [0] * (len(outline) + 1) + [1, 1]
    body = lathe(profile, 18, mats=[paint, deep], mat_of_segment=kinds).scale(1, flat, 1)
    meshes = [body]
    if form == "classic":
        dome = lathe([(0.081, 0.15), (0.07, 0.172), (0.045, 0.182), (0, 0.186)], 14, mat=paint)
        front = [i for i, f in enumerate(dome.f) if dome.v[list(f)].mean(0)[0] > 0.02]
        dome.keep_faces(front)
        meshes.append(_double_sided(dome, 0.004))
        meshes.append(tube([(0.075, 0, 0.152), (0.165, 0, 0.146)], 0.0045, 5, mat=paint))
    path = spline([(x, 0, z) for x, z in nose], 3)
    meshes.append(tube(path, np.linspace(thick, thin, len(path)), 7, mat=paint, up=(0, 1.0, 0)))
    (xa, za), (xb, zb) = nose[-2], nose[-1]
    if rosy:
        steep = math.atan2(xb - xa, zb - za)
        q = thin / 0.0105
        head = [(0, 0), (0.011 * q, 0), (0.03 * q, 0.024), (0.03 * q, 0.03), (0, 0.034)]
        sprinkle = Material()
        dots = sprinkle.math("LESS_THAN", sprinkle.voronoi(170), 0.32)
        sprinkle.colour(sprinkle.mix(dots, "d0a545" if colour != "zinc" else "b9c0c4", "2a2a2a"))
        rose = lathe(head, 14, mats=[paint, sprinkle], mat_of_segment=[0, 0, 0, 1])
        meshes.append(rose.turn(ry=steep).move(xb - 0.004, 0, zb - 0.004))
    bar = spline([(x, 0, z) for x, z in grip], 2)
    meshes.append(tube(bar, 0.0085 if form != "indoor" else 0.006, 6, mat=paint, up=(0, 1.0, 0)))
    widest = max(r for r, _ in outline)
    lower = [(x, y * flat, z) for x, y, z in cylinder_piece(widest, 0, 0.6 * rim_z, 14)]
    upper = [(x, y * flat, z) for x, y, z in cylinder_piece(widest, 0.6 * rim_z, rim_z, 14, rim_r)]
    pieces = [np.array(lower), np.array(upper), meshes[-2 if not rosy else -3].v.copy()]
    if rosy:
        pieces.append(meshes[-2].v.copy())
    spans = np.array_split(np.arange(len(bar)), 3)
    for span in spans:
        points = bar[span[0] : span[-1] + 2]
        pieces.append(
            np.concatenate(
                [points + np.array([0, y, z]) for y in (-0.008, 0.008) for z in (-0.007, 0.007)]
            )
        )
    return Model(
        f"{form} watering can",
        {"body": Part(meshes, collision=pieces)},
        mass=0.7,
        texture_size=128,
        front="-y",  # its spout to the right
    )


def watering_can_random(rng: np.random.Generator) -> dict:
    return {"colour": pick(rng, ["#2f8a5a", "#3a7fb0"]), "look": int(rng.integers(1_000_000))}


MODELS = {
    "pet_bowl": Maker(
        pet_bowl,
        pet_bowl_random,
        6,
        [
            {"form": "sloped", "colour": "#c8302c", "content": "water"},
            {"form": "steel", "colour": "steel"},
            {"form": "sloped", "colour": "#2f6fb0", "content": "water"},
            {"form": "crock", "colour": "#efe8d8", "words": "DOG", "ink": "#5a3218"},
            {"form": "cat", "colour": "#e88aa0", "words": "CAT", "ink": "#ffffff"},
            {"form": "stand", "colour": "steel"},
        ],
    ),
    "watering_can": Maker(
        watering_can,
        watering_can_random,
        7,
        [
            {"form": "classic", "colour": "#2f8a5a"},
            {"form": "classic", "colour": "zinc"},
            {"form": "indoor", "colour": "brass"},
            {"form": "plastic", "colour": "#3a7fc8"},
            {"form": "conical", "colour": "#e8c33a"},
            {"form": "ball", "colour": "#d8486a"},
            {"form": "plastic", "colour": "#4f9a3c"},
        ],
    ),
}
