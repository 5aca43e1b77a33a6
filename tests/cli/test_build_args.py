"""``sdgen build`` reads its options strictly and hands them on faithfully."""

from __future__ import annotations

import json
import os
from contextlib import suppress
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st
from sdgen.cli import build as build_module
from sdgen.cli import params
from sdgen.cli.build import Where
from sdgen.cli.disk import bytes_needed, human_bytes, nearest_folder
from sdgen.cli.main import run
from sdgen.cli.progress import summary
from sdgen.engines.report import BuildReport, SceneFailed
from sdgen.looks import PRESETS
from sdgen.options import BuildOptions
from sdgen.rejection import Cause


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> list[Any]:
    """What ``build`` would have asked the engine for, in an empty working folder."""
    calls: list[Any] = []

    def record(options: BuildOptions, where: Where, *rest: Any) -> BuildReport:
        calls.append(SimpleNamespace(options=options, out=where.out, where=where, rest=rest))
        return report(out=where.out, requested=options.n, made=options.n)

    monkeypatch.setattr(build_module, "carry_out", record)
    monkeypatch.chdir(tmp_path)
    return calls


def report(**changes: Any) -> BuildReport:
    values: dict[str, Any] = {
        "out": Path("d"),
        "requested": 10,
        "made": 10,
        "resumed": 0,
        "failed": (),
        "frames": 80,
        "seconds": 40.0,
        "peak_memory_mb": 812.0,
        "home_attempts": 12,
        "rejections": {Cause("home", "room_cut_off", category="kitchen"): 2},
        "anomalies": {"spill": 4, "stove_on": 5},
        "renderer": "egl llvmpipe",
    }
    return BuildReport(**(values | changes))


@pytest.mark.parametrize(
    "bad",
    [
        "--n -1",
        "--n x",
        "--n 1.5",
        "--seed x",
        "--seed -3",
        "--size 0x0",
        "--size 640",
        "--size 640x480x3",
        "--size 99999x10",
        "--hazards 5-2",
        "--hazards -1-2",
        "--hazards many",
        "--views -1",
        "--sensors rgb,lidar",
        "--sensors none,rgb",
        "--sensors rgb,none,depth",
        "--eye-height nan",
        "--eye-height inf",
        "--eye-height tall",
        "--eye-height 0.1",
        "--eye-height 2.3",
        "--out ",
        "--sensors ",
        "--rgb gif",
        "--supersample 3",
        "--renderer cuda",
        "--range 3:3",
        "--range 5",
        "--range 0:11",
        "--workers 0",
        "--engine spark",
        "--ray-address localhost:1",
        "--catalog nowhere",
        "--assets nowhere",
        "--homes castle",
        "--draw lucky",
    ],
)
def test_nonsense_is_a_usage_error(
    bad: str, asked: list[Any], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["build", *bad.split(" ", 1)]) == 2
    out, err = capsys.readouterr()
    assert out == ""
    assert bad.split()[0] in err
    assert len(err.splitlines()) == 1
    assert asked == []


def test_an_engine_that_is_not_installed_is_named_with_what_to_install(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr("sdgen.engines.registry.find_spec", lambda name: None)
    monkeypatch.chdir(tmp_path)
    assert run(["build", "--engine", "ray"]) == 2
    assert "pip install 'sdgen[ray]'" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("option", "words"),
    [
        ("--sensors none,rgb", "none stands alone"),
        ("--eye-height nan", "'nan' is no length"),
        ("--out ", "'' names no folder"),
    ],
)
def test_what_is_wrong_with_a_value_is_said(
    option: str, words: str, asked: list[Any], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["build", *option.split(" ", 1)]) == 2
    assert words in capsys.readouterr().err


def test_quiet_says_nothing_and_json_is_one_object(
    asked: list[Any], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["build", "--n", "4", "--quiet", "--json"]) == 0
    out, err = capsys.readouterr()
    assert err == ""
    found = json.loads(out)
    assert (found["requested"], found["made"], found["failed"]) == (4, 4, {})
    assert found["anomalies"] == {"spill": 4, "stove_on": 5}
    assert asked[0].rest == ((), (), True, None)


