"""A small convolutional net over crops: the one detector here that needs torch.

Four convolutions on 64 x 64 pixels of colour and mask, ten million multiplications each:
minutes on a CPU. Its weights are arrays as those of the trees are.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from sdgen.dataset import Dataset, SceneItem
from sdgen.detectors.pictures import (
    PLACE,
    TELL_VIEWS,
    Bytes,
    PictureExamples,
    by_thing,
    crops_of,
)
from sdgen.detectors.scored import Array, Hazards, Scored
from sdgen.detectors.told import things
from sdgen.seeding import Rng, lane

if TYPE_CHECKING:
    import torch

Floats = npt.NDArray[np.float32]
Progress = Callable[[int, int], None]

#: Channels of the convolutions, after colour and mask; and of the layer before the answer.
CHANNELS = (4, 16, 32, 64, 128)
HIDDEN = 128
EPOCHS, LOT = 12, 64
#: Of the learning rate that falls in a cosine to nothing, the highest; and the decay of weights.
RATE, DECAY = 2e-3, 1e-2
#: Crops nothing is wrong with that an epoch draws for each with something wrong: of all of them,
#: thirty times as many, it would learn little but that.
RIGHT_A_WRONG = 4
#: Weight of which hazard it is, beside whether there is one.
_NAMING = 0.5
#: Answers are drawn so far towards doubt, or rare examples would be learned by heart.
_SMOOTHED = 0.02
#: Crops asked at once.
_ASKED = 256


def _shapes(outputs: int) -> dict[str, tuple[int, ...]]:
    """The arrays of a net with so many outputs."""
    shapes: dict[str, tuple[int, ...]] = {}
    for k, (before, after) in enumerate(pairwise(CHANNELS)):
        shapes[f"conv{k}.weight"], shapes[f"conv{k}.bias"] = (after, before, 3, 3), (after,)
    wide = 2 * CHANNELS[-1] + len(PLACE)
    shapes["hidden.weight"], shapes["hidden.bias"] = (HIDDEN, wide), (HIDDEN,)
    shapes["out.weight"], shapes["out.bias"] = (outputs, HIDDEN), (outputs,)
    return shapes


def _start(outputs: int, rng: Rng) -> dict[str, Floats]:
    """Weights to begin with (He et al. 2015), from a lane rather than torch's global state."""
    made = {}
    for name, shape in _shapes(outputs).items():
        if name.endswith("weight"):
            deviation = (2.0 / np.prod(shape[1:])) ** 0.5 * (0.1 if name == "out.weight" else 1.0)
            made[name] = rng.normal(0.0, deviation, shape).astype(np.float32)
        else:
            made[name] = np.zeros(shape, dtype=np.float32)
    return made


def _forward(
    weights: Mapping[str, Any],
    pixels: torch.Tensor,
    place: torch.Tensor,
    normed: Callable[[int, torch.Tensor], torch.Tensor] | None = None,
) -> torch.Tensor:
    """Logits (n, outputs) of pixels (n, 4, side, side) from 0 to 1 and places (n, 6)."""
    from torch.nn import functional as f

    x = pixels * 2 - 1
    for k in range(len(CHANNELS) - 1):
        x = f.conv2d(x, weights[f"conv{k}.weight"], padding=1)
        x = x if normed is None else normed(k, x)
        x = f.max_pool2d(f.relu(x + weights[f"conv{k}.bias"][:, None, None]), 2)
    x = _beside([x.mean(dim=(2, 3)), x.amax(dim=(2, 3)), place])
    x = f.relu(f.linear(x, weights["hidden.weight"], weights["hidden.bias"]))
    return f.linear(x, weights["out.weight"], weights["out.bias"])


class _Norms:
    """Batch normalization (Ioffe and Szegedy, 2015), there for training alone: what it has learned
    is folded into the convolutions, so an answer does not hang on what is asked beside it."""

    def __init__(self) -> None:
        import torch

        self.scales = [torch.ones(n, requires_grad=True) for n in CHANNELS[1:]]
        self._means = [torch.zeros(n) for n in CHANNELS[1:]]
        self._variances = [torch.ones(n) for n in CHANNELS[1:]]

    def __call__(self, k: int, x: torch.Tensor) -> torch.Tensor:
        from torch.nn import functional as f

        means, variances = self._means[k], self._variances[k]
        return f.batch_norm(x, means, variances, self.scales[k], training=True)

    def folded(self, weights: Mapping[str, torch.Tensor]) -> dict[str, Floats]:
        """The weights as arrays, normalization included."""
        import torch

        out = {name: one.detach().clone() for name, one in weights.items()}
        with torch.no_grad():
            for k, scale in enumerate(self.scales):
                factor = scale / torch.sqrt(self._variances[k] + 1e-5)
                out[f"conv{k}.weight"] *= factor[:, None, None, None]
                out[f"conv{k}.bias"] -= self._means[k] * factor
        return {name: one.numpy() for name, one in out.items()}


def _beside(parts: list[torch.Tensor]) -> torch.Tensor:
    """Columns side by side."""
    import torch

    return torch.cat(parts, dim=1)


