"""A short video of what an agent saw: GIF (Pillow), or MP4 (PyAV: pip install sdgen[video])."""

from __future__ import annotations

import io
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from types import TracebackType
from typing import Any

import numpy as np
from PIL import Image

from sdgen.agent.film.frames import Pixels, band, even, larger, seen, with_band
from sdgen.agent.film.steps import Step
from sdgen.errors import SdgenError

#: Viewers show GIFs that ask for more at a tenth of it.
MOST_FPS = 50
#: Colours of a GIF's frame, but for black and white of the line of text.
_COLOURS = 254
#: Longer pictures are halved, or more, for a GIF: it is ten times as large as an MP4.
_GIF_SIDE = 480
#: Of x264, 0 to 51: as good as the original to the eye.
_QUALITY = 18


def check_fps(fps: int) -> None:
    """Raises SdgenError for frames a second that a video cannot have."""
    if not 1 <= fps <= MOST_FPS:
        raise SdgenError(f"{fps} frames a second: 1 to {MOST_FPS} can be shown")


def gif_bytes(steps: Sequence[Step], fps: int, captions: bool = True) -> bytes:
    """A GIF that loops: a frame a step (without captions, equal ones after each other are one that
    is shown longer). The same bytes for the same steps and version of Pillow."""
    check_fps(fps)
    texts = [step.caption if captions else None for step in steps]
    frames = [_paletted(rgb, text) for rgb, text in zip(seen(steps), texts, strict=True)]
    buffer = io.BytesIO()
    frames[0].save(
        buffer,
        "GIF",
        save_all=True,
        append_images=frames[1:],
        duration=round(1000 / fps),
        loop=0,
        optimize=False,
    )
    return buffer.getvalue()


def _paletted(rgb: Pixels, text: str | None) -> Image.Image:
    """A frame in its own colours, chosen on the camera's own pixels by median cut.

    That takes 7 ms at 128 x 96, 25 ms at 320 x 240; an octree takes a twentieth of it, and wood
    loses its grain.
    """
    times = -(-max(rgb.shape[:2]) // _GIF_SIDE)
    small = Image.fromarray(rgb).reduce(times).quantize(_COLOURS, Image.Quantize.MEDIANCUT)
    palette = (small.getpalette() or [])[: 3 * _COLOURS]
    indices = larger(np.asarray(small))
    if text is not None:
        line = band(text, indices.shape[1])
        indices = np.concatenate([indices, np.where(line, 255, 254).astype(np.uint8)])
    frame = Image.fromarray(indices)
    frame.putpalette(palette + [0] * (3 * 255 - len(palette)) + [255] * 3)
    return frame


def write_mp4(steps: Sequence[Step], path: Path, fps: int, captions: bool = True) -> None:
    """An MP4, a frame a step. ModuleNotFoundError without PyAV."""
    check_fps(fps)
    pictures = [larger(rgb) for rgb in seen(steps)]
    with Mp4(path, fps) as video:
        for step, pixels in zip(steps, pictures, strict=True):
            video.add(even(with_band(pixels, step.caption) if captions else pixels))


class Mp4:
    """An MP4 that frames of one size, even in width and height, are added to.

    H.264 where this FFmpeg can write it, else MPEG-4; ``gap`` frames at most lie between those
    that can be read alone. Raises ModuleNotFoundError without PyAV.
    """

    def __init__(self, path: Path, fps: int, gap: int = 25) -> None:
        import av

        self.path = path
        self.fps = fps
        self.frames = 0
        self.codec = "libx264" if "libx264" in av.codecs_available else "mpeg4"
        self._gap = gap
        self._video: Any = None
        self._file: Any = av.open(str(path), "w", format="mp4")

    def __enter__(self) -> Mp4:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: object, trace: TracebackType | None
    ) -> None:
        self.close(whole=kind is None)

    def add(self, pixels: Pixels) -> None:
        """Add a frame, (H, W, 3) uint8."""
        import av

        if self._video is None:
            self._video = self._stream(*pixels.shape[:2])
        frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(pixels), format="rgb24")
        frame.pts = self.frames
        frame.time_base = Fraction(1, self.fps)
        self._file.mux(self._video.encode(frame))
        self.frames += 1

    def _stream(self, high: int, wide: int) -> Any:
        # Frames that are built on later ones would shift the first one's time.
        options = {"bf": "0"}
        if self.codec == "libx264":
            options |= {"crf": str(_QUALITY), "preset": "medium"}
        else:
            options |= {"qscale": "3"}
        video = self._file.add_stream(self.codec, rate=self.fps, options=options)
        video.width, video.height, video.pix_fmt = wide, high, "yuv420p"
        video.gop_size = self._gap
        video.thread_count = 1  # the same bytes on any number of cores
        return video

    def close(self, whole: bool = True) -> None:
        """End the file; what was added last is lost unless it is to be ``whole``."""
        if self._file is None:
            return
        file, self._file = self._file, None
        try:
            if whole and self._video is not None:
                file.mux(self._video.encode(None))
        finally:
            file.close()
