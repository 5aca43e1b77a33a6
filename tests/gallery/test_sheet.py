"""Contact sheets."""

import numpy as np
import pytest
from sdgen.gallery.sheet import contact_sheet, pages


def test_tiles_stand_in_rows_with_their_labels() -> None:
    tiles = [(f"tile_{k}", np.full((64, 64, 3), 10 * k, np.uint8)) for k in range(5)]
    sheet = contact_sheet(tiles, 3)
    assert sheet.shape == (2 * (64 + 14 + 4) + 4, 3 * (64 + 4) + 4, 3)
    for k in range(5):
        y, x = 4 + (k // 3) * 82, 4 + (k % 3) * 68
        assert (sheet[y : y + 64, x : x + 64] == 10 * k).all()
        label = sheet[y + 64 : y + 78, x : x + 64]
        assert (label < 128).any()
    assert (sheet[86 + 64 :, 140:] == (250, 249, 246)).all()  # no sixth tile


def test_a_sheet_of_nothing_is_an_error() -> None:
    with pytest.raises(ValueError, match="nothing"):
        contact_sheet([], 3)


def test_pages_cover_everything_once() -> None:
    assert [list(page) for page in pages(5, 2)] == [[0, 1], [2, 3], [4]]
    assert list(pages(0, 2)) == []
