"""Worker processes: what is made for them goes with them."""

import pickle
import tempfile
from collections.abc import Callable
from pathlib import Path

import pytest
from sdgen.engines.processes import Processes
from sdgen.errors import SdgenError


def _cannot_be_sent(_: Path, __: bytes) -> int:
    raise OSError(28, "full")


@pytest.mark.parametrize(
    ("args", "error"), [((lambda: None,), pickle.PicklingError), ((), SdgenError)]
)
def test_an_order_that_cannot_be_given_leaves_no_folder(
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    args: tuple[Callable[[], None], ...],
    error: type[Exception],
) -> None:
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path))
    monkeypatch.setattr(Path, "write_bytes", _cannot_be_sent)
    with pytest.raises(error) as caught:
        Processes(1, dict, args)  # type: ignore[arg-type]
    assert list(tmp_path.iterdir()) == [], caught
