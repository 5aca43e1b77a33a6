"""Photographs in frames, and landscapes in oil."""

from __future__ import annotations

import numpy as np
from PIL import Image, ImageDraw

from labels.photographic import Photo, blurred, bust, lake, mountains, smooth


def _garden(p: Photo) -> None:
    """Leaves and lawn far out of focus."""
    p.c = p.gradient((0, "#cfd8c8"), (0.3, "#8ea27a"), (0.7, "#6c8458"), (1, "#7d9460"))
    for tone, cells, low in (("#4f6844", 4, 0.2), ("#b9c79a", 6, 0.7), ("#3f5638", 5, 0.9)):
        p.over(smooth(p.noise(cells, 3), low, low + 1.0) * 0.7, tone)
    p.bokeh(40, (0, 0, p.wide, 0.55), (0.02, 0.06), ["#f2f0d8", "#dce8c0", "#fff4d8"], 0.4)
    p.blur(0.02)


def family(width: int, height: int) -> Photo:
    """Two parents and their child in a garden."""
    p = Photo(width, height, 12)
    _garden(p)
    m = p.wide / 2
    bust(p, m - 0.2, 0.46, 0.32, "#cfa07e", "#3a2a20", "#4d6076")
    bust(p, m + 0.19, 0.5, 0.3, "#dcb294", "#6a4a30", "#8a5054", long=True)
    p.darken(p.ellipse(m + 0.03, 0.84, 0.24, 0.3, 0.6) * smooth(p.y, 0.5, 0.7), 0.35)
    bust(p, m + 0.01, 0.84, 0.26, "#e0b698", "#5f452e", "#b39a62")
    p.glow(p.ellipse(0.1, 0, 0.9, 0.8, 0.95) * 0.16, "#ffe8c0")
    p.blur(0.002)
    return p


def dog(width: int, height: int) -> Photo:
    """A brown dog that looks up from a meadow."""
    p = Photo(width, height, 8)
    _garden(p)
    x, fur, dark, pale = p.wide / 2, "#93663e", "#5d3d26", "#d9bd98"
    strand = p.noise(38, 4, 0.35, 0.7)
    hair = np.clip(1 + 0.16 * strand, 0.5, 1.5)

    def coat(mask, tone, cx, cy, rx, ry, low=0.4) -> None:
        p.over(blurred(mask, 1.2), tone, (low + 0.75 * p.ball(cx, cy, rx, ry)) * hair)

    ragged = 0.006 * strand
    inside = 1 - np.hypot((p.x - x) / 0.27, (p.y - 0.98) / 0.42)
    coat(smooth(inside + ragged * 3, -0.02, 0.04), fur, x, 0.9, 0.33, 0.5)
    coat(p.ellipse(x, 0.86, 0.12, 0.2, 0.4), pale, x, 0.82, 0.2, 0.3)
    p.darken(p.ellipse(x + 0.02, 0.66, 0.2, 0.08, 0.7), 0.5)
    head = np.maximum(p.ellipse(x, 0.4, 0.19, 0.19, 0.06), p.ellipse(x, 0.5, 0.155, 0.16, 0.08))
    coat(head, fur, x, 0.4, 0.24, 0.26, 0.35)
    for q in (-1, 1):
        ear = np.maximum(
            p.limb((x + q * 0.15, 0.29), (x + q * 0.225, 0.47), 0.045, 0.072, 0.012),
            p.ellipse(x + q * 0.225, 0.49, 0.07, 0.1, 0.15),
        )
        p.darken(p.ellipse(x + q * 0.17, 0.45, 0.05, 0.14, 0.7) * head, 0.35)
        coat(ear, dark, x + q * 0.21, 0.4, 0.12, 0.22, 0.45)
    blaze = p.limb((x, 0.3), (x, 0.44), 0.014, 0.05, 0.03) * 0.75
    muzzle = np.maximum(p.ellipse(x, 0.52, 0.105, 0.095, 0.2), p.ellipse(x, 0.46, 0.065, 0.1, 0.3))
    coat(np.maximum(blaze, muzzle), pale, x - 0.01, 0.5, 0.16, 0.16, 0.42)
    p.darken(p.limb((x, 0.52), (x, 0.57), 0.004, 0.004, 0.006), 0.6)
    for q in (-1, 1):
        p.darken(p.limb((x, 0.57), (x + q * 0.06, 0.585), 0.005, 0.003, 0.008), 0.6)
        p.darken(p.ellipse(x + q * 0.088, 0.385, 0.045, 0.036, 0.7), 0.5)
        p.over(p.ellipse(x + q * 0.086, 0.388, 0.025, 0.024, 0.2), "#2a190f")
        p.glow(p.ellipse(x + q * 0.086 - 0.008, 0.379, 0.006, 0.006, 0.5) * 0.9, "#f0f0ea")
        p.glow(p.ellipse(x + q * 0.09, 0.335, 0.03, 0.012, 0.9) * 0.16, "#e8c89a")
    p.over(
        p.ellipse(x, 0.49, 0.045, 0.034, 0.15), "#241a17", 0.7 + 0.6 * p.ball(x, 0.49, 0.06, 0.05)
    )
    p.glow(p.ellipse(x - 0.012, 0.476, 0.018, 0.007, 0.8) * 0.45, "#e8e4e0")
    blades = smooth(p.noise(30, 3, 0.12) + 9 * (p.y - 0.98), 0, 1.2)
    p.over(blades * 0.9, "#5f7a40", np.clip(1 + 0.2 * strand, 0.6, 1.4))
    p.blur(0.002)
    return p


