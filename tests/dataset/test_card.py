"""The card: numbers of the files, code that runs, whom to credit."""

import re
from pathlib import Path

import pytest
import yaml
from sdgen.dataset import Dataset
from sdgen.dataset.card import card, histogram
from sdgen.looks import PRESETS
from sdgen.options import BuildOptions, command_of

from tests import toy


@pytest.fixture(scope="module")
def path(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return toy.build_with_twins(tmp_path_factory.mktemp("set") / "d", n=8)


def text(path: Path) -> str:
    return (path / "README.md").read_text(encoding="utf-8")


def test_its_numbers_are_those_of_the_files(path: Path) -> None:
    said, counts = text(path), Dataset(path).info.counts
    assert f"| scenes | {counts.scenes} (and {counts.twins} benign twins) |" in said
    for name in ("views", "objects", "anomalies", "lookalikes"):
        assert f"| {name} | {getattr(counts, name)} |" in said
    head = re.search(r"\| hazard \| what \| anomalies \| (.*) \|", said)
    assert head is not None
    splits = head[1].split(" | ")
    assert set(splits) == set(Dataset(path).info.splits)
    for hazard in Dataset(path).info.hazards_enabled:
        row = re.search(rf"\| `{hazard}` \| .* \|", said)
        assert row is not None
        numbers = [int(cell) for cell in row[0].split("|")[3:-1]]
        by_split = [
            sum(a.hazard == hazard for i in Dataset(path, split=s) for a in i.anomalies.anomalies)
            for s in splits
        ]
        assert numbers == [sum(by_split), *by_split]


def test_its_command_has_every_option_that_is_not_the_usual_one(path: Path) -> None:
    options = Dataset(path).info.options
    assert f"```sh\n{command_of(options)}\n```" in text(path)
    other = BuildOptions(
        n=3,
        seed=5,
        hazards_min=1,
        hazards_max=1,
        only=("spill", "stove_on"),
        extensions=("heat", "pets"),
        views=4,
        width=320,
        height=240,
        sensors=(),
        twins=True,
        assets_only=True,
    )
    assert command_of(other) == (
        "sdgen build --n 3 --seed 5 --hazards 1-1 --only spill,stove_on --extensions heat,pets "
        "--views 4 --size 320x240 --sensors none --twins --assets-only"
    )


def test_no_option_is_left_out_of_the_command() -> None:
    usual = BuildOptions()
    others = {
        **{"n": 11, "seed": 1, "homes": "base", "hazards_min": 1, "hazards_max": 4},
        **{"draw": "iid", "extensions": ("heat",), "views": 1, "width": 64, "height": 48},
        **{"sensors": ("rgb",), "rgb": "jpg", "supersample": 2, "renderer": "cpu"},
        **{"eye_height_m": 1.0, "twins": True, "toggles": True, "assets_only": True},
        **{"only": ("spill",), "observability": True, "look": PRESETS["robot"]},
        **{"views_mode": "panorama", "equirect": True},
    }
    assert set(others) == set(BuildOptions.model_fields)
    lines = {command_of(usual.model_copy(update={name: v})) for name, v in others.items()}
    assert len(lines - {command_of(usual)}) == len(others)


def test_it_tells_of_looks_and_turns(path: Path) -> None:
    info = Dataset(path).info
    assert "2 views of\n160 x 120 pixels" in text(path)
    assert not re.search("imperfect camera|Views are turns|panoramas", text(path))
    options = info.options.model_copy(
        update={"look": PRESETS["phone"], "views_mode": "panorama", "equirect": True}
    )
    said = card(info.model_copy(update={"options": options}))
    assert "a full turn of views in each room, of\n160 x 120 pixels" in said
    assert "`--look phone`" in said
    assert "Views are turns" in said
    assert "`panoramas/NN`" in said


def test_its_front_matter_is_what_hubs_read(path: Path) -> None:
    front = yaml.safe_load(text(path).split("---")[1])
    assert front["license"] == "cc-by-4.0"
    assert "household-safety" in front["tags"]


def test_its_code_runs(path: Path, tmp_path: Path) -> None:
    blind = toy.build(tmp_path / "blind", toy.small(n=2, sensors=()))
    for made in (path, blind):
        blocks = re.findall(r"```python\n(.*?)```", text(made), re.DOTALL)
        assert len(blocks) == 1
        exec(blocks[0].replace("path/to/this/folder", str(made)), {})


def test_histograms_count_everything() -> None:
    rows = histogram([0, 1, 1, 3], 1)
    assert [(name, number) for name, number, _ in rows] == [("0", 1), ("1", 2), ("2", 0), ("3", 1)]
    assert max(len(bar) for _, _, bar in rows) == 30
    assert [row[:2] for row in histogram([40, 60, 149], 50)] == [
        ("0-49", 1),
        ("50-99", 1),
        ("100-149", 1),
    ]
    assert histogram([], 5) == []


def test_models_of_others_are_credited(path: Path) -> None:
    data = Dataset(path)
    assets = [
        asset.model_copy(update={"source": "gso:1", "attribution": "By\nsomebody", "licence": "X"})
        for asset in data.infos.values()
    ]
    info = data.info.model_copy(update={"licence": "X"})
    said = card(info, data.entries, assets, data.catalog)
    assert f"- X: {len(assets)} models, by or from By somebody" in said
    assert "Licence of the scenes: X" in said
