"""The page: every scene on it, every link alive, nothing from outside, nothing executed."""

import json
import re
from collections.abc import Callable
from html.parser import HTMLParser
from pathlib import Path
from typing import Any
from urllib.parse import unquote

import numpy as np
import pytest
from sdgen.dataset import Dataset
from sdgen.errors import InputError, SdgenError
from sdgen.gallery import write_gallery
from sdgen.gallery.drawing import draw_home
from sdgen.gallery.pictures import depth_colours, mask_colours, thumbnail
from sdgen.validate import validate

from tests import toy
from tests.edits import reseal

VOID = {"meta", "link", "img", "br", "input"}


class Page(HTMLParser):
    """Links and tags of a page; fails on tags that do not nest."""

    def __init__(self, path: Path) -> None:
        super().__init__()
        self.links: list[str] = []
        self.open: list[str] = []
        self.scripts = 0
        self.feed(path.read_text(encoding="utf-8"))
        assert self.open == []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        for name, value in attrs:
            assert not name.startswith("on"), name
            linked = name in ("src", "href") or name.startswith("data-")
            if linked and name not in ("data-show", "data-space") and value:
                self.links.append(value)
        if tag == "script":
            assert dict(attrs).get("src"), "a script in the page"
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        """Self-closing: nothing stays open."""

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


@pytest.fixture(scope="module")
def page(tmp_path_factory: pytest.TempPathFactory) -> Path:
    path = toy.build(tmp_path_factory.mktemp("a set & <more>") / "d")
    shown = write_gallery(Dataset(path), path / "view")
    assert (shown.scenes, shown.total) == (4, 4)
    return shown.index


def test_every_link_leads_to_a_file_and_none_leads_out(page: Path) -> None:
    files = [page, *sorted(page.parent.glob("*/index.html"))]
    assert len(files) == 5
    for file in files:
        for link in Page(file).links:
            assert not re.match(r"[a-z]+:|//", link), link
            if not link.startswith("#"):
                assert (file.parent / unquote(link)).is_file(), (file, link)


def test_no_page_names_another_host(page: Path) -> None:
    for file in page.parent.rglob("*.*"):
        if file.suffix in (".html", ".css", ".js"):
            text = file.read_text(encoding="utf-8")
            # The names of XML's own name spaces are addresses that nobody goes to.
            text = re.sub(r"http://www\.w3\.org/\d{4}/\w+", "", text)
            assert not re.search(r"https?://\w|[\"'(]//\w", text), file


def test_a_scene_shows_anomalies_lookalikes_household_and_boxes(page: Path) -> None:
    text = (page.parent / "000003/index.html").read_text(encoding="utf-8")
    item = Dataset(page.parent.parent)[3]
    for anomaly in item.anomalies.anomalies:
        assert anomaly.message in text
        assert f"{anomaly.category} {anomaly.object_id}".replace("_", " ") in text
    assert "knife 512" in text
    assert "child, 5" in text
    shown = [thing.object_id for view in item.visibility.views for thing in view.objects]
    assert text.count('<g class="anomaly">') == shown.count(11) + shown.count(600) + shown.count(
        4000
    )
    assert text.count('<g class="lookalike">') == shown.count(512) > 0
    assert {11, 600, 4000} <= set(shown)
    box = {o.object_id: o for o in item.visibility.views[0].objects}[600].bbox
    x, y, w, h = box
    assert f'<rect x="{x}" y="{y}" width="{w}" height="{h}"><title>knife: sharp object' in text
    assert "An adult of 38, an adult of 36 and a child of 5 live here." in text


def test_a_scene_says_which_rules_its_near_miss_keeps_and_misses(page: Path) -> None:
    text = (page.parent / "000003/index.html").read_text(encoding="utf-8")
    card = text[text.index('<span class="near">knife 512</span> near miss of sharp object') :]
    missed, kept = card[: card.index("show in 3-D")].split("what it shares with one")
    assert "its lowest point is at most 1.44 m above where a child gets to stand" in missed
    assert "above where a child can stand 1.80 m" in missed
    assert "kind: knife, scissors, razor … (11 kinds)" in kept


def index_of(page: Path) -> dict[str, Any]:
    """What ``scenes.js`` says, words put in, by id."""
    text = (page.parent / "scenes.js").read_text(encoding="ascii")
    index = json.loads(text.removeprefix("sdgen.index(").removesuffix(");\n"))
    words = index["words"]
    out = {}
    for name, home, kind, split, household, rooms, hazards, crop, overview, *rest in index["rows"]:
        out[name] = {
            "home": home,
            "kind": words["kind"][kind],
            "split": words["split"][split],
            "household": words["household"][household],
            "rooms": [words["rooms"][k] for k in rooms],
            "hazards": {words["hazards"][k]: n for k, n in zip(*[iter(hazards)] * 2, strict=True)},
            "crop": crop,
            "overview": overview,
            "rest": rest,
        }
    return out


