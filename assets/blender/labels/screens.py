"""What is on television: frames of programmes for the `on` variants, like photographs."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PIL import Image, ImageDraw
from toolkit import labels

from labels.photographic import Photo, blurred, bust, lake, mountains, rgb, smooth

#: Lit screens multiply their texture by 1.45: with whites at this, highlights keep their colour.
WHITE = 0.86


def _caption(image: Image.Image, bars: list[tuple], words: list[tuple]) -> Image.Image:
    """Lay bars (box, RGBA) and words (words, box, colour) over a frame, in pixels of 256 x 144."""
    over = Image.new("RGBA", image.size, (0, 0, 0, 0))
    draw = ImageDraw.Draw(over)
    for box, fill in bars:
        draw.rectangle(box, fill=fill)
    for line, box, fill in words:
        labels.text(draw, line, box, "condensed", fill, align="left")
    return Image.alpha_composite(image.convert("RGBA"), over).convert("RGB")


def _football(w: int, h: int) -> Image.Image:
    """The right half of a pitch from high on the stand; metres, x along it, y away from us."""
    p = Photo(w, h, 3)
    eye, pitch, f = np.array([20.0, -34.0, 24.0]), 0.37, 2.3
    u, v = (p.x - p.wide / 2) / f, (p.y - 0.5) / f
    forward = np.cos(pitch) - v * np.sin(pitch)
    down = np.sin(pitch) + v * np.cos(pitch)
    far = eye[2] / np.maximum(down, 1e-3)
    gx, gy = eye[0] + u * far, eye[1] + forward * far

    def at(x: float, y: float, z: float = 0.0) -> tuple[float, float, float]:
        """Where a point is seen, and how long a metre is there."""
        a, b = y - eye[1], z - eye[2]
        deep = a * np.cos(pitch) - b * np.sin(pitch)
        up = a * np.sin(pitch) + b * np.cos(pitch)
        return p.wide / 2 + f * (x - eye[0]) / deep, 0.5 - f * up / deep, f / deep

    grass = rgb("#55803f") * (1 + 0.05 * p.noise(30, 4, 2))[..., None]
    mown = smooth(np.sin(gx * np.pi / 5.5), -0.25, 0.25)
    p.c = grass * (0.88 + 0.2 * mown + 0.03 * p.noise(3, 3))[..., None]
    p.c *= (1.12 - 0.006 * np.clip(gy, 0, 68))[..., None]
    half = 0.09 + 0.0011 * far

    def line(away: np.ndarray, where=1.0) -> None:
        p.over((1 - smooth(np.abs(away), half * 0.5, half * 1.3)) * where * 0.75, "#dfe8da")

    inside = (gy > 0) & (gy < 68)
    line(gx, inside)
    line(gx - 52.5, inside)
    for y in (0, 68):
        line(gy - y, np.abs(gx) < 52.5)
    line(np.hypot(gx, gy - 34) - 9.15)
    for deep, wide in ((16.5, 20.16), (5.5, 9.16)):
        line(gx - 52.5 + deep, np.abs(gy - 34) < wide)
        for s in (-1, 1):
            line(gy - 34 - s * wide, (gx > 52.5 - deep) & (gx < 52.5))
    line(np.hypot(gx - 41.5, gy - 34) - 9.15, gx < 36)
    boards, stand = at(20, 73)[1], at(20, 73, 1.1)[1]
    panel = np.floor((p.x + 0.03) / 0.23)
    tones = np.array([rgb(t) for t in ("#2c3f66", "#d9dcde", "#7a2f33", "#30323a")])
    p.over(smooth(boards - p.y, 0, 0.004), tones[panel.astype(int) % 4])
    writing = p.noise(60, 1, 0.5) * (np.abs(p.y - (boards + stand) / 2) < (boards - stand) * 0.24)
    p.over((writing > 0.3) * 0.6, rgb("#9aa0a8"))
    crowd = np.zeros((p.h, p.w, 3))
    speck = p.noise(64, 1, 0.8)
    dull = [rgb(t) for t in ("#3d3a40", "#7b6a62", "#8e3a36", "#a8a29c", "#39465e", "#5c4a44")]
    for k, tone in enumerate(dull):
        crowd[np.floor(speck * 2.4).astype(int) % 6 == k] = tone
    rows = 0.75 + 0.25 * np.sin(p.y * 2 * np.pi * 38)
    crowd = blurred(crowd * rows[..., None], 1.0) * (0.45 + 1.6 * p.y / stand * 0.5)[..., None]
    p.over(smooth(stand - p.y, 0, 0.004), crowd)
    p.darken(smooth(stand - p.y, 0.1, 0.2) * 0.5, 0.6)
    men = [(27, 38, "r"), (31, 29, "w"), (36, 44, "w"), (38, 33, "r"), (44, 36, "w"), (41, 24, "r")]
    men += [(14, 30, "r"), (10, 44, "w"), (20, 18, "w"), (22, 52, "r"), (6, 24, "r"), (30, 60, "w")]
    for x, y, side in sorted(men, key=lambda m: -m[1]):
        lean, stride = p.rng.uniform(-0.25, 0.25), p.rng.uniform(0.15, 0.5)
        fx, fy, m = at(x, y)
        p.darken(p.ellipse(fx + 0.75 * m, fy + 0.02 * m, 0.85 * m, 0.16 * m, 0.5), 0.45)
        shirt, short = ("#a83a38", "#e4e2df") if side == "r" else ("#e6e6e2", "#2c3550")
        hip = (fx + lean * 0.2 * m, fy - 0.9 * m)
        for s in (-1, 1):
            knee = (fx + s * stride * 0.6 * m, fy - 0.45 * m)
            p.over(p.limb(hip, knee, 0.15 * m, 0.1 * m), short)
            p.over(p.limb(knee, (fx + s * stride * m, fy), 0.08 * m, 0.06 * m), "#b08a72")
        neck = (hip[0] + lean * 0.5 * m, hip[1] - 0.58 * m)
        lit = 1 - 0.9 * (p.x - hip[0]) / m
        p.over(p.limb(hip, neck, 0.2 * m, 0.25 * m), shirt, np.clip(lit, 0.6, 1.2))
        p.over(
            p.limb(neck, (neck[0] + 0.45 * m, neck[1] + 0.4 * m), 0.09 * m), shirt, 0.75 + 0 * lit
        )
        p.over(p.limb(neck, (neck[0] - 0.4 * m, neck[1] + 0.42 * m), 0.09 * m), shirt)
        p.over(p.ellipse(neck[0], neck[1] - 0.25 * m, 0.13 * m, 0.16 * m, 0.3), "#7a5a48")
    bx, by, m = at(29.2, 35, 0.15)
    p.darken(p.ellipse(bx + 0.2 * m, by + 0.15 * m, 0.28 * m, 0.1 * m, 0.4), 0.4)
    p.over(p.ellipse(bx, by, 0.17 * m, 0.17 * m, 0.2), "#f4f4f2")
    for y in (30.34, 37.66):
        p.over(p.limb(at(52.5, y)[:2], at(52.5, y, 2.44)[:2], 0.004), "#eef0f0")
    p.over(p.limb(at(52.5, 30.34, 2.44)[:2], at(52.5, 37.66, 2.44)[:2], 0.004), "#eef0f0")
    p.blur(0.0035)
    dark, light = (22, 28, 44, 215), (232, 234, 236, 225)
    bars = [((12, 9, 78, 20), dark), ((36, 9, 54, 20), light)]
    words = [("RED", (14, 10, 34, 19), "#e8e8ea"), ("2:1", (38, 10, 52, 19), "#20242c")]
    words.append(("WHI", (56, 10, 76, 19), "#e8e8ea"))
    return _caption(p.image(0.003, 0.1, WHITE, 1.5), bars, words)


def _reef_fish(p: Photo, x: float, y: float, s: float, back: str, belly: str, band: float) -> None:
    """A fish seen from its side, heading right if s > 0; lit from above."""
    k, a = (1 if s > 0 else -1), abs(s)
    tail = [(x - k * 0.8 * a, y), (x - k * 1.5 * a, y - 0.5 * a), (x - k * 1.36 * a, y)]
    tail.append((x - k * 1.5 * a, y + 0.5 * a))
    p.over(p.shape(tail, 0.004) * 0.85, back, 0.8 + 0 * p.x)
    fin = [(x + k * 0.3 * a, y - 0.4 * a), (x - k * 0.5 * a, y - 0.72 * a), (x - k * 0.7 * a, y)]
    p.over(p.shape(fin, 0.004) * 0.8, back, 0.75 + 0 * p.x)
    body = p.ellipse(x, y, a, 0.48 * a, 0.07)
    t = smooth((p.y - y) / a, -0.3, 0.4)[..., None]
    lit = 0.5 + 0.65 * p.ball(x, y, a * 1.1, 0.55 * a, (0.1 * k, -0.8, 0.6))
    scales = 1 + 0.05 * p.noise(60, 2)
    tone = (rgb(back) * (1 - t) + rgb(belly) * t) * (lit * scales)[..., None]
    p.over(body, tone)
    for d in (-0.35, 0.25):
        stripe = np.exp(-((((p.x - x) * k - d * a) / (0.11 * a) + 0.6 * (p.y - y) / a) ** 2))
        p.over(body * stripe * band, "#e8e4d6", lit)
    p.over(p.ellipse(x + k * 0.66 * a, y - 0.1 * a, 0.07 * a, 0.07 * a, 0.4) * 0.9, "#15181c")
    p.darken(
        body * p.limb((x + k * 0.4 * a, y - 0.3 * a), (x + k * 0.42 * a, y + 0.3 * a), 0.02 * a),
        0.25,
    )


def _fish(w: int, h: int) -> Image.Image:
    """A coral reef: light from above, blue distance, two fish and a shoal."""
    p = Photo(w, h, 11)
    p.c = p.gradient((0, "#7cc0cf"), (0.3, "#3a8fb4"), (0.75, "#1c5c86"), (1, "#174a6c"))
    slant = np.sin(34 * (p.x + 0.45 * p.y) / (1 + 0.5 * p.y)) + np.sin(21 * (p.x + 0.5 * p.y) + 2)
    rays = smooth(slant + 0.4 * p.noise(3, 2), 0.2, 2.0) * np.clip(0.9 - p.y, 0, 1) ** 1.5
    p.glow(rays * 0.35, "#d8f2ee")
    p.glow(p.ellipse(0.7 * p.wide, -0.1, 0.7, 0.4, 0.95) * 0.55, "#e2f6f0")
    mountains(p, p.ridge(0.68, 0.08, 5), "#4a7a88", "#3580a2", 0.72, 1.1)
    mountains(p, p.ridge(0.78, 0.1, 5), "#6a7f7a", "#2f7494", 0.45, 1.3)
    for _ in range(46):
        x, y = p.rng.normal(0.45 * p.wide, 0.22 * p.wide), p.rng.normal(0.36, 0.09)
        a = p.rng.uniform(0.012, 0.022)
        p.over(p.ellipse(x, y, a, 0.4 * a, 0.4) * 0.6, "#a9c8cc")
        p.over(p.ellipse(x - 1.15 * a, y, 0.35 * a, 0.35 * a, 0.5) * 0.5, "#8fb6be")
    p.blur(0.006)
    floor = p.ridge(0.88, 0.05, 4)
    sand = np.clip(0.8 + 0.1 * p.noise(20, 4, 3), 0.4, 1.3)
    p.over(p.under(floor, 0.01), "#7d8a78", sand)
    corals = ["#a8735a", "#8c6a7e", "#a08a58", "#7a5a52", "#6f8a6c", "#b58a78", "#8a4f52"]
    bumps = [np.clip(1 + 0.28 * p.noise(70, 3, 1.0, 0.7), 0.3, 1.7) for _ in range(3)]
    for k in range(54):
        x = p.rng.uniform(-0.05, p.wide + 0.05)
        edge = abs(x / p.wide - 0.5) * 2
        y = p.rng.uniform(0.98 - 0.34 * edge**1.6, 1.02)
        r = p.rng.uniform(0.035, 0.09)
        mask = p.ellipse(x, y, r, r * p.rng.uniform(0.7, 1.2), 0.12)
        lit = 0.28 + 0.85 * p.ball(x, y, r * 1.15, r * 1.2, (0.15, -0.85, 0.5))
        p.over(mask, corals[int(p.rng.integers(len(corals)))], lit * bumps[k % 3])
    for x, lean in ((0.16, -0.3), (0.22, 0.1), (1.5, 0.3), (1.62, -0.1)):
        for _ in range(9):
            a = lean + p.rng.normal(0, 0.35)
            q = (x + 0.24 * np.sin(a), 0.86 - 0.3 * np.cos(a) * p.rng.uniform(0.6, 1))
            p.over(p.limb((x, 0.92), q, 0.013, 0.006, 0.006), "#9a6b78", np.clip(1.5 - p.y, 0, 1))
    p.over(0.12 + 0 * p.x, "#3a86a8")
    _reef_fish(p, 0.98, 0.5, 0.16, "#b8682e", "#dfae62", 0.85)
    _reef_fish(p, 0.52, 0.3, -0.085, "#8c8a3a", "#d6cf86", 0.0)
    _reef_fish(p, 1.38, 0.27, 0.07, "#3f5f9a", "#a9b9c8", 0.35)
    p.glow(smooth(p.noise(46, 1), 2.4, 3.2) * 0.5, "#cfe6ea")
    p.blur(0.003)
    return p.image(0.002, 0.25, WHITE, 1.35)


def _studio(p: Photo, cool: str = "#3f5f86") -> None:
    """A studio out of focus: panels, a wall of screens, lights."""
    p.c = p.gradient((0, "#22304a"), (0.5, cool), (1, "#1a2438"))
    panel = smooth(np.sin(p.x * 15 + 1.2), 0.0, 0.5) * 0.4
    p.over(panel, "#8fa4bd")
    wall = p.shape([(0.95, 0.1), (1.74, 0.04), (1.74, 0.66), (0.95, 0.6)], 0.012)
    land = smooth(p.noise(5, 4), 0.1, 0.5)
    tone = rgb("#3a6fa6") * (1 - 0.5 * land[..., None]) + 0.5 * land[..., None] * rgb("#b9c9b4")
    p.over(wall, tone * (0.9 + 0.3 * p.ellipse(1.35, 0.3, 0.5, 0.4, 0.9))[..., None])
    p.over(p.limb((0, 0.7), (p.wide, 0.66), 0.02, None, 0.03) * 0.6, "#a8bdd4")
    p.bokeh(26, (0, 0, p.wide, 0.3), (0.02, 0.045), ["#dfe8f4", "#9ec2ee", "#f2d9b0"], 0.4)
    p.blur(0.022)


def _news(w: int, h: int) -> Image.Image:
    """A presenter at the desk of a studio."""
    p = Photo(w, h, 7)
    _studio(p)
    bust(p, 0.6, 0.5, 0.33, "#cf9f80", "#32241b", "#2a3140", "suit")
    desk = 0.86 + 0.05 * ((np.arange(p.w) / p.w - 0.4) ** 2) * 4
    p.over(p.under(desk, 0.006), "#39465c", 1.25 - 1.6 * (p.y - 0.84) + 0.04 * p.noise(4, 3, 6))
    p.glow(np.exp(-(((p.y - desk[None, :] - 0.008) / 0.008) ** 2)) * 0.6, "#cfe0f2")
    p.over(p.limb((0.42, 0.875), (0.62, 0.882), 0.012, None, 0.01), "#c8ccd0")
    p.blur(0.0035)
    bars = [((16, 110, 240, 125), (226, 230, 236, 218)), ((16, 110, 54, 125), (132, 38, 46, 235))]
    bars.append(((16, 126, 180, 134), (24, 34, 56, 200)))
    words = [("NEWS", (20, 112, 50, 123), "#f0f0f0")]
    words.append(("SUN AFTER RAIN", (60, 112, 200, 123), "#1e2a44"))
    words.append(("warm weekend ahead", (22, 127, 130, 133), "#c8d0dc"))
    return _caption(p.image(0.002, 0.15, WHITE, 1.5), bars, words)


def _weather(w: int, h: int) -> Image.Image:
    """The forecast: land in relief, clouds, lines of equal pressure, who explains it."""
    p = Photo(w, h, 21)
    land = 0.55 * p.noise(2.4, 7, 1, 0.55) - 3.0 * np.hypot((p.x - 0.62) / 1.5, (p.y - 0.48) / 1.1)
    height = land + 1.35
    sea = rgb("#2c5878") + np.clip(height * 0.12, -0.12, 0)[..., None] * np.ones(3)
    hill = 14 * (height - np.roll(np.roll(height, 2, 0), 2, 1)) / 4
    stops = [0, 0.25, 0.6, 1.1, 1.7]
    tones = np.array([rgb(t) for t in ("#8a9a62", "#6f8a52", "#94925f", "#a3835f", "#d8d4cc")])
    ground = np.stack([np.interp(height, stops, tones[:, k]) for k in range(3)], -1)
    p.c = sea
    p.over(smooth(height, -0.12, 0.02) * 0.35, "#5f93a8")
    p.over(smooth(height, 0.0, 0.03), ground, np.clip(0.92 + hill, 0.45, 1.4))
    cloud = smooth(p.noise(2.6, 6, 1.6, 0.6), 0.7, 2.0)
    p.darken(np.roll(cloud, (10, 8), (0, 1)), 0.3)
    p.over(cloud * 0.8, "#e9edf0")
    swell = (p.x - 1.3) ** 2 * 2.2 + (p.y - 0.1) ** 2 * 3 + 0.12 * p.noise(1.5, 2)
    steep = np.hypot(*np.gradient(swell)) * p.h
    level = swell / 0.45
    away = np.abs(level - np.round(level)) * 0.45 / np.maximum(steep, 0.05)
    p.over((1 - smooth(away, 0.002, 0.006)) * 0.6, "#eef2f4")
    p.blur(0.003)
    bust(p, 1.5, 0.5, 0.27, "#c99a7c", "#4a3020", "#5c3346", "jumper", True)
    p.over(
        p.limb((1.27, 0.68), (1.2, 0.88), 0.062, 0.05, 0.008), "#5c3346", 1.0 - 2.5 * (p.x - 1.24)
    )
    lit = 1.0 + 2.0 * (0.74 - p.y) - 1.5 * (p.x - 1.12)
    p.over(p.limb((1.2, 0.88), (1.07, 0.66), 0.05, 0.032, 0.008), "#66394e", lit)
    p.over(p.limb((1.07, 0.655), (1.035, 0.6), 0.026, 0.03, 0.006), "#c99a7c", 0.95 + 0 * p.x)
    p.over(p.limb((1.035, 0.6), (0.99, 0.575), 0.016, 0.01, 0.005), "#c99a7c")
    p.blur(0.002)
    bars = [((12, 8, 98, 21), (28, 44, 72, 205))]
    words = [("TOMORROW", (18, 10, 92, 19), "#e6ebf2")]
    for k, (x, y) in enumerate(((66, 46), (96, 74), (58, 92), (120, 104))):
        bars.append(((x - 7, y - 6, x + 8, y + 6), (222, 178, 84, 225)))
        words.append((("19", "21", "23", "18")[k], (x - 5, y - 5, x + 6, y + 5), "#2a2418"))
    return _caption(p.image(0.002, 0.1, WHITE, 1.35), bars, words)


def _lake(w: int, h: int) -> Image.Image:
    return lake(w, h, 5).image(0.003, 0.2, WHITE)


def _sunset(w: int, h: int) -> Image.Image:
    """A sailing boat before the setting sun."""
    p = Photo(w, h, 4)
    shore, sun = 0.6, 1.12
    p.c = p.gradient((0, "#48618e"), (0.3, "#9a8aa0"), (0.5, "#e0a878"), (0.6, "#f0c48c"))
    p.glow(p.ellipse(sun, 0.52, 0.9, 0.5, 0.98) * 0.6, "#ffb870")
    strata = p.noise(4.5, 6, 5.0, 0.6)
    cloud = smooth(strata + 1.2 * np.sin(p.y * 9), 0.3, 2.2)
    edge = smooth(cloud - np.roll(cloud, -6, 0), 0.02, 0.3)
    tone = np.stack(
        [np.interp(p.y, [0, 0.55], v) for v in ((0.45, 0.68), (0.42, 0.46), (0.52, 0.44))], -1
    )
    p.over(cloud * 0.75, tone)
    p.glow(edge * np.clip(1 - np.abs(p.x - sun), 0, 1) * 0.7, "#ffcf9a")
    p.over(p.ellipse(sun, 0.5, 0.055, 0.055, 0.06), "#fff2cf")
    p.glow(np.exp(-np.hypot(p.x - sun, p.y - 0.5) / 0.12) * 0.9, "#ffdca0")
    mountains(
        p, p.ridge(0.565, 0.035, 5) + 0.2 * smooth(p.x[0], 0.5, 1.0), "#5a5468", "#b08a86", 0.4, 0.7
    )
    deep = np.clip((p.y - shore) / (1 - shore), 0, 1)
    water = p.gradient((shore, "#c89a86"), (0.7, "#7d7a92"), (1, "#33486a"))
    wave = sum(
        p.noise(c, 3, 9.0) * np.exp(-(((deep - d) / 0.32) ** 2))
        for c, d in ((70, 0.0), (42, 0.35), (26, 0.7), (16, 1.05))
    )
    p.over(smooth(p.y, shore - 0.002, shore + 0.002), water * (1 + 0.1 * wave)[..., None])
    path = np.exp(-(((p.x - sun) / (0.035 + 0.16 * deep)) ** 2)) * (p.y > shore)
    p.glow(path * smooth(wave, 0.1 - 0.8 * (1 - deep), 1.4) * (0.95 - 0.4 * deep), "#ffdca8")
    x, y = 0.56, 0.66
    hull = [(x - 0.15, y), (x + 0.14, y - 0.006), (x + 0.1, y + 0.034), (x - 0.11, y + 0.034)]
    p.over(p.shape(hull), "#4a3836", 1.0 - 6 * (p.y - y))
    p.over(p.limb((x - 0.01, y), (x - 0.01, 0.2), 0.0035, 0.0025), "#3d3230")
    for sail, k in (
        ([(x - 0.002, 0.22), (x - 0.002, 0.63), (x + 0.15, 0.635), (x + 0.06, 0.42)], 1.0),
        ([(x - 0.018, 0.26), (x - 0.02, 0.62), (x - 0.13, 0.63), (x - 0.07, 0.46)], 0.86),
    ):
        lit = k * (0.82 + 1.1 * np.abs(p.x - x) + 0.03 * p.noise(12, 2, 0.3))
        p.over(p.shape(sail, 0.002), "#e2cdb8", np.clip(lit, 0.5, 1.1))
    soft = 0.5 * (1 + np.sin(p.y * 260 + wave * 2))
    p.darken(
        p.shape([(x - 0.12, 0.697), (x + 0.12, 0.697), (x + 0.03, 0.9), (x - 0.05, 0.9)], 0.012)
        * soft,
        0.4,
    )
    p.blur(0.003)
    return p.image(0.003, 0.25, WHITE)


def _cooking(w: int, h: int) -> Image.Image:
    """A plate of pasta on a wooden table, the kitchen and the cook out of focus."""
    p = Photo(w, h, 9)
    p.c = p.gradient((0, "#8a7a68"), (0.4, "#b8a48a"), (0.62, "#7a5f48"))
    for x0, x1, y0, y1, tone in (
        (0.0, 0.5, 0.0, 0.22, "#d8cbb6"),
        (1.2, 1.8, 0.02, 0.5, "#5d6a68"),
        (0.06, 0.16, 0.3, 0.5, "#7c8f5a"),
        (0.2, 0.3, 0.34, 0.5, "#a85f42"),
    ):
        p.over(p.shape([(x0, y0), (x1, y0), (x1, y1), (x0, y1)]), tone)
    bust(p, 0.92, 0.24, 0.26, "#c79878", "#40302a", "#e4e2dc", "jumper", False, (0.5, -0.5, 0.7))
    p.bokeh(16, (0, 0, p.wide, 0.35), (0.02, 0.045), ["#ffe0a8", "#fff2d8", "#f4c890"], 0.5)
    p.blur(0.024)
    board = smooth(p.y, 0.56, 0.6)
    grain = p.noise(20, 5, 9.0)
    p.over(board, "#8f6642", np.clip(0.85 + 0.1 * grain + 0.35 * (p.y - 0.6), 0.4, 1.4))
    p.c = (
        blurred(p.c, 2.0) * (1 - smooth(p.y, 0.6, 0.8))[..., None]
        + p.c * smooth(p.y, 0.6, 0.8)[..., None]
    )
    cx, cy = 0.9, 0.76
    p.darken(p.ellipse(cx + 0.05, cy + 0.05, 0.58, 0.22, 0.35), 0.55)
    p.over(p.ellipse(cx, cy + 0.015, 0.53, 0.195, 0.02), "#b3aea4")
    rim = 1.0 - 0.25 * (p.x - cx) + 0.5 * (cy - p.y) * 0.4
    p.over(p.ellipse(cx, cy, 0.53, 0.185, 0.02), "#e6e2d9", np.clip(rim, 0.7, 1.1))
    p.darken(p.ellipse(cx, cy + 0.002, 0.39, 0.125, 0.12), 0.2)
    strands = Image.new("RGBA", (p.w, p.h), (0, 0, 0, 0))
    draw = ImageDraw.Draw(strands)
    for k in range(420):
        t = k / 420
        a, r = p.rng.uniform(0, 2 * np.pi), np.sqrt(p.rng.uniform(0, 1)) * (1 - 0.75 * t)
        x, y = cx + 0.32 * r * np.cos(a), cy - 0.16 * t * (1 - r * r) + 0.1 * r * np.sin(a)
        rx, ry = p.rng.uniform(0.04, 0.11), p.rng.uniform(0.015, 0.05)
        start = p.rng.uniform(0, 360)
        box = [(x - rx) * p.h, (y - ry) * p.h, (x + rx) * p.h, (y + ry) * p.h]
        lit = np.clip(0.62 + 0.4 * t - 0.35 * (x - cx) + p.rng.normal(0, 0.07), 0.4, 1.1)
        tone = tuple(int(255 * c * lit) for c in rgb("#e3bf7a"))
        low = [box[0], box[1] + 2, box[2], box[3] + 2]
        end = start + p.rng.uniform(90, 200)
        draw.arc(low, start, end, fill=(96, 60, 24, 255), width=4)
        draw.arc(box, start, end, fill=(*tone, 255), width=3)
    pasta = np.asarray(strands, float) / 255
    p.over(blurred(pasta[..., 3], 0.7), blurred(pasta[..., :3], 0.5))
    lump = p.ellipse(cx, cy - 0.12, 0.15, 0.065, 0.3) + 0.12 * p.noise(24, 3)
    sauce = smooth(lump, 0.4, 0.6)
    rough = p.noise(26, 4)
    lit = 0.75 + 0.9 * (np.roll(rough, -3, 0) - rough) / 3 + 0.2 * p.ball(cx, cy - 0.1, 0.2, 0.1)
    p.darken(np.roll(sauce, 5, 0), 0.3)
    p.over(sauce, "#9c3a22", np.clip(lit, 0.35, 1.4))
    p.glow(sauce * smooth(rough - np.roll(rough, 3, 0), 0.5, 1.2) * 0.5, "#ffe4d0")
    for x, y, turn in ((0.87, 0.6, 0.5), (0.93, 0.59, -0.4), (0.9, 0.625, 0.1)):
        leaf = p.ellipse(x, y, 0.045, 0.02, 0.15, turn)
        p.over(leaf, "#4d6e36", 0.55 + 0.7 * p.ball(x - 0.01, y - 0.01, 0.05, 0.03))
    steam = smooth(p.noise(4, 4, 0.45), 0.2, 2.2) * p.ellipse(0.9, 0.38, 0.22, 0.3, 0.9)
    p.glow(steam * 0.3, "#f4f0ea")
    p.blur(0.002)
    return p.image(0.002, 0.25, WHITE, 1.35)


def _western(w: int, h: int) -> Image.Image:
    """An old film: a rider before table mountains, in grey."""
    p = Photo(w, h, 6)
    p.c = p.gradient((0, "#8d8d8d"), (0.55, "#d6d6d6"))
    p.over(smooth(p.noise(3, 6, 2.4, 0.6), 0.2, 1.9) * 0.7, "#ececec")
    at = np.arange(p.w) / p.h
    for tops, tone, fog in (
        (((0.1, 0.5, 0.34), (1.2, 1.5, 0.4)), "#8a8a8a", 0.55),
        (((1.02, 1.42, 0.22), (1.5, 1.6, 0.28), (-0.2, 0.2, 0.3)), "#6f6f6f", 0.22),
    ):
        line = p.ridge(0.66, 0.012, 9)
        for a, b, top in tops:
            up = smooth(at, a - 0.05, a) * (1 - smooth(at, b, b + 0.05))
            line = line - (line - top - 0.01 * p.ridge(0, 1, 12)) * up
        mountains(p, line, tone, "#cccccc", fog, 0.75)
        strata = smooth(np.sin(p.y * 95 + 0.6 * p.noise(5, 3, 4)), 0.2, 0.9)
        p.darken(p.under(line) * smooth(0.62 - p.y, 0, 0.02) * strata, 0.12)
    plain_ = p.ridge(0.68, 0.01, 4)
    sand = 0.8 + 0.08 * p.noise(24, 5, 4) - 0.3 * (p.y - 0.7)
    p.over(p.under(plain_, 0.004), "#a8a8a8", np.clip(sand, 0.2, 1.2))
    for _ in range(240):
        y = 0.7 + 0.32 * p.rng.uniform(0, 1) ** 1.4
        x, r = p.rng.uniform(0, p.wide), 0.05 * (y - 0.62) * p.rng.uniform(0.3, 1.1)
        p.darken(p.ellipse(x + r, y + 0.3 * r, 1.4 * r, 0.4 * r, 0.6), 0.3)
        p.over(p.ellipse(x, y, r, 0.7 * r, 0.5) * 0.85, "#4e4e4e", 1.0 - 4 * (p.y - y + 0.3 * r))
    x, y = 0.74, 0.66
    p.darken(p.ellipse(x + 0.1, 0.875, 0.26, 0.022, 0.5), 0.5)
    coat, dark = "#4a4644", "#38383a"
    p.blur(0.003)
    shade = np.clip(1.25 - 4.5 * (p.y - y + 0.06), 0.45, 1.6)
    for fx, kx in ((-0.13, -0.1), (-0.09, -0.12), (0.1, 0.13), (0.15, 0.12)):
        knee = (x + kx, y + 0.115)
        p.over(p.limb((x + kx * 0.85, y + 0.03), knee, 0.032, 0.015), coat, shade)
        p.over(p.limb(knee, (x + fx, y + 0.21), 0.014, 0.011), coat, 0.7 * shade)
    p.over(p.ellipse(x, y, 0.175, 0.068, 0.06), coat, shade)
    p.over(p.ellipse(x - 0.1, y - 0.005, 0.085, 0.07, 0.08), coat, shade)
    p.over(p.limb((x + 0.12, y - 0.01), (x + 0.24, y - 0.13), 0.055, 0.032), coat, shade + 0.1)
    p.over(p.limb((x + 0.235, y - 0.135), (x + 0.32, y - 0.075), 0.034, 0.018), coat, shade)
    p.over(p.limb((x - 0.17, y - 0.01), (x - 0.22, y + 0.12), 0.02, 0.012), dark)
    p.over(p.limb((x + 0.0, y - 0.05), (x + 0.06, y + 0.08), 0.032, 0.022), "#5a5a5c", shade)
    lit = np.clip(1.0 - 5 * (p.x - x), 0.5, 1.5)
    p.over(p.limb((x, y - 0.07), (x + 0.01, y - 0.19), 0.05, 0.058), "#77777a", lit)
    p.over(p.limb((x + 0.02, y - 0.19), (x + 0.1, y - 0.1), 0.022, 0.016), "#6a6a6c", lit)
    p.over(p.ellipse(x + 0.015, y - 0.27, 0.03, 0.038, 0.2), "#b0aeac", lit)
    p.over(p.ellipse(x + 0.015, y - 0.295, 0.075, 0.014, 0.2), "#3c3c3c", lit)
    p.over(p.limb((x + 0.013, y - 0.3), (x + 0.013, y - 0.325), 0.032, 0.028), "#444444", lit)
    dust = smooth(p.noise(5, 4, 2), 0, 2) * p.ellipse(x - 0.25, 0.85, 0.35, 0.08, 0.9)
    p.over(dust * 0.6, "#c8c8c8")
    p.blur(0.004)
    p.c = p.c.mean(axis=2)[..., None] * np.array([1.02, 1.0, 0.95])
    return p.image(0.007, 0.5, WHITE)


PROGRAMMES: dict[str, Callable[[int, int], Image.Image]] = {
    "football": _football,
    "fish": _fish,
    "news": _news,
    "weather": _weather,
    "lake": _lake,
    "sunset": _sunset,
    "cooking": _cooking,
    "western": _western,
}


def programme(kind: str, width: int = 256, height: int = 144) -> Image.Image:
    """A frame of a television programme by name (see PROGRAMMES)."""
    return PROGRAMMES[kind](width, height)
