"""Drawn cut faces of fruit and vegetables (Pillow), filling a square; v is up along the fruit."""

from __future__ import annotations

import math

import numpy as np
from toolkit import labels

N = 160


def disc(d, k: float, fill, kx: float | None = None, cx: float = 0.5, cy: float = 0.5) -> None:
    """An ellipse with half-axes kx, k (shares of the half side)."""
    kx = k if kx is None else kx
    x, y = cx * N, cy * N
    d.ellipse((x - kx * N / 2, y - k * N / 2, x + kx * N / 2, y + k * N / 2), fill=fill)


def round_face(rim, flesh):
    image, d = labels.canvas(N, N, rim)
    disc(d, 0.92, flesh)
    return image, d


def segments(rim="#e8861a", pith="#fbeed0", pulp="#f5a02c", light="#ffc868", count=10):
    """Citrus, cut across."""
    image, d = labels.canvas(N, N, rim)
    disc(d, 0.95, pith)
    for i in range(count):
        a0, a1 = math.tau * (i + 0.07) / count, math.tau * (i + 0.93) / count
        arc = [(math.cos(t), math.sin(t)) for t in np.linspace(a0, a1, 7)]
        middle = (a0 + a1) / 2
        tip = (0.13 * math.cos(middle), 0.13 * math.sin(middle))
        for k, fill in ((0.82, pulp), (0.6, light)):
            pts = [tip, *[(x * k, y * k) for x, y in arc]]
            if k < 0.8:
                pts = [(0.22 * math.cos(middle), 0.22 * math.sin(middle))] + [
                    (
                        k * math.cos(t) * 1.15,
                        k * math.sin(t) * 1.15,
                    )
                    for t in np.linspace(a0 + 0.12, a0 + 0.3, 3)
                ]
            d.polygon([(N / 2 + x * N / 2, N / 2 + y * N / 2) for x, y in pts], fill=fill)
    disc(d, 0.1, pith)
    return image


def apple_core(rim="#c8262c", flesh="#f8f0cf"):
    image, d = round_face(rim, flesh)
    disc(d, 0.5, "#eedfa6", 0.36, 0.5, 0.52)
    disc(d, 0.42, flesh, 0.28, 0.5, 0.52)
    for x in (-1, 1):
        disc(d, 0.17, "#d9c68a", 0.1, 0.5 + 0.075 * x, 0.52)
        disc(d, 0.12, "#4a2a12", 0.07, 0.5 + 0.07 * x, 0.53)
    d.line((N / 2, 0, N / 2, N * 0.32), fill="#b9a05a", width=4)
    return image


def stone_face(rim, flesh, inner, stone="#7a4a22"):
    image, d = round_face(rim, flesh)
    disc(d, 0.56, inner, 0.54)
    disc(d, 0.42, stone, 0.36)
    for k in range(5):
        y = N * (0.36 + 0.07 * k)
        d.arc((N * 0.38, y, N * 0.62, y + 10), 20, 160, fill="#4f2c12", width=3)
    return image


def chambers(rim="#c8281c", flesh="#e0503a", jelly="#d8602c", seed_="#f4dc9a", count=5):
    """A tomato, cut across."""
    image, d = round_face(rim, flesh)
    for i in range(count):
        a = math.tau * (i + 0.25) / count
        x, y = 0.5 + 0.25 * math.cos(a), 0.5 + 0.25 * math.sin(a)
        disc(d, 0.35, jelly, 0.35, x, y)
        for j in range(5):
            b = a + (j - 2) * 0.2
            q = 0.22 + 0.06 * (j % 2)
            disc(d, 0.065, seed_, 0.065, 0.5 + q * math.cos(b), 0.5 + q * math.sin(b))
    disc(d, 0.16, "#f0a890")
    return image


def kiwi_face(rim="#7a5a30", flesh="#7fb52c", light="#b4d860"):
    image, d = labels.canvas(N, N, rim)
    disc(d, 0.93, flesh)
    disc(d, 0.6, light)
    for i in range(26):
        a = math.tau * i / 26
        for q in (0.19, 0.25):
            t = a + (0.1 if q > 0.2 else 0)
            x, y = 0.5 + q * math.cos(t), 0.5 + q * math.sin(t)
            disc(d, 0.05, "#17130c", 0.05, x, y)
    for i in range(18):
        a = math.tau * i / 18
        d.line(
            [(N / 2 + q * N * math.cos(a), N / 2 + q * N * math.sin(a)) for q in (0.3, 0.44)],
            fill=light,
            width=2,
        )
    disc(d, 0.34, "#f4f2cf")
    return image


def rings(rim, light, line, count=6):
    """An onion, cut across."""
    image, d = labels.canvas(N, N, rim)
    for k in range(count):
        q = 0.94 - k * 0.88 / count
        disc(d, q, line)
        disc(d, q - 0.045, light)
    return image