def test_the_index_has_what_its_filters_ask_for(page: Path) -> None:
    index = index_of(page)
    assert list(index) == ["000000", "000001", "000002", "000003"]
    assert index["000000"]["hazards"] == {}
    assert set(index["000003"]["hazards"]) == {"refrigerated_food_out", "sharp_object", "stove_on"}
    for item in Dataset(page.parent.parent):
        row = index[item.id]
        assert (row["split"], row["home"]) == (item.entry.split, item.entry.home)
        assert (row["kind"], row["household"]) == ("scene", "toy")
        assert row["rooms"] == ["kitchen", "living_room"]
        assert bool(row["crop"]) == bool(item.entry.anomalies)
        for name in filter(None, (row["crop"], row["overview"])):
            assert (page.parent / item.id / name).is_file()


def test_twins_have_pages_and_are_compared_with_their_scenes(tmp_path: Path) -> None:
    path = toy.build_with_twins(tmp_path / "d", n=2, toggles=True)
    told: list[tuple[int, int]] = []
    shown = write_gallery(Dataset(path), path / "view", None, lambda k, n: told.append((k, n)))
    assert (shown.scenes, shown.total, told[-1]) == (2, 2, (5, 5))
    kinds = {name: row["kind"] for name, row in index_of(shown.index).items()}
    assert kinds == {
        "000000": "scene",
        "000000-twin": "twin",
        "000001": "scene",
        "000001-twin": "twin",
        "000001-undo-a00": "toggle",
    }
    text = (path / "view/000001/index.html").read_text(encoding="utf-8")
    assert '<option value="0">its twin</option>' in text
    assert '<option value="1">a00 undone</option>' in text
    assert 'data-other-0="../../scenes/000001-twin/views/00/rgb.png"' in text
    text = (path / "view/000001-twin/index.html").read_text(encoding="utf-8")
    assert '<option value="0">the scene itself</option>' in text
    assert "What was undone" in text
    for file in path.glob("view/*/index.html"):
        for link in Page(file).links:
            assert link.startswith("#") or (file.parent / unquote(link)).is_file(), (file, link)


