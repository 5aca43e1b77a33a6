"""Further designs for a category that already has a maker, without touching its first models."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from toolkit.model import Maker, Model

Design = tuple[Callable[..., Model], dict]


def extend(maker: Maker, designs: Sequence[Design]) -> Maker:
    """`maker`, and after its own presets one model for each (function, parameters).

    Each function also takes `offset`, the place in noise space that the maker's sample draws.
    """

    def make(design: int | None = None, **parameters) -> Model:
        if design is None:
            return maker.make(**parameters)
        function, own = designs[design]
        return function(**{"offset": parameters["offset"], **own})

    make.__name__ = maker.make.__name__
    presets = [*maker.presets, *({"design": k} for k in range(len(designs)))]
    return Maker(make, maker.sample, len(presets), presets)


def designed(designs: Sequence[Design], sample: Callable) -> Maker:
    """A maker of nothing but designs; `sample` draws at least `offset`."""

    def make(design: int = 0, **parameters) -> Model:
        function, own = designs[design]
        return function(**{"offset": parameters["offset"], **own})

    make.__name__ = designs[0][0].__name__
    return Maker(make, sample, len(designs), [{"design": k} for k in range(len(designs))])
