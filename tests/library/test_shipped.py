"""The shipped library holds what it promises."""

import importlib.util
from pathlib import Path
from types import ModuleType

import pytest
import yaml
from sdgen.library import Library, load_library
from sdgen.resources import data_path

ROOT = Path(__file__).resolve().parent.parent.parent
LIBRARY_LIMIT = 60_000_000


@pytest.fixture(scope="module")
def library() -> Library:
    return load_library()


def script(name: str) -> ModuleType:
    path = ROOT / "scripts" / f"{name}.py"
    spec = importlib.util.spec_from_file_location(name, path)
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_it_is_large_enough(library: Library) -> None:
    assert len(library.assets) >= 1300
    assert len(library.categories) >= 220


def test_it_is_small_enough() -> None:
    folder = data_path("assets")
    files = [
        folder / "manifest.yaml",
        *(folder / "meshes").iterdir(),
        *(folder / "textures").iterdir(),
    ]
    assert sum(path.stat().st_size for path in files) <= LIBRARY_LIMIT


def test_every_file_is_named_by_some_record(library: Library) -> None:
    named = {name for a in library.assets.values() for name in (a.mesh, a.hulls, a.texture)}
    named |= {part.texture for a in library.assets.values() for part in a.parts if part.texture}
    named |= {surface.texture for surface in library.surfaces.values()}
    folder = data_path("assets")
    lying = {
        path.relative_to(folder).as_posix()
        for kind in ("meshes", "textures")
        for path in (folder / kind).iterdir()
    }
    assert lying == named


@pytest.mark.parametrize(
    ("states", "least"),
    [
        ({"EXPIRED", "OVERRIPE"}, 20),
        ({"OPEN", "CLOSED"}, 30),
        ({"ON", "OFF"}, 18),
        ({"BROKEN"}, 14),
        ({"DIRTY"}, 6),
        ({"FULL"}, 8),
        ({"WET"}, 2),
        ({"SPILLED"}, 1),
    ],
)
def test_states(library: Library, states: set[str], least: int) -> None:
    able = [name for name, found in library.states_by_category().items() if states <= found]
    assert len(able) >= least


def test_every_category_says_where_its_size_comes_from() -> None:
    silent = []
    for path in sorted(data_path("hazard_catalog", "categories").glob("*.yaml")):
        for name, entry in yaml.safe_load(path.read_text(encoding="utf-8")).items():
            if entry.get("kind") != "structure" and not entry.get("source"):
                silent.append(name)
    assert silent == []


def test_synonyms_name_every_category(library: Library) -> None:
    text = (ROOT / "docs" / "blind-naming" / "synonyms.yaml").read_text(encoding="utf-8")
    assert set(library.categories) <= set(yaml.safe_load(text))


@pytest.mark.slow
def test_the_geometries_truly_differ(capsys: pytest.CaptureFixture[str]) -> None:
    script("distinct_geometries").main([])
    last = capsys.readouterr().out.splitlines()[-1]
    assert int(last.split()[0]) >= 600
