"""A colour picture against the mask of its view: colours change where one thing ends."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from sdgen.scene import Look

Rgb = npt.NDArray[np.uint8]
Ids = npt.NDArray[np.uint16]

#: A step between neighbouring pixels, summed over the channels, that is as clear as can be.
_STEP = 30
# How much more often colours step at edges of the mask than elsewhere, from 0 (no more) to 1. In
# 240 views of 20 scenes it was 0.55 (TinyRenderer) and 0.70 (EGL) at least with the picture that
# belongs to the mask, and 0.30 at most with a mirrored one or that of another view.
_SURE = 0.45
_LEAST, _AHEAD = 0.2, 0.25
#: Noise and blur are no steps: a picture that a camera's look is on is judged as means of so many
#: pixels each way, by less (in 16 views of robots it was 0.22 at least, in the dark, and 0.08 at
#: most with another picture), and not at all where its look is stronger than this: stops, white's
#: noise, blur as a share of the width.
_MEANS = 3
_MOST_STOPS, _MOST_NOISE, _MOST_BLUR = 1.0, 0.06, 0.005
#: And by as little are those of a turn, which looks at white doors in white walls from nearby (of
#: 180 views 0.37 at least and 0.15 ahead; small ones of dim corners are fainter).
LEAST_FAINT, AHEAD_FAINT = 0.1, 0.05


def looked_follows_mask(rgb: Rgb, ids: Ids, look: Look) -> bool:
    """:func:`follows_mask` of a picture that a camera's look is on; True where nobody could
    tell."""
    height, width = ids.shape
    blur = max(look.focus_px, look.motion_px / 2)
    if (
        abs(look.exposure_stops) > _MOST_STOPS
        or look.shot_noise > _MOST_NOISE
        or blur > _MOST_BLUR * width
    ):
        return True
    rows, columns = height // _MEANS, width // _MEANS
    whole = rgb[: rows * _MEANS, : columns * _MEANS].astype(np.uint16)
    means = whole.reshape(rows, _MEANS, columns, _MEANS, 3).sum(axis=(1, 3)) // _MEANS**2
    middle = slice(_MEANS // 2, None, _MEANS)
    small = ids[middle, middle][:rows, :columns]
    return follows_mask(means.astype(np.uint8), small, LEAST_FAINT, AHEAD_FAINT)


def follows_mask(rgb: Rgb, ids: Ids, least: float = _LEAST, ahead: float = _AHEAD) -> bool:
    """False when colours (H, W, 3) show something else than the mask (H, W): a mirrored picture,
    another view's or another scene's. Pale homes, where few edges show, still follow their mask
    (by ``least``) better than their mirror images do (by ``ahead``)."""
    across, down = ids[:, 1:] != ids[:, :-1], ids[1:] != ids[:-1]
    # Two lines from top to bottom say nothing: what they part may be of one colour, a white frame
    # on a white wall. One of 8,000 views of 1,000 scenes has fewer edges than this and faint ones.
    if across.sum() + down.sum() < sum(ids.shape):
        return True
    found = _agreement(rgb, across, down)
    if found >= _SURE:
        return True
    mirrored = (rgb[:, ::-1], rgb[::-1], rgb[::-1, ::-1])
    return found >= max(least, ahead + max(_agreement(m, across, down) for m in mirrored))


def _agreement(rgb: Rgb, across: npt.NDArray[np.bool_], down: npt.NDArray[np.bool_]) -> float:
    """Mean step at edges of the mask less the mean elsewhere, as a share of a clear one."""
    # Channel by channel, in whole numbers: a sixth of the time of sums over the last axis.
    channels = np.ascontiguousarray(rgb.transpose(2, 0, 1)).astype(np.int16)
    at_edges = everywhere = edges = pixels = 0
    for axis, edge in ((2, across), (1, down)):
        red, green, blue = np.abs(np.diff(channels, axis=axis))
        clear = np.minimum(red + green + blue, _STEP)
        at_edges += int(clear[edge].sum(dtype=np.int64))
        everywhere += int(clear.sum(dtype=np.int64))
        edges += int(edge.sum())
        pixels += edge.size
    if edges == pixels:
        return 0.0
    return (at_edges / edges - (everywhere - at_edges) / (pixels - edges)) / _STEP