@dataclass(frozen=True)
class Cnn:
    """Outputs: whether something is wrong, then one a hazard; means over a thing's best views."""

    hazards: Hazards
    weights: Mapping[str, Floats]

    def __call__(self, data: Dataset, item: SceneItem) -> tuple[Scored, ...]:
        import torch

        wanted = {node.id for node in things(item.shown_graph)}
        crops = crops_of(item, wanted, TELL_VIEWS)
        if not len(crops.ids):
            return ()
        weights = {name: torch.from_numpy(array) for name, array in self.weights.items()}
        found = []
        with torch.inference_mode():
            for k in range(0, len(crops.ids), _ASKED):
                pixels = _as_pixels(crops.pixels[k : k + _ASKED])
                place = torch.from_numpy(crops.place[k : k + _ASKED])
                logits = _forward(weights, pixels, place)
                parts = [logits[:, :1].sigmoid(), logits[:, 1:].softmax(dim=1)]
                found.append(_beside(parts).numpy())
        ids, means = by_thing(crops.ids, np.concatenate(found).astype(np.float64))
        return self.hazards.scored(ids, means[:, 0], means[:, 1:])

    def arrays(self) -> dict[str, Array]:
        return dict(self.weights)

    def words(self) -> dict[str, tuple[str, ...]]:
        return {}

    @classmethod
    def from_file(
        cls, arrays: Mapping[str, Array], words: Mapping[str, tuple[str, ...]], hazards: Hazards
    ) -> Cnn:
        """The net that was kept. ValueError for what does not fit together."""
        weights = {}
        for name, shape in _shapes(1 + len(hazards.names)).items():
            array = arrays.get(name)
            if array is None or array.dtype != np.float32 or array.shape != shape:
                raise ValueError(f"no array {name} of {' by '.join(map(str, shape))} numbers")
            if not np.isfinite(array).all():
                raise ValueError(f"{name}: a number that is none")
            weights[name] = array.astype(np.float32)
        return cls(hazards, weights)


def _as_pixels(pixels: Bytes) -> torch.Tensor:
    import torch

    return torch.from_numpy(np.ascontiguousarray(pixels.transpose(0, 3, 1, 2))).float() / 255


def fit_cnn(
    examples: PictureExamples, hazards: Hazards, seed: int, on_step: Progress | None = None
) -> Cnn:
    """Train on crops, mirrored, shifted and of other brightness. ModuleNotFoundError without
    torch."""
    import torch

    rng = lane(seed, 0, "train:cnn")
    start, norms = _start(1 + len(hazards.names), rng), _Norms()
    weights = {k: torch.from_numpy(v).requires_grad_(True) for k, v in start.items()}
    learned = [*weights.values(), *norms.scales]
    optimizer = torch.optim.AdamW(learned, lr=RATE, weight_decay=DECAY)
    answers = torch.from_numpy(examples.hazard)
    wrong, right = np.flatnonzero(examples.hazard >= 0), np.flatnonzero(examples.hazard < 0)
    drawn = min(len(right), RIGHT_A_WRONG * len(wrong))
    lots = max(1, -(-(len(wrong) + drawn) // LOT))
    steps = EPOCHS * lots
    step = 0
    for _ in range(EPOCHS):
        order = rng.permutation(np.concatenate([wrong, rng.permutation(right)[:drawn]]))
        for lot in np.array_split(order, lots):
            rate = RATE * min(1.0, (step + 1) / 100) * (1 + np.cos(np.pi * step / steps)) / 2
            for group in optimizer.param_groups:
                group["lr"] = rate
            pixels, place = _changed(examples.pixels[lot], examples.place[lot], rng)
            logits = _forward(weights, pixels, torch.from_numpy(place), norms)
            loss = _loss(logits, answers[lot])
            optimizer.zero_grad()
            loss.backward()
            optimizer.step()
            step += 1
            if on_step is not None:
                on_step(step, steps)
    return Cnn(hazards, norms.folded(weights))


def _loss(logits: torch.Tensor, answers: torch.Tensor) -> torch.Tensor:
    """Of whether something is wrong, and of what where something is."""
    from torch.nn import functional as f

    wrong = answers >= 0
    said = wrong.float() * (1 - _SMOOTHED) + _SMOOTHED / 2
    finding = f.binary_cross_entropy_with_logits(logits[:, 0], said)
    naming = f.cross_entropy(
        logits[wrong, 1:], answers[wrong], label_smoothing=_SMOOTHED, reduction="sum"
    )
    return finding + _NAMING * naming / len(answers)


def _changed(pixels: Bytes, place: Floats, rng: Rng) -> tuple[torch.Tensor, Floats]:
    """A lot as it might have been seen: in a mirror, shifted, brighter or darker."""
    import torch

    n = len(pixels)
    flipped = rng.random(n) < 0.5
    place = place.copy()
    place[flipped, 0] = 1 - place[flipped, 0]
    mirrored = np.where(flipped[:, None, None, None], pixels[:, :, ::-1], pixels)
    shift = rng.integers(-3, 4, size=2)
    moved = np.roll(mirrored, tuple(int(k) for k in shift), axis=(1, 2))
    out = _as_pixels(moved)
    gain = torch.from_numpy(rng.uniform(0.8, 1.25, (n, 1, 1, 1)).astype(np.float32))
    tint = torch.from_numpy(rng.uniform(0.95, 1.05, (n, 3, 1, 1)).astype(np.float32))
    out[:, :3] = (out[:, :3] * gain * tint).clamp(0, 1)
    return out, place
