"""What stands about a home, put down by chance: houses, gardens, streets, trees."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from sdgen.geometry import Vec2
from sdgen.render.backdrop.canvas import Floats, linear
from sdgen.render.backdrop.facades import Cabin, Facade, Plain
from sdgen.render.backdrop.ground import Patch
from sdgen.render.backdrop.plants import Crown, Tree, crowns, grass_of, leaves_of
from sdgen.render.backdrop.solids import Block, Painter
from sdgen.scene import Outdoors

PLASTER = (
    linear(226, 216, 198),
    linear(214, 200, 170),
    linear(218, 218, 212),
    linear(204, 184, 160),
    linear(196, 202, 198),
    linear(222, 202, 150),
    linear(186, 168, 150),
    linear(206, 164, 138),
)
BRICK = (linear(150, 92, 74), linear(164, 112, 86), linear(132, 98, 84), linear(176, 148, 122))
CONCRETE = (linear(190, 188, 182), linear(208, 204, 194), linear(176, 180, 182))
ROOFS = (linear(132, 74, 58), linear(86, 80, 78), linear(112, 100, 92), linear(150, 92, 66))
FRAMES = (linear(232, 232, 228), linear(226, 222, 212), linear(96, 84, 74))
SHUTTERS = (linear(74, 98, 84), linear(92, 66, 52), linear(196, 200, 200), linear(84, 104, 124))
CARS = (
    linear(178, 180, 182),
    linear(52, 56, 62),
    linear(206, 206, 204),
    linear(122, 38, 36),
    linear(48, 68, 104),
    linear(96, 100, 102),
)
ASPHALT, PAVING, KERB = linear(98, 98, 100), linear(158, 154, 148), linear(176, 174, 170)
LINES = linear(206, 206, 200)
GRAVEL, SAND = linear(168, 156, 138), linear(206, 190, 158)
SEA, TIMBER, SNOW = linear(52, 92, 108), linear(128, 104, 80), linear(222, 226, 232)


@dataclass
class Place:
    """All that is painted of one world, from far to near. The street is towards +y."""

    base: Patch
    patches: list[Patch] = field(default_factory=list)
    blocks: list[Block] = field(default_factory=list)
    trees: list[Tree] = field(default_factory=list)
    lamps: list[Vec2] = field(default_factory=list)
    #: How high the hills behind all are, as a sine, and where the sea reaches the horizon: within
    #: so many radians of +y.
    hills: float = 0.03
    sea: float = 0.0
    snow: bool = False


class Builder:
    """Puts things down, by chance."""

    def __init__(self, outdoors: Outdoors, rng: np.random.Generator) -> None:
        self.rng = rng
        self.season = outdoors.season
        self.storey = outdoors.storey
        self.snow = outdoors.season == "winter" and rng.random() < 0.55
        self.kinds: list[Crown] = crowns(outdoors.season, self.snow, rng)
        grass = grass_of(outdoors.season)
        ground = SNOW * np.float32(0.92) if self.snow else grass
        self.place = Place(Patch((0, 0), (0, 0), ground, 0.1), snow=self.snow)
        self.paving = PAVING * np.float32(0.5) + SNOW * np.float32(0.4) if self.snow else PAVING
        self.place.hills = float(rng.choice((0.025, 0.05, 0.085)))

    def pick(self, colours: tuple[Floats, ...]) -> Floats:
        return colours[int(self.rng.integers(len(colours)))]

    def between(self, low: float, high: float) -> float:
        return float(self.rng.uniform(low, high))

    def block(
        self,
        low: Vec2,
        high: Vec2,
        wall_m: float,
        painter: Painter,
        top: Floats,
        slope: float = 0.0,
        ridge: int = 0,
        foot_m: float = 0.0,
    ) -> None:
        seed = int(self.rng.integers(2**16))
        tiled = slope > 0 and isinstance(painter, Facade) and not self.snow
        block = Block(low, high, wall_m, painter, top, slope, ridge, foot_m, seed, tiled)
        self.place.blocks.append(block)

    def road(self, low: Vec2, high: Vec2, colour: Floats = ASPHALT) -> None:
        wet = colour * np.float32(1.25) + np.float32(0.06) if self.snow else colour
        self.place.patches.append(Patch(low, high, wet, 0.05))

    def house(self, x: float, y: float, wide: float, deep: float, floors: int = 0) -> None:
        """A house with a pitched roof in the middle of its ground."""
        floors = floors or int(self.rng.choice((1, 2, 2)))
        brick = self.rng.random() < 0.35
        facade = Facade(
            self.pick(BRICK if brick else PLASTER),
            self.pick(FRAMES),
            2.7,
            self.between(2.4, 3.6),
            self.between(1.0, 1.7),
            self.between(1.15, 1.5),
            brick=brick,
            floors=floors,
            shutters=self.pick(SHUTTERS) if self.rng.random() < 0.3 else None,
        )
        roof = SNOW if self.snow else self.pick(ROOFS)
        low, high = (x - wide / 2, y - deep / 2), (x + wide / 2, y + deep / 2)
        slope = self.between(0.55, 0.95)
        ridge = int(self.rng.random() < 0.4) if wide < 1.6 * deep else 0
        self.block(low, high, floors * 2.7 + 0.2, facade, roof, slope, ridge)
        if self.rng.random() < 0.7:
            at = (x + self.between(-0.3, 0.3) * wide, y + 0.4)
            top = floors * 2.7 + slope * (deep if ridge == 0 else wide) / 2 + 0.9
            chimney = Plain(self.pick(BRICK))
            self.block(
                (at[0] - 0.35, at[1] - 0.35), (at[0] + 0.35, at[1] + 0.35), top, chimney, roof
            )

    def row(self, y: float, deep: float, reach: float, floors: tuple[int, int]) -> None:
        """Houses wall to wall along a street."""
        x = -reach
        while x < reach:
            wide = self.between(8.0, 14.0)
            count = int(self.rng.integers(floors[0], floors[1] + 1))
            brick = self.rng.random() < 0.3
            facade = Facade(
                self.pick(BRICK if brick else PLASTER),
                self.pick(FRAMES),
                self.between(2.9, 3.3),
                self.between(2.0, 3.0),
                self.between(0.95, 1.35),
                self.between(1.5, 1.9),
                brick=brick,
                floors=count,
                balconies=self.rng.random() < 0.2,
                rail=self.pick(CONCRETE),
                shops=self.rng.random() < 0.35,
            )
            roof = SNOW if self.snow else self.pick(ROOFS)
            wall = count * facade.floor_m + self.between(0.3, 0.8)
            slope = self.between(0.5, 0.9) if self.rng.random() < 0.75 else 0.0
            self.block((x, y), (x + wide, y + deep), wall, facade, roof, slope, 0)
            x += wide

    def slab(self, x: float, y: float, wide: float, deep: float, floors: int) -> None:
        """A block of flats with balconies."""
        facade = Facade(
            self.pick((*CONCRETE, *PLASTER[:3])),
            self.pick(FRAMES),
            2.8,
            self.between(3.2, 4.6),
            self.between(1.6, 2.4),
            1.45,
            balconies=self.rng.random() < 0.8,
            rail=self.pick((*CONCRETE, *PLASTER)),
            floors=floors,
        )
        roof = SNOW if self.snow else linear(120, 118, 114)
        low, high = (x - wide / 2, y - deep / 2), (x + wide / 2, y + deep / 2)
        self.block(low, high, floors * 2.8 + 0.7, facade, roof)

    def tree(self, x: float, y: float, low: float, high: float, kind: int | None = None) -> None:
        chosen = int(self.rng.choice(6, p=(0.24, 0.22, 0.2, 0.14, 0.06, 0.14)))
        crown = self.kinds[chosen if kind is None else kind]
        if np.hypot(x, y) > 8.0:
            self.place.trees.append(Tree((x, y), self.between(low, high), crown))

    def bush(self, x: float, y: float) -> None:
        self.tree(x, y, 0.9, 2.0, 4)

    def hedge(self, low: Vec2, high: Vec2, high_m: float) -> None:
        leaves = leaves_of(self.season, self.rng)
        top = SNOW if self.snow else leaves
        self.block(low, high, high_m, Plain(leaves, leaves=True), top)

    def fence(self, low: Vec2, high: Vec2, high_m: float) -> None:
        colour = self.pick((TIMBER, linear(150, 128, 104), linear(206, 204, 198)))
        self.block(low, high, high_m, Plain(colour, slats_m=0.16), colour)

    def car(self, x: float, y: float, along: int = 0) -> None:
        colour = self.pick(CARS)
        long, wide = self.between(3.9, 4.6), 1.75

        def part(a: float, b: float, inset: float) -> tuple[Vec2, Vec2]:
            lows, highs = (a, inset - wide / 2), (b, wide / 2 - inset)
            if along:
                lows, highs = lows[::-1], highs[::-1]
            return (x + lows[0], y + lows[1]), (x + highs[0], y + highs[1])

        tyres, body = Plain(linear(34, 34, 36)), Plain(colour, rough=0.0)
        self.block(*part(0.35, 1.0, 0.0), 0.6, tyres, colour)
        self.block(*part(long - 1.05, long - 0.4, 0.0), 0.6, tyres, colour)
        self.block(*part(0.0, long, 0.02), 0.88, body, colour, foot_m=0.32)
        self.block(*part(long * 0.22, long * 0.86, 0.14), 1.43, Cabin(colour), colour, foot_m=0.85)

    def lamps(self, y: float, step: float, reach: float = 70.0) -> None:
        post = Plain(linear(92, 96, 98))
        for x in np.arange(-reach + self.between(0, step), reach, step).tolist():
            self.block((x - 0.06, y - 0.06), (x + 0.06, y + 0.06), 5.2, post, linear(92, 96, 98))
            self.place.lamps.append((x, y))

    def street(self, near: float, reach: float = 120.0) -> float:
        """Pavement, road, pavement from ``near`` on; where it ends."""
        self.road((-reach, near), (reach, near + 2.0), PAVING)
        self.road((-reach, near + 2.0), (reach, near + 8.0))
        self.road((-reach, near + 1.85), (reach, near + 2.0), KERB)
        self.road((-reach, near + 8.0), (reach, near + 10.0), PAVING)
        self.road((-reach, near + 8.0), (reach, near + 8.15), KERB)
        if not self.snow:
            line = Patch((-reach, near + 4.93), (reach, near + 5.07), LINES, 0.05, dash_m=2.0)
            self.place.patches.append(line)
        for x in np.arange(-38, 38, 6.2).tolist():
            if self.rng.random() < 0.4:
                self.car(x + self.between(0, 1.2), near + 3.0)
            if self.rng.random() < 0.4:
                self.car(x + self.between(0, 1.2), near + 7.0)
        self.lamps(near + 1.2, 24.0)
        return near + 10.0

    def garden(self, deep: float, wide: float) -> None:
        """Lawn with a fence or a hedge round it, a shed, bushes and trees, behind the home."""
        self.place.patches.append(Patch((-3.4, -3.2), (3.4, 3.2), self.paving, 0.06, slabs_m=0.5))
        edge = self.hedge if self.rng.random() < 0.5 else self.fence
        high = self.between(1.5, 2.0)
        edge((-wide, -deep - 0.3), (wide, -deep), high)
        edge((-wide - 0.25, -deep), (-wide, 4.0), high)
        edge((wide, -deep), (wide + 0.25, 4.0), high)
        side = -1 if self.rng.random() < 0.5 else 1
        x, y = side * (wide - 2.4), -deep + 2.4
        boards = Plain(self.pick((TIMBER, linear(112, 74, 56), linear(92, 108, 96))), slats_m=0.14)
        roof = SNOW if self.snow else linear(92, 88, 86)
        self.block((x - 1.5, y - 1.2), (x + 1.5, y + 1.2), 2.0, boards, roof, 0.45)
        for _ in range(int(self.rng.integers(3, 6))):
            self.tree(self.between(-wide, wide), self.between(-deep + 1, -10), 3.0, 6.0)
        for k in np.arange(-wide + 0.9, wide, 1.7).tolist():
            if self.rng.random() < 0.6 and abs(k - x) > 2:
                self.bush(k, -deep + self.between(0.6, 1.5))
        for k in np.arange(-deep + 2, -6, 2.1).tolist():
            if self.rng.random() < 0.5:
                self.bush(-side * (wide - self.between(0.7, 1.3)), k)

    def trees_about(self, low: Vec2, high: Vec2, count: int, tall: tuple[float, float]) -> None:
        for _ in range(count):
            self.tree(
                self.between(low[0], high[0]), self.between(low[1], high[1]), tall[0], tall[1]
            )

    def town(self, near: float, far: float, count: int, sides: tuple[float, float]) -> None:
        """Roofs at some distance, within these azimuths."""
        for _ in range(count):
            way, away = self.between(*sides), self.between(near, far)
            x, y = away * float(np.cos(way)), away * float(np.sin(way))
            if self.rng.random() < 0.25:
                self.slab(x, y, self.between(18, 40), 12, int(self.rng.integers(4, 9)))
            else:
                self.house(
                    x, y, self.between(9, 16), self.between(8, 11), int(self.rng.integers(1, 4))
                )
            if self.rng.random() < 0.7:
                self.tree(x * 0.96 + self.between(-9, 9), y * 0.96, 6.0, 12.0)