def test_defaults_are_those_of_the_contract(asked: list[Any]) -> None:
    assert run(["build"]) == 0
    assert asked[0].options == BuildOptions()
    assert asked[0].out == Path("output/sdgen-n10-s0")


def test_options_reach_the_engine(asked: list[Any]) -> None:
    command = (
        "build --n 5 --seed 7 --hazards 1-2 --views 3 --size 64x48 --sensors depth,rgb --rgb jpg "
        "--supersample 2 --renderer cpu --draw iid --workers 3 --range 1:4 --overwrite --twins "
        "--out here --engine ray --ray-address auto --non-commercial"
    )
    assert run(command.split()) == 0
    options = asked[0].options
    assert (options.n, options.seed, options.hazards_min, options.hazards_max) == (5, 7, 1, 2)
    assert (options.views, options.width, options.height) == (3, 64, 48)
    assert options.sensors == ("rgb", "depth")
    assert (options.rgb, options.supersample, options.renderer) == ("jpg", 2, "cpu")
    assert options.twins
    assert asked[0].out == Path("here")
    assert asked[0].where == Where(Path("here"), (1, 4), True, 3, "ray", "auto", True)
    assert asked[0].rest == ((), (), False, None)


def test_looks_and_turns_reach_the_engine(asked: list[Any]) -> None:
    command = "build --look phone,noise=0 --views-mode panorama --equirect"
    assert run(command.split()) == 0
    options = asked[0].options
    assert options.look == PRESETS["phone"].model_copy(update={"noise": 0.0})
    assert (options.views_mode, options.equirect) == ("panorama", True)


@pytest.mark.parametrize(
    ("command", "words"),
    [
        ("--look robto", "did you mean 'robot'"),
        ("--look blurr=1", "did you mean 'blur'"),
        ("--look noise=-1", "has no number from 0 to 0.5 for noise"),
        ("--equirect", "--equirect goes with --views-mode panorama"),
        ("--equirect --views-mode panorama --sensors depth", "and with rgb or instance"),
    ],
)
def test_looks_and_turns_that_make_no_sense(
    command: str, words: str, asked: list[Any], capsys: pytest.CaptureFixture[str]
) -> None:
    assert run(["build", *command.split()]) == 2
    assert words in " ".join(capsys.readouterr().err.split())


def test_own_models_alone_need_some(
    asked: list[Any], capsys: pytest.CaptureFixture[str], tmp_path: Path
) -> None:
    assert run(["build", "--n", "3", "--assets-only"]) == 2
    assert "--assets-only goes with --assets" in capsys.readouterr().err
    assert run(["build", "--n", "3", "--assets-only", "--assets", str(tmp_path)]) == 0
    assert asked[0].options.assets_only
    assert not asked[0].where.non_commercial


def test_only_some_hazards_are_drawn_each_once_a_scene(asked: list[Any]) -> None:
    assert run(["build", "--only", "stove_on,spill", "--only", "spill"]) == 0
    options = asked[0].options
    assert options.only == ("spill", "stove_on")
    assert (options.hazards_min, options.hazards_max) == (0, 2)
    assert run(["build", "--only", "spill", "--hazards", "0-3"]) == 0
    assert asked[1].options.hazards_max == 3  # refused, with a reason, by the build
    assert run(["build"]) == 0
    assert (asked[2].options.only, asked[2].options.hazards_max) == ((), 5)


def test_seed_zero_is_a_seed(asked: list[Any]) -> None:
    assert run(["build", "--seed", "0", "--n", "3"]) == 0
    assert asked[0].options.seed == 0
    assert asked[0].out.name == "sdgen-n3-s0"


def test_says_how_much_disk_it_needs(asked: list[Any], capsys: pytest.CaptureFixture[str]) -> None:
    assert run(["build", "--n", "20"]) == 0
    assert "needs about" in capsys.readouterr().err


