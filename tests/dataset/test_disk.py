"""Files that are there whole or not at all, whatever comes in between."""

from pathlib import Path

import pytest
from sdgen.dataset.disk import replace_file
from sdgen.dataset.output_file import write_output
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


@pytest.mark.parametrize("write", [replace_file, write_output])
def test_a_full_disk_names_the_file(tmp_path: Path, monkeypatch, write) -> None:
    """An error in the middle of writing has no file's name of its own."""

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr("os.fsync", full)
    with pytest.raises(OSError, match="No space left") as caught:
        write(tmp_path / "a", b"new")
    assert caught.value.filename == str(tmp_path / "a")
    assert list(tmp_path.iterdir()) == []