PHOTOS = {"lake": lake, "family": family, "dog": dog}


def photo(kind: str, width: int = 256, height: int = 256) -> Image.Image:
    """A photograph: 'lake', 'family' or 'dog'."""
    return PHOTOS[kind](width, height).image(0.006, 0.25, gain=1.3).convert("RGBA")


def _country(width: int, height: int, seed: int) -> Photo:
    """Hills in the last light, a river and trees: what the painter saw."""
    p = Photo(width, height, seed)
    sun = p.wide * p.rng.uniform(0.3, 0.7)
    p.c = p.gradient((0, "#7f93a8"), (0.3, "#d6c3a2"), (0.5, "#ecca94"))
    cloud = smooth(p.noise(3, 5, 2.6), 0.1, 1.6)
    p.over(cloud * 0.8, "#c9a08c", 1.25 - 0.5 * p.y)
    p.glow(np.exp(-np.hypot(p.x - sun, p.y - 0.4) / 0.16), "#ffe3a4")
    p.over(p.ellipse(sun, 0.4, 0.035, 0.035, 0.3), "#fff0c4")
    foot = 0.95
    for base, rise, tone, fog in (
        (0.47, 0.05, "#7d8a94", 0.5),
        (0.54, 0.05, "#6f7f74", 0.3),
        (0.63, 0.05, "#66744e", 0.12),
        (0.74, 0.04, "#59663a", 0.0),
    ):
        line = p.ridge(base, rise, 2.2, 0.42)
        mountains(p, line, tone, "#dcb98e", fog, foot)
        field = smooth(p.noise(5, 3, 4), 0.2, 0.9) * smooth(p.y - line[None, :], 0, 0.03)
        p.over(field * 0.45 * (1 - smooth(p.y, base + 0.09, base + 0.13)), "#b9a45e")
        for _ in range(int(26 * p.wide)):
            k = int(p.rng.integers(p.w))
            r = p.rng.uniform(0.25, 1) * 0.075 * (base - 0.36)
            x, y = k / p.h, line[k] + p.rng.uniform(-0.3, 1.2) * r
            lit = 0.5 + 0.8 * p.ball(x, y, r, r, (np.sign(sun - x) * 0.6, -0.5, 0.6))
            p.over(p.ellipse(x, y, r, 1.15 * r, 0.25), "#4d5a38", lit)
    bend = p.wide * (0.5 + 0.16 * np.sin(6 * p.y + seed)) + 0.4 * (p.y - 0.7)
    wide = 0.3 * np.clip(p.y - 0.7, 0, 1) ** 1.2
    river = (1 - smooth(np.abs(p.x - bend), wide - 0.01, wide + 0.01)) * smooth(p.y, 0.72, 0.74)
    p.over(river, p.c[::-1][np.clip((p.h * 0.1 * np.ones((p.h, p.w))).astype(int), 0, p.h - 1), 0])
    p.over(river, "#c9b290", 1.1 - 0.4 * (p.y - 0.7) + 0.06 * p.noise(30, 3, 6))
    return p


def oil(seed: int, width: int, height: int) -> Image.Image:
    """A landscape in oil: laid on in strokes, broad ones first."""
    p = _country(width, height, seed)
    rng, scene = p.rng, np.clip(p.c, 0, 1)
    span = min(p.w, p.h)
    image = Image.fromarray((255 * scene).astype(np.uint8))
    draw = ImageDraw.Draw(image)
    for share, count in ((0.05, 1100), (0.026, 4200), (0.014, 9000)):
        thick = max(2, round(share * span))
        soft = blurred(scene, thick * 0.45)
        grey = blurred(scene.mean(axis=2), thick * 0.9)
        gy, gx = np.gradient(grey)
        detail = np.abs(scene - blurred(scene, thick * 1.2)).sum(axis=2)
        for _ in range(int(count * p.w * p.h / span**2)):
            i, j = int(rng.integers(p.h)), int(rng.integers(p.w))
            if thick < 0.02 * span and detail[i, j] < 0.05:
                continue
            turn = np.arctan2(gx[i, j], -gy[i, j] + 1e-9) + rng.normal(0, 0.25)
            if np.hypot(gx[i, j], gy[i, j]) < 0.0006:
                turn = rng.normal(0, 0.4)
            reach = thick * rng.uniform(0.9, 1.9)
            a, b = np.cos(turn) * reach, np.sin(turn) * reach
            tone = soft[i, j] * (1 + rng.normal(0, 0.05)) + rng.normal(0, 0.012, 3)
            fill = tuple(int(v) for v in 255 * np.clip(tone, 0, 1))
            draw.line((j - a, i - b, j + a, i + b), fill=fill, width=thick)
    p.c = np.asarray(image, float) / 255
    relief = p.c.mean(axis=2)
    p.c += 0.35 * (relief - np.roll(relief, (1, 1), (0, 1)))[..., None]
    grey = p.c.mean(axis=2)[..., None]
    p.c = grey + 1.25 * (p.c - grey)
    return p.image(0.008, 0.15, 0.97, gain=1.3).convert("RGBA")
