"""Files that are there whole or not at all, whatever comes in between."""

from pathlib import Path

import pytest
from sdgen.dataset.disk import replace_file
from sdgen.errors import Stopped


@pytest.mark.parametrize("error", [OSError(28, "full"), KeyboardInterrupt(), Stopped(15)])
def test_nothing_stays_beside_a_file_that_was_not_replaced(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, error: BaseException
) -> None:
    def stop(*_: object) -> None:
        raise error

    (tmp_path / "a").write_text("old")
    monkeypatch.setattr("sdgen.dataset.disk.os.replace", stop)
    with pytest.raises(type(error)):
        replace_file(tmp_path / "a", b"new")
    assert [path.name for path in tmp_path.iterdir()] == ["a"]
    assert (tmp_path / "a").read_text() == "old"
