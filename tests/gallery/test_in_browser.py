"""The gallery in headless Chromium, from disk: filters, keys, masks, twins, graph and 3-D."""

import io
import json
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from PIL import Image
from sdgen.dataset import Dataset
from sdgen.gallery import write_gallery

from tests import browser, toy
from tests.edits import reseal
from tests.shipped import shipped_library

SAMPLE = Path(__file__).resolve().parents[2] / "output" / "sample"
pytestmark = [
    pytest.mark.skipif(browser.chromium() is None, reason="no Chromium on this machine"),
    pytest.mark.xdist_group("browser"),  # one browser, one worker
]
SHOWN = "[...document.querySelectorAll('.card')].map((card) => card.dataset.id)"


@pytest.fixture(scope="module")
def page() -> Iterator[browser.Page]:
    with browser.browser() as found:
        found.size(1200, 800)
        yield found


@pytest.fixture(scope="module")
def toys(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A gallery of boxes with twins, from a place with an odd name."""
    path = toy.build_with_twins(tmp_path_factory.mktemp("a set & #1") / "d")
    return write_gallery(Dataset(path), path / "view").index


@pytest.fixture(scope="module")
def homes(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A gallery of the committed sample with its models."""
    out = tmp_path_factory.mktemp("gallery") / "view"
    return write_gallery(Dataset(SAMPLE), out, library=shipped_library()).index


def opened(page: browser.Page, index: Path, hash_: str = "") -> None:
    page.open(index.resolve().as_uri() + hash_)
    page.until(
        "document.querySelectorAll('.card').length > 0 || !!document.querySelector('#tree svg')"
    )


def scene(page: browser.Page, index: Path, name: str, hash_: str = "") -> None:
    opened(page, index.parent / name / "index.html", hash_)
    assert page.problems() == []


def test_filters_are_in_the_address_and_back_goes_back(page: browser.Page, toys: Path) -> None:
    opened(page, toys)
    assert page.run(SHOWN) == ["000000", "000001", "000002", "000003"]
    page.run(
        "document.forms[0].hazard.value = 'sharp_object';"
        "document.forms[0].hazard.dispatchEvent(new Event('change', {bubbles: true}))"
    )
    assert page.run(SHOWN) == ["000002", "000003"]
    assert page.run("location.hash") == "#hazard=sharp_object"
    page.run(
        "document.forms[0].split.value = 'test';"
        "document.forms[0].split.dispatchEvent(new Event('change', {bubbles: true}))"
    )
    assert page.run(SHOWN) == ["000002"]
    page.run("history.back()")
    page.until("location.hash === '#hazard=sharp_object'")
    page.until(f'JSON.stringify({SHOWN}) === \'["000002","000003"]\'')
    assert page.run("document.forms[0].split.value") == ""
    assert page.problems() == []


@pytest.mark.parametrize(
    ("address", "shown"),
    [
        ("#hazard=stove_on&q=000003", ["000003"]),
        ("#hazard=none", ["000000"]),
        ("#twin=twin", [f"00000{k}-twin" for k in range(4)]),
        ("#room=kitchen&household=toy&split=val", ["000001"]),
        ("#twin=all&q=000003", ["000003", "000003-twin"]),
        ("#hazard=<b>&what=ever", ["000000", "000001", "000002", "000003"]),
    ],
)
def test_an_address_can_be_shared(
    page: browser.Page, toys: Path, address: str, shown: list[str]
) -> None:
    opened(page, toys, address)
    assert page.run(SHOWN) == shown
    total = 8 if "twin=all" in address else 4
    assert page.run("document.getElementById('count').textContent") == f"{len(shown)} of {total}"


def test_keys_walk_from_card_to_card_and_open_one(page: browser.Page, toys: Path) -> None:
    opened(page, toys)
    page.press("ArrowRight")
    page.press("ArrowRight")
    assert page.run("document.activeElement.dataset.id") == "000001"
    assert page.run("getComputedStyle(document.activeElement).outlineStyle") == "solid"
    page.press("Enter")
    page.until("document.title === 'scene 000001'")
    page.until("!!document.querySelector('#tree svg')")
    page.press("ArrowRight")
    page.until("document.title === 'scene 000002'")
    page.until("!!document.querySelector('#tree svg')")
    page.press("Escape")
    page.until("document.querySelectorAll('.card').length > 0")
    page.press("/")
    assert page.run("document.activeElement.name") == "q"
    for key in "no such":
        page.press(key)
    assert page.run(SHOWN) == []
    page.press("Escape")
    assert page.run(SHOWN) == ["000000", "000001", "000002", "000003"]


def test_masks_boxes_and_depth_are_shown_and_hidden(page: browser.Page, toys: Path) -> None:
    scene(page, toys, "000003")
    boxes = "getComputedStyle(document.querySelector('.stack g.{}')).display"
    assert page.run(boxes.format("anomaly")) != "none"
    assert page.run(boxes.format("object")) == "none"
    page.run("document.querySelector('[data-show=anomaly]').click()")
    page.run("document.querySelector('[data-show=object]').click()")
    assert page.run(boxes.format("anomaly")) == "none"
    assert page.run(boxes.format("object")) != "none"
    masks = "[...document.querySelectorAll('img.over.mask')]"
    assert page.run(f"{masks}.length") == 0
    page.run("document.getElementById('masks').click()")
    page.run("document.getElementById('views').scrollIntoView()")
    page.until(f"{masks}.length === 2 && {masks}.every((one) => one.naturalWidth === 160)")
    page.run("document.getElementById('masks').click()")
    assert page.run(f"{masks}.length") == 0
    page.run("layer.value = 'depth'; layer.dispatchEvent(new Event('change'))")
    assert page.run("document.querySelector('.picture').getAttribute('src')") == "00-depth.png"


def test_a_slider_wipes_the_twin_over_its_scene(page: browser.Page, toys: Path) -> None:
    scene(page, toys, "000003")
    page.run("other.value = '0'; other.dispatchEvent(new Event('change'))")
    page.run("document.getElementById('views').scrollIntoView()")
    page.until("[...document.querySelectorAll('img.wiped')].every((one) => one.naturalWidth)")
    assert "000003-twin" in page.run("document.querySelector('img.wiped').src")
    page.run(
        "const one = document.querySelector('.wipe'); one.focus(); one.value = 250;"
        "one.dispatchEvent(new Event('input'))"
    )
    assert "25%" in page.run("getComputedStyle(document.querySelector('.wiped')).clipPath")
    page.press("ArrowRight")
    assert page.run("document.title") == "scene 000003"  # a slider's own key
    assert page.run("document.querySelectorAll('.wipe').length") == 2


def test_the_graph_is_drawn_searched_and_walked(page: browser.Page, toys: Path) -> None:
    scene(page, toys, "000003")
    node = "document.querySelector('#tree [data-id=\"{}\"]')"
    assert page.run(f"!!{node.format(600)}")  # the way to an anomaly is open
    page.run("document.getElementById('fold').click()")
    assert not page.run(f"!!{node.format(600)}")
    page.run(
        "const search = document.getElementById('find'); search.value = 'knife';"
        "search.dispatchEvent(new Event('input'))"
    )
    assert page.run("document.getElementById('found').textContent") == "2 found"
    assert page.run(f"{node.format(600)}.classList.contains('hit')")
    page.run(f"{node.format(600)}.dispatchEvent(new MouseEvent('click', {{bubbles: true}}))")
    told = page.run("document.getElementById('node').innerText")
    assert "A child can reach the knife on the kitchen table in the kitchen." in told
    assert "kitchen table 77" in told
    page.press("ArrowUp")
    assert page.run("document.activeElement.dataset.id") != "600"


def test_boxes_stand_for_models_that_are_not_there(page: browser.Page, toys: Path) -> None:
    scene(page, toys, "000003", "#3d")
    page.until("!!stage.dataset.ready")
    assert "8 of 8 models are drawn as boxes: not at hand" in page.run("panel.innerText")
    assert page.problems() == []


def test_a_home_in_3d_tells_the_hazard_that_is_clicked(page: browser.Page, homes: Path) -> None:
    item, anomaly, height_m = next(
        (item, one, one.evidence[key])
        for item in Dataset(SAMPLE)
        for one in item.anomalies.anomalies
        for key in ("reach_height_m", "height_m")
        if key in one.evidence and "climbed_id" not in one.evidence
    )
    scene(page, homes, item.id, f"#3d={anomaly.object_id}")
    page.until(f"stage.dataset.chosen === '{anomaly.object_id}'")
    assert anomaly.message in page.run("panel.innerText")
    # The heights that make it one are drawn, with their numbers.
    said = page.run(
        "[...document.querySelectorAll('.overlay .said')].map((one) => one.textContent)"
    )
    assert f"height {height_m:.2f} m" in said
    # Let go of it, and click where it is seen.
    page.run("document.querySelector('#panel button').click()")
    assert page.run("stage.dataset.chosen") == ""
    page.run("stage.scrollIntoView({block: 'center'})")
    place = page.run(f"sdgen.openSpace().then((space) => space.where({anomaly.object_id}))")
    page.click(*place)
    assert page.run("stage.dataset.chosen") == str(anomaly.object_id)
    assert anomaly.message in page.run("panel.innerText")
    assert page.problems() == []


def test_the_3d_view_is_not_empty(page: browser.Page, homes: Path) -> None:
    scene(page, homes, "000001", "#3d")
    page.until("!!stage.dataset.ready")
    page.run("stage.scrollIntoView({block: 'center'})")
    left, top, wide, high = page.run(
        "(({x, y, width, height}) => [x, y, width, height])(stage.getBoundingClientRect())"
    )
    image = Image.open(io.BytesIO(page.picture())).convert("RGB")
    shown = np.asarray(image.crop((round(left), round(top), round(left + wide), round(top + high))))
    assert len(np.unique(shown.reshape(-1, 3), axis=0)) > 2000
    names = page.run("sdgen.data.models.length")
    assert names > 100
    assert page.run("[...sdgen.models.keys()].length") == names


def test_a_near_miss_tells_which_rule_it_misses(page: browser.Page, homes: Path) -> None:
    near = Dataset(SAMPLE)[0].anomalies.lookalikes[0]
    scene(page, homes, "000000", f"#3d={near.object_id}")
    page.until(f"stage.dataset.chosen === '{near.object_id}'")
    told = page.run("panel.innerText")
    assert f"near miss of {near.near_miss_of.replace('_', ' ')}" in told
    assert "It misses:" in told


def test_nothing_of_a_phone_page_is_wider_than_the_phone(page: browser.Page, toys: Path) -> None:
    page.size(390, 844, phone=True)
    try:
        for file in (toys, toys.parent / "000003/index.html"):
            opened(page, file)
            assert page.run("document.documentElement.scrollWidth") <= 390, file
    finally:
        page.size(1200, 800)


def test_strangers_text_runs_nothing(page: browser.Page, tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    hostile = "</script><img src=x onerror='window.hacked = true'>"
    for name, change in (
        ("anomalies.json", lambda data: data["anomalies"][0].update(message=hostile)),
        ("household.json", lambda data: data.update(template=hostile, pets=[hostile])),
        ("scene.json", lambda data: data["home"]["rooms"][0].update(name=hostile)),
    ):
        file = path / "scenes/000001" / name
        data = json.loads(file.read_text(encoding="utf-8"))
        change(data)
        file.write_text(json.dumps(data), encoding="utf-8")
    reseal(path)
    index = write_gallery(Dataset(path), path / "view").index
    opened(page, index)
    assert hostile.replace("_", " ") in page.run("document.forms[0].household.innerText")
    scene(page, index, "000001", "#3d=11")
    page.until("stage.dataset.chosen === '11'")
    assert hostile in page.run("panel.innerText")
    page.run("document.getElementById('unfold').click()")
    assert page.run("window.hacked") is None