def test_a_disk_too_small_is_refused_before_the_start(
    asked: list[Any], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    usage = SimpleNamespace(free=1_000_000)
    monkeypatch.setattr("sdgen.cli.disk.shutil.disk_usage", lambda _: usage)
    assert run(["build", "--n", "200"]) == 1
    assert "free; choose another --out" in capsys.readouterr().err
    assert asked == []


def test_out_below_a_file_is_refused(asked: list[Any], capsys: pytest.CaptureFixture[str]) -> None:
    Path("letter").write_text("dear", encoding="utf-8")
    assert run(["build", "--out", "letter/homes"]) == 1
    assert "is a file, not a folder" in capsys.readouterr().err
    assert Path("letter").read_text(encoding="utf-8") == "dear"


def test_out_that_may_not_be_written_is_refused(
    asked: list[Any], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    # Root may write anywhere, so ask the operating system to say no.
    monkeypatch.setattr(os, "access", lambda *_: False)
    assert run(["build"]) == 1
    assert "may not write" in capsys.readouterr().err
    assert asked == []


def test_missing_scenes_exit_3_and_are_named(
    asked: list[Any], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    failed = (SceneFailed(4, "000004", {Cause("home", "no_free_floor"): 5}),)
    monkeypatch.setattr(build_module, "carry_out", lambda *_: report(made=9, failed=failed))
    assert run(["build"]) == 3
    assert "1 of 10 scenes could not be made: 000004" in capsys.readouterr().err


def test_the_account_for_programs_counts_causes_in_fields(
    asked: list[Any], capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    # Both read "spill: no place (mug)": one would have taken the other's place.
    causes = {
        Cause("hazards", "no_place", hazard="spill", category="mug"): 3,
        Cause("twin", "no_place", hazard="spill", category="mug"): 2,
    }
    made = report(made=9, failed=(SceneFailed(4, "000004", causes),), rejections=causes)
    monkeypatch.setattr(build_module, "carry_out", lambda *_: made)
    assert run(["build", "--json"]) == 3
    told = json.loads(capsys.readouterr().out)
    fields = {"check": "no_place", "hazard": "spill", "category": "mug"}
    fields |= {"other": None, "state": None}
    counted = [
        {"stage": "hazards", **fields, "count": 3},
        {"stage": "twin", **fields, "count": 2},
    ]
    assert told["rejections"] == counted
    assert told["failed"] == {"000004": counted}


def test_closing_table_has_the_promised_figures() -> None:
    text = summary(report())
    rows = {line[:12].strip(): line[12:].strip() for line in text.splitlines()}
    assert rows["homes/h"] == "900"
    assert rows["frames/s"] == "2.00"
    assert rows["peak memory"] == "812 MB"
    assert rows["accepted"] == "83% of 12 homes tried"
    assert rows["rejections"] == "home x2 (room cut off (kitchen) x2)"
    assert rows["anomalies"] == "stove_on x5, spill x4"


@given(st.text(max_size=12))
def test_parsers_never_crash(text: str) -> None:
    for parse in (params.size, params.hazard_count, params.scene_range, params.sensor_list):
        with suppress(ValueError):
            assert isinstance(parse(text), tuple)


@given(st.integers(16, 4096), st.integers(16, 4096))
def test_sizes_round_trip(width: int, height: int) -> None:
    assert params.size(f"{width}x{height}") == (width, height)


def test_disk_need_grows_with_what_is_written() -> None:
    plain = BuildOptions(sensors=())
    jpg = BuildOptions(rgb="jpg")
    png = BuildOptions()
    needs = [bytes_needed(options, 10) for options in (plain, jpg, png)]
    assert needs == sorted(needs)
    assert needs[0] < needs[-1]
    assert bytes_needed(png, 20) == 2 * bytes_needed(png, 10)


@pytest.mark.parametrize(
    ("count", "text"),
    [(0, "0 B"), (999, "999 B"), (1000, "1.0 kB"), (25_400_000, "25 MB"), (1.2e13, "12.0 TB")],
)
def test_human_bytes(count: float, text: str) -> None:
    assert human_bytes(count) == text


def test_nearest_folder_is_one_that_exists(tmp_path: Path) -> None:
    assert nearest_folder(tmp_path / "a" / "b") == tmp_path
