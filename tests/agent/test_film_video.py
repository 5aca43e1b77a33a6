"""Videos of an episode: a frame a step, large enough to see, the colours as they were."""

from __future__ import annotations

import io
from pathlib import Path

import numpy as np
import pytest
from PIL import Image, ImageSequence
from sdgen.agent.film.frames import SIDE, even, larger
from sdgen.agent.film.video import gif_bytes, write_mp4
from sdgen.errors import SdgenError

from tests.agent import film


def gif(steps: int = 8, captions: bool = True, **size: int) -> list[np.ndarray]:
    data = gif_bytes(film.episode(steps, **size).steps, 5, captions)
    with Image.open(io.BytesIO(data)) as image:
        assert image.info["loop"] == 0
        frames = list(ImageSequence.Iterator(image))
        assert all(frame.info["duration"] == 200 for frame in frames)
        return [np.asarray(frame.convert("RGB")) for frame in ImageSequence.Iterator(image)]


def test_a_gif_has_a_frame_a_step_scaled_up_with_a_line_of_text() -> None:
    frames = gif()
    assert [frame.shape for frame in frames] == [(192 + 18, 256, 3)] * 8
    texts = {frame[192:].tobytes() for frame in frames}
    assert len(texts) == 8
    assert all(set(np.unique(frame[192:])) == {0, 255} for frame in frames)


def test_colours_of_a_gif_are_near_those_seen() -> None:
    frames = gif(captions=False)
    for frame, step in zip(frames, film.episode().steps, strict=True):
        assert step.rgb is not None
        assert np.abs(frame.astype(int) - larger(step.rgb)).mean() < 6


def test_a_gif_of_large_pictures_is_halved() -> None:
    assert gif(2, captions=False, width=320, height=240)[0].shape == (240, 320, 3)
    assert gif(2, captions=False, width=640, height=481)[0].shape == (241, 320, 3)


@pytest.mark.parametrize(("high", "wide"), [(8, 8), (48, 64), (64, 48), (300, 20)])
def test_small_pictures_are_whole_multiples(high: int, wide: int) -> None:
    pixels = np.arange(high * wide * 3, dtype=np.uint8).reshape(high, wide, 3)
    big = larger(pixels)
    times = big.shape[0] // high
    assert max(big.shape) >= SIDE
    np.testing.assert_array_equal(big[::times, ::times], pixels)


def test_equal_frames_are_shown_as_long_as_they_lasted() -> None:
    steps = (film.episode().steps[0],) * 5
    with Image.open(io.BytesIO(gif_bytes(steps, 5, captions=False))) as image:
        shown = sum(frame.info["duration"] for frame in ImageSequence.Iterator(image))
    assert shown == 1000


@pytest.mark.parametrize("fps", [0, 51])
def test_frames_a_second_that_no_viewer_shows(fps: int) -> None:
    with pytest.raises(SdgenError, match="frames a second"):
        gif_bytes(film.episode().steps, fps)


@pytest.mark.parametrize("size", [(64, 48), (321, 241)])
@pytest.mark.parametrize("codec", ["h264", "mpeg4"])
def test_an_mp4_decodes_to_a_frame_a_step(
    tmp_path: Path, size: tuple[int, int], codec: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    av = pytest.importorskip("av")
    if codec == "mpeg4":
        monkeypatch.setattr(av, "codecs_available", {"mpeg4"})
    steps = film.episode(8, *size).steps
    write_mp4(steps, tmp_path / "v.mp4", 10, captions=False)
    with av.open(str(tmp_path / "v.mp4")) as video:
        stream = video.streams.video[0]
        assert (stream.codec_context.name, stream.pix_fmt) == (codec, "yuv420p")
        assert stream.average_rate == 10
        frames = list(video.decode(stream))
    assert [float(frame.pts * frame.time_base) for frame in frames] == pytest.approx(
        [k / 10 for k in range(8)]
    )
    for frame, step in zip(frames, steps, strict=True):
        assert step.rgb is not None
        due = even(larger(step.rgb))
        assert np.abs(frame.to_ndarray(format="rgb24").astype(int) - due).mean() < 8