def test_a_scenes_cover_is_the_view_that_shows_its_hazards(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d")
    index = write_gallery(Dataset(path), path / "view").index
    item = Dataset(path)[3]
    first, second = (thumbnail(item.rgb(view)) for view in (0, 1))
    assert first != second
    assert (index.parent / "000003/overview.jpg").read_bytes() == first
    file = path / "scenes/000003/visibility.json"
    data = json.loads(file.read_text(encoding="utf-8"))
    one, other = data["views"]
    one["objects"], other["objects"] = other["objects"], one["objects"]
    for shown in data["anomalies"]:
        shown["evidence_pixels"].reverse()
    file.write_text(json.dumps(data), encoding="utf-8")
    reseal(path)
    write_gallery(Dataset(path), path / "view")
    assert (index.parent / "000003/overview.jpg").read_bytes() == second
    assert (index.parent / "000000/overview.jpg").is_file()


def test_views_that_visibility_leaves_out_are_told(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d")
    file = path / "scenes/000003/visibility.json"
    data = json.loads(file.read_text(encoding="utf-8"))
    data["anomalies"][0]["evidence_pixels"].pop()
    file.write_text(json.dumps(data), encoding="utf-8")
    reseal(path)
    with pytest.raises(InputError, match=r"000003.*see sdgen validate"):
        write_gallery(Dataset(path), path / "view")


def test_the_page_leaves_the_data_set_sound(page: Path) -> None:
    assert validate(page.parent.parent) == []


def test_strangers_text_is_escaped(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    file = path / "scenes/000001/anomalies.json"
    data = json.loads(file.read_text(encoding="utf-8"))
    hostile = '<script>alert(1)</script>"><img src=x onerror=alert(1)>'
    data["anomalies"][0]["message"] = hostile
    file.write_text(json.dumps(data), encoding="utf-8")
    scene = path / "scenes/000001/scene.json"
    data = json.loads(scene.read_text(encoding="utf-8"))
    data["home"]["rooms"][0]["name"] = hostile + "\u2028"
    scene.write_text(json.dumps(data), encoding="utf-8")
    reseal(path)
    index = write_gallery(Dataset(path), path / "view").index
    shown = (index.parent / "000001/index.html").read_text(encoding="utf-8")
    assert "&lt;script&gt;alert" in shown
    assert "<script>alert" not in shown
    Page(index.parent / "000001/index.html")
    script = (index.parent / "000001/data.js").read_bytes()
    assert b"<" not in script
    assert script.isascii()


@pytest.mark.parametrize("sensors", [(), ("depth",), ("rgb",)])
def test_missing_sensors_leave_no_dead_link(tmp_path: Path, sensors: tuple[str, ...]) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2, sensors=sensors))
    page = write_gallery(Dataset(path), tmp_path / "elsewhere" / "page").index
    overview = "overview.jpg" if "rgb" in sensors else "plan.svg"
    assert {row["overview"] for row in index_of(page).values()} == {overview}
    for file in (page, *page.parent.glob("*/index.html")):
        for link in Page(file).links:
            assert link.startswith("#") or (file.parent / unquote(link)).is_file(), link


def test_a_limit_shows_the_first_scenes(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d")
    shown = write_gallery(Dataset(path), path / "view", limit=2)
    assert (shown.scenes, shown.total) == (2, 4)
    assert len(list((path / "view").glob("*/index.html"))) == 2


def test_a_page_is_written_again_but_nothing_else_is_written_over(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    first = write_gallery(Dataset(path), path / "view").index.read_bytes()
    assert write_gallery(Dataset(path), path / "view").index.read_bytes() == first
    (tmp_path / "mine").mkdir()
    (tmp_path / "mine" / "index.html").write_text("mine")
    for place in (tmp_path / "mine", path, path / "dataset.json"):
        with pytest.raises(SdgenError):
            write_gallery(Dataset(path), place)
    assert (tmp_path / "mine" / "index.html").read_text() == "mine"


def _no_model(path: Path) -> None:
    (path / "assets.jsonl").write_bytes(b"")


def _no_picture(path: Path) -> None:
    (path / "scenes/000001/views/00/rgb.png").write_bytes(b"\x89PNG")
    reseal(path)


@pytest.mark.parametrize(
    ("damage", "words"),
    [
        (_no_model, "asset: 'stove_01' is not in assets.jsonl"),
        (_no_picture, "not a readable picture"),
    ],
)
def test_a_broken_scene_is_located_and_leaves_no_half_page(
    tmp_path: Path, damage: Callable[[Path], None], words: str
) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=2))
    damage(path)
    with pytest.raises(InputError, match=words):
        write_gallery(Dataset(path), path / "view")
    assert not (path / "view").exists()


def test_a_page_killed_half_way_is_written_again(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    page = write_gallery(Dataset(path), path / "view").index
    page.unlink()  # the index comes last
    assert write_gallery(Dataset(path), path / "view").index.is_file()


def test_another_folder_with_a_style_is_not_written_over(tmp_path: Path) -> None:
    path = toy.build(tmp_path / "d", toy.small(n=1))
    (tmp_path / "mine").mkdir()
    for name in ("index.html", "style.css"):
        (tmp_path / "mine" / name).write_text("mine")
    with pytest.raises(SdgenError, match="is not empty"):
        write_gallery(Dataset(path), tmp_path / "mine")
    assert (tmp_path / "mine" / "style.css").read_text() == "mine"


def test_mask_colours_tell_ids_apart() -> None:
    ids = np.random.default_rng(0).permutation(65535)[:200].astype(np.uint16) + 1
    colours = mask_colours(ids[None, :])
    assert len({tuple(c) for c in colours[0].tolist()}) >= 198
    assert mask_colours(np.zeros((1, 1), dtype=np.uint16)).max() == 0


def test_depth_colours_go_from_light_to_dark() -> None:
    shades = depth_colours(np.array([[0, 300, 2000, 5000, 60000]], dtype=np.uint16)).sum(axis=2)[0]
    assert shades[0] == 0
    assert shades[1] > shades[2] > shades[3] > shades[4] > 0


def test_a_rooms_name_lies_in_the_room() -> None:
    made = toy.bundle(3).scene
    corner = ((1.0, 0.0), (4.0, 0.0), (4.0, 3.0), (2.0, 3.0), (2.0, 1.0), (1.0, 1.0))
    room = made.home.rooms[0].model_copy(update={"polygon_m": corner})
    home = made.home.model_copy(update={"rooms": (room, *made.home.rooms[1:])})
    drawing = draw_home(made.model_copy(update={"home": home}), toy.infos(), (), (), ())
    left, _, name = drawing.names[0]
    assert name == "kitchen"
    assert left >= 2.0 * 60  # right of the corner that is missing


def test_the_drawing_keeps_everything_inside_its_frame() -> None:
    made = toy.bundle(3)
    found = draw_home(made.scene, toy.infos(), (), {600}, {512})
    kinds = [shape.kind for shape in found.shapes]
    assert kinds[-2:] == ["anomaly", "lookalike"] or kinds[-2:] == ["lookalike", "anomaly"]
    assert kinds.count("room") == 2
    for shape in found.shapes:
        for point in shape.points.split():
            x, y = map(float, point.split(","))
            assert 0 <= x <= found.width
            assert 0 <= y <= found.height
