"""Pictures like photographs, made of noise, light and blur: for screens and for photos in frames.

Lengths are shares of the picture's height, y grows downwards; masks are (h, w), 0 to 1.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from PIL import Image, ImageColor, ImageDraw

Point = tuple[float, float]
LIGHT = (-0.5, -0.55, 0.67)  # from the upper left, before the picture


def rgb(colour) -> np.ndarray:
    """A colour name as three numbers; arrays pass."""
    if isinstance(colour, str):
        return np.array(ImageColor.getrgb(colour)[:3]) / 255
    return np.asarray(colour, float)


def smooth(x: np.ndarray, low: float, high: float) -> np.ndarray:
    """0 below `low`, 1 above `high`, a soft step between."""
    t = np.clip((x - low) / (high - low), 0, 1)
    return t * t * (3 - 2 * t)


def blurred(field: np.ndarray, sigma: float) -> np.ndarray:
    """Gaussian blur by `sigma` pixels of a (h, w) or (h, w, 3) array."""
    if sigma < 0.2:
        return field
    reach = int(3 * sigma) + 1
    kernel = np.exp(-0.5 * (np.arange(-reach, reach + 1) / sigma) ** 2)
    kernel /= kernel.sum()
    for axis in (0, 1):
        pad = [(0, 0)] * field.ndim
        pad[axis] = (reach, reach)
        wide = np.pad(field, pad, mode="edge")
        field = np.apply_along_axis(np.convolve, axis, wide, kernel, "valid")
    return field


class Photo:
    """A picture that grows from back to front."""

    def __init__(self, width: int, height: int, seed: int = 0, fine: int = 2) -> None:
        self.size = (width, height)
        self.w, self.h = width * fine, height * fine
        self.rng = np.random.default_rng(seed)
        y, x = np.mgrid[0 : self.h, 0 : self.w]
        self.x, self.y = (x + 0.5) / self.h, (y + 0.5) / self.h
        self.wide = self.w / self.h
        self.c = np.zeros((self.h, self.w, 3))

    # ---- fields
    def noise(self, cells: float, octaves: int = 5, stretch: float = 1.0, fade: float = 0.55):
        """Fractal noise, mean 0, deviation 1; `cells` a height, `stretch` times as long in x."""
        total, weight = np.zeros((self.h, self.w)), 1.0
        for _ in range(octaves):
            rows = max(2, round(cells) + 1)
            columns = max(2, round(cells * self.wide / stretch) + 1)
            if rows > self.h:
                break
            grid = Image.fromarray(self.rng.normal(size=(rows, columns)).astype(np.float32))
            total += weight * np.asarray(grid.resize((self.w, self.h), Image.Resampling.BICUBIC))
            cells, weight = cells * 2, weight * fade
        return (total - total.mean()) / (total.std() + 1e-9)

    def ridge(self, base: float, rise: float, bumps: float, fade: float = 0.5, octaves: int = 7):
        """The y of a fractal skyline for each column."""
        total, weight = np.zeros(self.w), 1.0
        at = np.linspace(0, 1, self.w)
        for _ in range(octaves):
            n = max(2, round(bumps) + 1)
            knots = self.rng.uniform(-1, 1, n)
            total += weight * np.interp(at, np.linspace(0, 1, n), knots)
            bumps, weight = bumps * 2.1, weight * fade
        return base - rise * total

    def gradient(self, *stops: tuple[float, str]) -> np.ndarray:
        """Colours down the picture: (y, colour)."""
        ys, tones = [s[0] for s in stops], np.array([rgb(s[1]) for s in stops])
        return np.stack([np.interp(self.y, ys, tones[:, k]) for k in range(3)], -1)

    # ---- masks
    def ellipse(self, x: float, y: float, rx: float, ry: float, soft: float = 0.1, turn=0.0):
        c, s = np.cos(turn), np.sin(turn)
        dx, dy = self.x - x, self.y - y
        d = np.hypot((c * dx + s * dy) / rx, (c * dy - s * dx) / ry)
        return 1 - smooth(d, 1 - soft, 1 + soft)

    def limb(self, p: Point, q: Point, r0: float, r1: float | None = None, soft: float = 0.004):
        """A rod from p to q, its radius going from r0 to r1."""
        a, d = np.asarray(p), np.subtract(q, p)
        t = ((self.x - a[0]) * d[0] + (self.y - a[1]) * d[1]) / (d @ d + 1e-12)
        t = np.clip(t, 0, 1)
        away = np.hypot(self.x - a[0] - t * d[0], self.y - a[1] - t * d[1])
        radius = r0 + ((r0 if r1 is None else r1) - r0) * t
        return 1 - smooth(away - radius, -soft, soft)

    def shape(self, points: Sequence[Point], soft: float = 0.003) -> np.ndarray:
        image = Image.new("L", (self.w, self.h))
        ImageDraw.Draw(image).polygon([(x * self.h, y * self.h) for x, y in points], fill=255)
        return blurred(np.asarray(image, float) / 255, soft * self.h)

    def under(self, line: np.ndarray, soft: float = 0.003) -> np.ndarray:
        """Everything below a skyline."""
        return smooth(self.y - line[None, :], -soft, soft)

    def ball(self, x: float, y: float, rx: float, ry: float, light=LIGHT) -> np.ndarray:
        """How brightly an egg is lit, 0 to 1."""
        a, b = (self.x - x) / rx, (self.y - y) / ry
        z = np.sqrt(np.clip(1 - a * a - b * b, 0, 1))
        long = np.maximum(np.sqrt(a * a + b * b + z * z), 1e-6)
        return np.clip((a * light[0] + b * light[1] + z * light[2]) / long, 0, 1)

    # ---- painting
    def over(self, mask, colour, shade=None) -> None:
        """Lay a colour over the picture; `shade` (h, w) makes it darker or lighter."""
        tone = np.broadcast_to(rgb(colour), self.c.shape)
        if shade is not None:
            tone = tone * np.asarray(shade)[..., None]
        m = np.broadcast_to(np.asarray(mask, float), (self.h, self.w))[..., None]
        self.c = self.c * (1 - m) + tone * m

    def glow(self, mask, colour) -> None:
        """Add light."""
        m = np.clip(np.asarray(mask, float), 0, 1)[..., None] * rgb(colour)
        self.c = 1 - (1 - np.clip(self.c, 0, 1)) * (1 - np.clip(m, 0, 1))

    def darken(self, mask, amount: float) -> None:
        self.c = self.c * (1 - amount * np.asarray(mask))[..., None]

    def blur(self, radius: float) -> None:
        self.c = blurred(self.c, radius * self.h)

    def bokeh(self, count: int, box: tuple, size: tuple, colours: Sequence[str], strength=0.5):
        """Lights out of focus within box (x0, y0, x1, y1)."""
        for _ in range(count):
            x, y = self.rng.uniform(box[0], box[2]), self.rng.uniform(box[1], box[3])
            r = self.rng.uniform(*size)
            tone = colours[int(self.rng.integers(len(colours)))]
            self.glow(self.ellipse(x, y, r, r, 0.2) * strength * self.rng.uniform(0.4, 1), tone)

    def image(self, grain: float = 0.006, vignette: float = 0.12, top: float = 1.0, gain=1.15):
        """The finished picture; `top` is how bright white comes out, `gain` the exposure."""
        c = 1 - (1 - np.clip(self.c, 0, 1)) ** gain
        c = c + grain * self.noise(self.h / 2.5, 1)[..., None]
        away = (self.x / self.wide - 0.5) ** 2 + (self.y - 0.5) ** 2
        c = np.clip(c * (1 - 2 * vignette * away)[..., None], 0, 1)
        c = c + 0.12 * (smooth(c, 0, 1) - c)
        picture = Image.fromarray((255 * top * np.clip(c, 0, 1)).astype(np.uint8))
        return picture.resize(self.size, Image.Resampling.BOX)


# ---- landscape
def mountains(
    p: Photo, line: np.ndarray, rock: str, haze: str, fog: float, foot: float, snow: float = 0.0
) -> None:
    """A range below a skyline: lit and shaded slopes, snow, haze that thickens to its foot."""
    rough = p.noise(6, 6, 0.7, 0.6)
    slope = np.gradient(-line) * 0.9
    slope = np.convolve(slope, np.ones(9) / 9, "same")
    lit = 0.62 + 2.4 * (np.roll(rough, -3, 1) - rough) / 3 + 0.16 * slope[None, :]
    depth = (p.y - line[None, :]) / max(foot - line.min(), 1e-3)
    tone = np.clip(lit, 0.25, 1.25)[..., None] * rgb(rock)
    if snow:
        white = smooth(snow - depth + 0.12 * rough, 0, 0.14)[..., None]
        tone = tone * (1 - white) + white * (
            rgb("#dfe8f2") * np.clip(0.25 + 0.9 * lit, 0.4, 1.05)[..., None]
        )
    veil = np.clip(fog + (1 - fog) * 0.55 * smooth(depth, 0.1, 1.1), 0, 1)[..., None]
    p.over(p.under(line, 0.004), tone * (1 - veil) + rgb(haze) * veil)


def conifers(p: Photo, base: float, rise: float, tone: str, count: int, tall: float) -> None:
    """A wood along a shore, pointed crowns against what is behind."""
    line = p.ridge(base, rise, 3, 0.5, 3)
    top = line.copy()
    at = np.arange(p.w) / p.h
    for _ in range(count):
        x, high = p.rng.uniform(0, p.wide), tall * p.rng.uniform(0.35, 1)
        k = min(p.w - 1, int(x * p.h))
        top = np.minimum(top, line[k] - high + np.abs(at - x) * 4.2)
    top = top[None, :] + min(0.012, 0.12 * tall) * p.noise(60, 3)
    leaf = 0.85 + 0.3 * p.noise(40, 3, 0.6) + 1.2 * np.clip(0.12 - (p.y - top), 0, 0.12)
    p.over(smooth(p.y - top, -0.004, 0.006), tone, np.clip(leaf, 0.3, 1.9))


def mirrored(p: Photo, shore: float, tint: str, amount: float) -> None:
    """Everything below `shore` becomes water that shows what is above it."""
    below = p.y > shore
    deep = np.clip((p.y - shore) / (1 - shore), 0, 1)
    wave = p.noise(26, 4, 9.0)
    source = shore - (p.y - shore) * 1.02 + (0.003 + 0.016 * deep) * wave
    rows = np.clip((source * p.h).astype(int), 0, p.h - 1)
    shift = (0.006 * deep * p.noise(30, 2, 5.0) * p.h).astype(int)
    columns = np.clip(np.arange(p.w)[None, :] + shift, 0, p.w - 1)
    seen = p.c[rows, columns]
    part = amount * (0.45 + 0.55 * deep) + 0.05 * wave * deep
    water = seen * 0.9 * (1 - part[..., None]) + rgb(tint) * part[..., None]
    p.over(below * 1.0, water)
    p.glow(np.exp(-(((p.y - shore) / 0.006) ** 2)) * 0.25, "#e8f0f4")


def lake(width: int, height: int, seed: int = 0) -> Photo:
    """A lake in the mountains in the morning."""
    p = Photo(width, height, seed)
    p.c = p.gradient((0, "#5f8fc2"), (0.35, "#a9c6dd"), (0.62, "#f0e3cf"))
    cloud = smooth(p.noise(3, 6, 3.0) - 2.2 * p.y, -0.1, 1.6)
    p.over(cloud * 0.75, "#f6efe8")
    shore = 0.62
    p.glow(p.ellipse(0.2 * p.wide, 0.42, 0.7, 0.5, 0.95) * 0.5, "#ffd9a8")
    far = p.ridge(0.42, 0.09, 3.4)
    mountains(p, far, "#8494a8", "#c6d3df", 0.55, shore, 0.2)
    at = np.arange(p.w) / p.w
    peak = p.ridge(0.42, 0.05, 6) - 0.27 * np.exp(-(((at - 0.62) / 0.17) ** 2))
    mountains(p, peak, "#75777d", "#b8c6d2", 0.16, shore, 0.3)
    near = p.ridge(0.5, 0.04, 4) - 0.14 * smooth(np.abs(at - 0.42), 0.22, 0.55)
    mountains(p, near, "#5d6b58", "#a8b8bf", 0.12, shore)
    p.glow(np.exp(-(((p.y - shore + 0.02) / 0.035) ** 2)) * 0.35, "#e6e9e8")
    conifers(p, 0.615, 0.006, "#3a4c3e", 90, 0.075)
    mirrored(p, shore, "#2f4d60", 0.4)
    conifers(p, 1.02, 0.05, "#26331f", 50, 0.17)
    p.glow(p.ellipse(0.2 * p.wide, 0.2, 1.0, 0.9, 0.95) * 0.16, "#ffe2b8")
    return p


# ---- people
def bust(
    p: Photo,
    x: float,
    chin: float,
    s: float,
    skin: str = "#d9a986",
    hair: str = "#3a281c",
    cloth: str = "#2b3442",
    wear: str = "jumper",
    long: bool = False,
    light=LIGHT,
) -> None:
    """Head and shoulders, softly lit; s is the height of the head, wear "suit" or "jumper"."""
    y = chin - 0.5 * s
    side = 1 if light[0] < 0 else -1  # where the shade is
    dx, dy = (p.x - x) / s, (p.y - chin) / s
    strand = p.noise(9 / s, 3, 0.4)
    curl = np.clip(0.9 + 0.14 * strand, 0.5, 1.4) * (0.55 + 0.75 * p.ball(x, y, 0.6 * s, 0.7 * s))
    if long:
        back = np.maximum(
            p.ellipse(x, y + 0.02 * s, 0.47 * s, 0.58 * s, 0.08),
            p.limb((x, y + 0.1 * s), (x, chin + 0.22 * s), 0.44 * s, 0.4 * s, 0.05 * s),
        )
        p.over(back, hair, curl * 0.8)
    d = (np.abs(dx) / 1.02) ** 3 + (np.abs(dy - 1.8) / 1.62) ** 3
    body = np.maximum(1 - smooth(d, 0.95, 1.04), p.ellipse(x, chin + 0.55 * s, 0.62 * s, 0.52 * s))
    body *= smooth(dy, -0.06, 0.06)
    fold = 0.05 * p.noise(2.5 / s, 3, 0.5)
    round_ = 0.82 - side * 0.26 * np.clip(dx, -1.1, 1.1) - 0.3 * smooth(np.abs(dx), 0.62, 1.05)
    p.over(body, cloth, np.clip(round_ + fold - 0.1 * dy, 0.2, 1.4))
    neck = p.limb((x, chin - 0.2 * s), (x, chin + 0.12 * s), 0.2 * s, 0.225 * s, 0.02 * s)
    p.over(neck, skin, 0.72 - side * 0.5 * dx)
    p.darken(neck * p.ellipse(x + 0.03 * side * s, chin, 0.34 * s, 0.15 * s, 0.6), 0.45)
    if wear == "suit":
        v = [(x - 0.22 * s, chin + 0.04 * s), (x + 0.22 * s, chin + 0.04 * s), (x, chin + 1.1 * s)]
        opening = p.shape(v, 0.012 * s)
        inner = p.shape([(x - 0.17 * s, chin - 0.1 * s), (x + 0.17 * s, chin - 0.1 * s), *v[2:]])
        p.over(opening * (1 - inner * smooth(-dy, -0.2, -0.12)), "#dfe3e8", 0.9 - side * 0.35 * dx)
        tie = p.limb((x, chin + 0.22 * s), (x, chin + 1.0 * s), 0.045 * s, 0.08 * s, 0.015 * s)
        p.over(tie * opening, "#6a2f3a", 1.0 - side * 2.0 * dx)
        for q in (-1, 1):
            edge = p.limb(
                (x + q * 0.25 * s, chin + 0.2 * s), (x + q * 0.04 * s, chin + 1.1 * s), 0.03 * s
            )
            p.darken(blurred(edge, 0.02 * s * p.h), 0.35)
    else:
        rim = np.hypot(dx / 0.27, (dy - 0.1) / 0.27)
        p.darken(np.exp(-(((rim - 1.08) / 0.1) ** 2)) * smooth(dy, 0.12, 0.3), 0.3)
    narrow = 0.385 * s * (1 - 0.2 * smooth(p.y, y, chin))
    d = np.hypot((p.x - x) / narrow, (p.y - y) / (0.5 * s))
    face = 1 - smooth(d, 0.95, 1.04)
    for q in (-1, 1):
        ear = p.ellipse(x + q * 0.385 * s, y + 0.04 * s, 0.05 * s, 0.11 * s, 0.3)
        p.over(ear * (0 if long else 1), skin, 0.75 - 0.12 * q * side)
    lit = p.ball(x, y, 0.43 * s, 0.56 * s, light)
    tone = rgb(skin) * (0.5 + 0.68 * lit)[..., None]
    tone = tone * (1 - 0.1 * (1 - lit)[..., None] * np.array([0, 0.6, 1.0]))
    p.over(face, tone * (1 + 0.015 * p.noise(6 / s, 3)[..., None]))

    def dab(u: float, v: float, rx: float, ry: float, amount: float, turn: float = 0.0) -> None:
        p.darken(face * p.ellipse(x + u * s, y + v * s, rx * s, ry * s, 0.75, turn), amount)

    for q in (-1, 1):
        dab(q * 0.155, 0.0, 0.12, 0.065, 0.3)
        dab(q * 0.155, 0.01, 0.05, 0.024, 0.75)
        dab(q * 0.16, -0.085, 0.1, 0.022, 0.4, -q * 0.1)
        dab(q * 0.3, 0.22, 0.12, 0.2, 0.12)
        cheek = p.ellipse(x + q * 0.19 * s, y + 0.17 * s, 0.12 * s, 0.09 * s, 0.9)
        p.over(face * cheek * 0.25, rgb(skin) * [1.0, 0.78, 0.72], 0.6 + 0.5 * lit)
    dab(side * 0.055, 0.12, 0.035, 0.13, 0.2)
    dab(0.0, 0.215, 0.075, 0.03, 0.3)
    p.glow(face * p.ellipse(x - side * 0.02 * s, y + 0.13 * s, 0.03 * s, 0.1 * s, 0.9) * 0.14, skin)
    mouth = p.ellipse(x, y + 0.305 * s, 0.12 * s, 0.034 * s, 0.6)
    p.over(face * mouth * 0.5, rgb(skin) * [0.78, 0.52, 0.48])
    for q in (-1, 1):
        dab(q * 0.06, 0.3, 0.075, 0.014, 0.3, -q * 0.2)
    dab(0.0, 0.37, 0.09, 0.025, 0.16)
    p.glow(face * p.ellipse(x - side * 0.08 * s, y - 0.24 * s, 0.16 * s, 0.1 * s, 0.9) * 0.12, skin)
    cap = p.ellipse(x, y - 0.1 * s, 0.43 * s, 0.47 * s, 0.05)
    brow = p.ellipse(x - side * 0.05 * s, y + 0.2 * s, 0.37 * s, 0.5 * s, 0.12)
    cap *= (1 - brow) * (1 - smooth(dy + 0.5, 0.12 if not long else 0.5, 0.2 if not long else 0.6))
    p.over(cap, hair, curl)
    p.glow(
        cap * p.ellipse(x - side * 0.16 * s, y - 0.4 * s, 0.2 * s, 0.1 * s, 0.9) * 0.2, "#c8a888"
    )