def hollow(rim, flesh, dark, seed_="#f4e8c0", ribs=4):
    """A bell pepper, cut along."""
    image, d = labels.canvas(N, N, rim)
    d.rounded_rectangle((12, 12, N - 12, N - 8), 40, fill=flesh)
    d.rounded_rectangle((24, 26, N - 24, N - 18), 34, fill=dark)
    d.polygon([(50, 26), (110, 26), (94, 70), (66, 70)], fill="#f6eed2")
    for k in range(ribs):
        x = 30 + k * (N - 60) / (ribs - 1)
        d.line((x, 30, x * 0.7 + N * 0.15, N - 24), fill=flesh, width=5)
    rng = np.random.default_rng(3)
    for _ in range(46):
        x, y = rng.normal(N / 2, 20), rng.normal(62, 16)
        d.ellipse((x - 4, y - 3, x + 4, y + 3), fill=seed_, outline="#c8b07a")
    return image


def seedy(rim, flesh, ring, seed_="#b09a5a", count=26):
    """Aubergine or cucumber, cut."""
    image, d = round_face(rim, flesh)
    disc(d, 0.66, ring, 0.6)
    for i in range(count):
        a, q = math.tau * i / count, 0.2 + 0.07 * (i % 2)
        disc(d, 0.05, seed_, 0.035, 0.5 + q * math.cos(a), 0.5 + q * 1.1 * math.sin(a))
    return image


def pulp(rim, flesh, hole, seed_="#f4e2b0", seeds=20, size=0.6):
    """A pumpkin, cut along: flesh about a hollow of fibres and seeds."""
    image, d = round_face(rim, flesh)
    disc(d, size, hole)
    rng = np.random.default_rng(5)
    for _ in range(30):
        a, b = rng.uniform(0, math.tau), rng.uniform(0.05, size / 2)
        x, y = N / 2 + N * b * math.cos(a), N / 2 + N * b * math.sin(a)
        d.line((x, y, x + rng.normal(0, 12), y + rng.normal(0, 12)), fill=flesh, width=2)
    for _ in range(seeds):
        a, b = rng.uniform(0, math.tau), rng.uniform(0.05, size / 2.2)
        x, y = N / 2 + N * b * math.cos(a), N / 2 + N * b * math.sin(a)
        d.ellipse((x - 7, y - 4, x + 7, y + 4), fill=seed_, outline="#b08a4a")
    return image


def checked(rim, flesh, line, count=5):
    """A mango cheek scored into cubes."""
    image, d = round_face(rim, flesh)
    for k in range(1, count + 1):
        q = N * k / (count + 1)
        d.line((q, 8, q, N - 8), fill=line, width=5)
        d.line((8, q, N - 8, q), fill=line, width=5)
    return image


def plain_face(rim, flesh, fleck=None):
    image, d = round_face(rim, flesh)
    rng = np.random.default_rng(2)
    for _ in range(30 if fleck else 0):
        x, y = rng.uniform(20, N - 20, 2)
        d.ellipse((x - 2, y - 2, x + 2, y + 2), fill=fleck)
    return image


def berry_face(rim="#c01c24", flesh="#ee6a60", heart="#fbe6dc"):
    image, d = round_face(rim, flesh)
    disc(d, 0.6, heart, 0.34)
    for i in range(9):
        a = math.tau * i / 9
        d.line(
            [(N / 2 + q * N * math.cos(a), N / 2 + q * N * math.sin(a)) for q in (0.16, 0.4)],
            fill=heart,
            width=3,
        )
    return image


def leaves_face(edge="#6aa83a", light="#f2f4cc", line="#b4cf6a"):
    """A head of lettuce, cut along: nested leaves about a white core."""
    image, d = labels.canvas(N, N, edge)
    for k in range(7):
        q = 0.95 - 0.12 * k
        disc(d, q, line, q, 0.5, 0.5 + 0.02 * k)
        disc(d, q - 0.05, light if k % 2 else "#dcebae", q - 0.05, 0.5, 0.5 + 0.02 * k)
    d.polygon([(N * 0.36, N), (N * 0.64, N), (N * 0.54, N * 0.45), (N * 0.46, N * 0.45)], "#fbfbe6")
    for side in (-1, 1):
        for k in range(4):
            y = N * (0.9 - 0.11 * k)
            d.line((N / 2, y, N / 2 + side * N * 0.34, y - N * 0.28), fill="#fbfbe6", width=5)
    return image


def stone_free(rim, flesh, heart):
    """A carrot, cut across: a paler heart with rays."""
    image, d = round_face(rim, flesh)
    disc(d, 0.5, heart)
    for i in range(12):
        a = math.tau * i / 12
        d.line(
            [(N / 2 + q * N * math.cos(a), N / 2 + q * N * math.sin(a)) for q in (0.08, 0.3)],
            fill=flesh,
            width=3,
        )
    return image
