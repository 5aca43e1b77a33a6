"""Which differences between then and now a rebuild speaks of."""

from pathlib import Path
from types import SimpleNamespace

from sdgen.dataset import Dataset
from sdgen.dataset.versions import package_versions
from sdgen.validate.rebuild import rebuild

from tests import toy


def test_versions_that_decide_content_count_and_those_of_pictures_do_not(tmp_path: Path) -> None:
    versions = {**package_versions(), "zlib": "0.9", "pillow": "0.9", "numpy": "0.9"}
    with toy.open_writer(tmp_path, toy.small(n=1), versions=versions) as writer:
        toy.add_scene(writer, 0)
        writer.finish(renderers=("painted",))
    data = Dataset(tmp_path)
    library = SimpleNamespace(sha256=data.info.assets_sha256)
    (problem,) = rebuild(data, library, 0)  # type: ignore[arg-type]
    assert "versions.numpy: 0.9 then" in str(problem)
