"""Printers."""

from __future__ import annotations

import numpy as np
from labels import devices
from toolkit.materials import Material, plain
from toolkit.materials import label as printed
from toolkit.mesh import Mesh
from toolkit.model import Maker, Model, Part
from toolkit.shapes import box, extrude

from makers.solids import solids


def printer(kind: str, shell: str, dark: str) -> Model:
    """'inkjet' (paper rising behind), 'laser' (a page on top), 'office' (drawers and a feeder),
    'photo' (small) or 'scan' (the scanner's lid up)."""
    case, low = plain(shell, 0.03, 30), plain(dark, 0.04, 40)
    black = plain("#101114", 0)
    page, photo = printed(devices.sheet(False)), printed(devices.sheet(True, 2))
    white = plain("#fbfbf8", 0.0)
    meshes: list[Mesh] = []

    def panel(x: float, y: float, z: float, lean: float, w: float = 0.15) -> None:
        image = devices.Image.new("RGB", (256, 96), dark)
        draw = devices.ImageDraw.Draw(image)
        draw.rectangle((12, 12, 128, 84), fill="#3fa0e0")
        devices.fit_text(draw, "PRINT", (20, 26, 120, 70), "bold", "#ffffff")
        for k, c in enumerate(("#e8e8e6", "#e8e8e6", "#2fa04a")):
            draw.ellipse((142 + 37 * k, 30, 172 + 37 * k, 60), fill=c)
        plate = box(0.005, w, w * 0.375, (0, 0, 0), low, 0, 1, {"+x": printed(image)})
        meshes.append(plate.turn(ry=-lean).move(x, y, z))

    def leaf(sx: float, sy: float, at, turn: float, mat: Material) -> None:
        sheet = box(sx, sy, 0.005, (0, 0, 0), white, 0, 1, {"+z": mat})
        meshes.append(sheet.turn(ry=turn).move(*at))

    if kind in ("inkjet", "scan"):
        d, w, h = 0.3, 0.43, 0.15
        meshes.append(box(d, w, h - 0.03, (0, 0, 0), case, 0.012))
        meshes.append(box(0.02, w * 0.66, 0.055, (d / 2 - 0.008, 0, 0.028), black))
        leaf(0.16, 0.21, (d / 2 + 0.06, 0, 0.034), 0.12, photo)
        meshes.append(box(0.14, 0.26, 0.008, (d / 2 + 0.05, 0, 0.014), low, 0.002))
        panel(d / 2 + 0.003, 0.13, 0.088, 0.25, 0.12)
        lid = box(d - 0.012, w - 0.012, 0.034, (0, 0, 0), low if kind == "inkjet" else case, 0.01)
        if kind == "scan":
            glass = plain("#9ccbe0", 0.02)
            meshes.append(box(d - 0.09, w - 0.1, 0.004, (-0.01, 0, h - 0.031), glass))
            meshes.append(lid.move(d / 2, 0, 0).turn(ry=-1.15).move(-d / 2, 0, h - 0.025))
            under = box(d - 0.06, w - 0.06, 0.004, (d / 2, 0, -0.003), white)
            meshes.append(under.turn(ry=-1.15).move(-d / 2, 0, h - 0.025))
            pieces = solids(meshes[:1], meshes[2:4], meshes[-2:])
        else:
            meshes.append(lid.move(0, 0, h - 0.032))
            tray = box(0.012, 0.26, 0.17, (0, 0, 0), low, 0.003).turn(ry=-0.3)
            meshes.append(tray.move(-d / 2 + 0.01, 0, h - 0.02))
            stack = box(0.006, 0.21, 0.23, (0, 0, 0), white).turn(ry=-0.3)
            meshes.append(stack.move(-d / 2 + 0.022, 0, h - 0.02))
            pieces = solids([meshes[0], lid], meshes[2:4], meshes[-2:])
    elif kind == "laser":
        d, w, h = 0.36, 0.38, 0.24
        side = [(-d / 2, 0), (d / 2, 0), (d / 2, 0.17), (d / 2 - 0.03, 0.2), (0.03, 0.2)]
        side += [(-0.06, 0.235), (-0.1, 0.24), (-d / 2, 0.24)]
        meshes.append(extrude(side, w, mat=case, axis="y", bevel_width=0.008))
        meshes.append(box(0.006, w - 0.05, 0.055, (d / 2, 0, 0.02), low, 0.002))
        meshes.append(box(0.01, 0.1, 0.012, (d / 2 + 0.002, 0, 0.05), black))
        meshes.append(box(0.006, 0.26, 0.02, (-0.0, 0, 0.2), black))
        leaf(0.2, 0.21, (0.07, 0, 0.208), 0.08, page)
        panel(d / 2 + 0.002, 0.1, 0.105, 0.0, 0.13)
        pieces = solids(meshes)
    elif kind == "office":
        d, w = 0.42, 0.44
        for k in range(2):
            meshes.append(box(d, w, 0.11, (0, 0, 0.112 * k), low, 0.006))
            meshes.append(box(0.012, 0.12, 0.02, (d / 2, 0, 0.112 * k + 0.06), black))
        meshes.append(box(d, w, 0.13, (0, 0, 0.224), case, 0.006))
        meshes.append(box(0.02, w * 0.7, 0.06, (d / 2 - 0.007, 0.04, 0.262), black))
        leaf(0.17, 0.21, (d / 2 + 0.02, 0.04, 0.272), 0.2, page)
        meshes.append(box(0.06, 0.06, 0.09, (-d / 2 + 0.04, -w / 2 + 0.04, 0.35), case))
        meshes.append(box(d * 0.9, w, 0.05, (-0.01, 0, 0.354), case, 0.008))
        feeder = [(-0.19, 0.404), (0.04, 0.404), (0.02, 0.455), (-0.15, 0.47), (-0.19, 0.45)]
        meshes.append(extrude(feeder, 0.3, mat=low, axis="y", bevel_width=0.006).move(y=0.03))
        leaf(0.2, 0.21, (-0.02, 0.03, 0.472), 0.3, page)
        panel(d / 2 + 0.012, -0.11, 0.372, 0.6, 0.15)
        pieces = solids(meshes[:7], meshes[7:])
    else:
        d, w, h = 0.14, 0.2, 0.075
        meshes.append(box(d, w, h, (0, 0, 0), case, 0.014))
        meshes.append(box(0.01, 0.13, 0.016, (d / 2 - 0.003, 0, 0.024), black))
        leaf(0.12, 0.105, (d / 2 + 0.045, 0, 0.018), 0.06, photo)
        panel(d / 2 - 0.005, 0.0, 0.046, 0.3, 0.06)
        rear = box(0.008, 0.13, 0.09, (0, 0, 0), low).turn(ry=-0.35)
        meshes.append(rear.move(-d / 2 + 0.02, 0, h - 0.01))
        pieces = solids(meshes[:1], meshes[2:3], meshes[-1:])
    return Model("printer", {"body": Part(meshes, collision=pieces)}, mass=6.0, friction=0.6)


def printer_random(rng: np.random.Generator) -> dict:
    return {"kind": "inkjet", "shell": "#f0f0ee", "dark": "#3a3d43"}


MODELS = {
    "printer": Maker(
        printer,
        printer_random,
        7,
        [
            {},
            {"kind": "laser", "shell": "#e4e4e0", "dark": "#55595f"},
            {"kind": "office", "shell": "#e8e8e6", "dark": "#8a9098"},
            {"kind": "photo", "shell": "#f4f4f2", "dark": "#2f6fb0"},
            {"kind": "scan", "shell": "#26282c", "dark": "#3a3d43"},
            {"shell": "#2a2c30", "dark": "#17181a"},
            {"kind": "laser", "shell": "#33363b", "dark": "#1c1d20"},
        ],
    ),
}
