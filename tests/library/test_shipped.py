"""The shipped library holds what it promises."""

import pytest
import yaml
from sdgen.catalog.load import load_catalog
from sdgen.library import Library
from sdgen.library.shape import corners_of
from sdgen.library.states import rest_states
from sdgen.library.supports import carried_share, headroom_m
from sdgen.resources import data_path
from sdgen.validate.assets import check_assets
from shapely.geometry import Polygon

from tests.by_path import ROOT, module_at
from tests.shipped import shipped_library

LIBRARY_LIMIT = 72_000_000
#: One model in so many is looked at closely here.
SAMPLE_STRIDE = 60


@pytest.fixture(scope="module")
def library() -> Library:
    return shipped_library()


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


def test_a_sample_of_the_models_is_sound(library: Library) -> None:
    """All of them are checked by 'make test-library' whenever the library changes."""
    assert check_assets([], load_catalog(), words=list(library.assets)[::SAMPLE_STRIDE]) == []


def test_geometries_are_counted_and_skins_are_not(
    library: Library, capsys: pytest.CaptureFixture[str]
) -> None:
    """By hand: nine mugs of six shapes, the others are skins or all but the same."""
    geometries = module_at("scripts/distinct_geometries.py")
    geometries.main(["mug"])
    assert capsys.readouterr().out.splitlines()[-1] == "6 distinct geometries in 9 models"
    first = library.by_category("mug")[0]
    assert geometries.count_shapes(library, [first, first]) == {"mug": [float("inf"), 0.0]}


def test_forms_of_single_models_are_states_of_the_manifest(library: Library) -> None:
    """What `standing_states.yaml` says is in the manifest, and the manifest says no more."""
    text = (ROOT / "assets" / "blender" / "standing_states.yaml").read_text(encoding="utf-8")
    said = {
        (f"{category}_{number:02d}", state)
        for state, groups in yaml.safe_load(text).items()
        for group in groups
        for category, numbers in group.items()
        for number in numbers
    }
    stands = {state for _, state in said}
    assert said == {
        (asset.id, state)
        for asset in library.assets.values()
        for state in rest_states(asset)
        if state in stands
    }


def test_a_leaf_that_is_ajar_is_open(library: Library) -> None:
    """OPEN begins where one sees it; nothing is said of what lies between it and CLOSED."""
    for category in ("fridge", "freezer", "front_door", "door", "wardrobe", "microwave"):
        for asset in library.by_category(category):
            for rule in asset.states:
                if rule.state == "OPEN" and asset.joint(rule.joint).type == "revolute":
                    assert 0.1 <= rule.min <= 0.3, asset.id


@pytest.mark.parametrize("category", ["sofa", "armchair", "bed", "office_chair", "bar_stool"])
def test_what_lies_on_a_seat_lies_on_what_is_drawn(library: Library, category: str) -> None:
    """Nowhere a centimetre over the cushion, and no cushion of a back in its way."""
    for asset in library.by_category(category):
        drawn = corners_of([library.mesh(asset.id)[part] for part in asset.variants["default"]])
        pieces = [hull.vertices_m for hull in library.hulls(asset.id)]
        for support in asset.supports:
            if support.container is None:
                outline = Polygon(support.polygon_m)
                assert carried_share(drawn, outline, support.z_m) == 1.0, asset.id
                assert headroom_m(drawn, outline, support.z_m) is None, asset.id
                tops = {round(float(points[:, 2].max()), 4) for points in pieces}
                assert support.z_m in tops, asset.id
