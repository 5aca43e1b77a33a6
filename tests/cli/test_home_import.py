"""``sdgen home import``, and ``sdgen build --homes FILE``: from a stranger's file to scenes."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from click.testing import CliRunner
from sdgen.cli.main import cli, run

from tests.importing.scenes.homes import ROOMS, THINGS, write_glb

#: A knife on the bedroom floor: the model is ours, as a node of our own export says.
KNIFE = {"category": "knife", "model": "knife_01", "room": "floor_bedroom"}


@pytest.fixture
def glb(tmp_path: Path) -> Path:
    return write_glb(tmp_path / "home.glb", {**ROOMS, **THINGS})


def test_the_whole_way(glb: Path, tmp_path: Path) -> None:
    out = tmp_path / "my_flat.yaml"
    words = ["home", "import", "gltf", str(glb), "-o", str(out)]
    told = CliRunner().invoke(cli, words)
    assert told.exit_code == 0, told.output
    assert "left out: Alien Artefact: " in told.output
    assert "2 rooms" in told.output.splitlines()[-1]
    said = json.loads(CliRunner().invoke(cli, [*words, "--json"]).output)
    assert said["rooms"] == 2
    assert said["furniture"] == 4
    assert len(said["unresolved"]) == 1
    built = tmp_path / "built"
    words = f"build --n 2 --seed 3 --hazards 1-2 --homes {out} --views 4 --sensors none --quiet"
    done = CliRunner().invoke(cli, [*words.split(), "--workers", "1", "--out", str(built)])
    assert done.exit_code == 0, done.output
    lines = (built / "manifest.jsonl").read_text().splitlines()
    assert [json.loads(line)["home"] for line in lines] == ["my_flat", "my_flat"]
    assert all(json.loads(line)["anomalies"] for line in lines)
    assert run(["validate", str(built)]) == 0


def with_knife(glb: Path) -> Path:
    """The file with a knife as our own export would write it."""
    raw = glb.read_bytes()
    size = int.from_bytes(raw[12:16], "little")
    document = json.loads(raw[20 : 20 + size])
    for node in document["nodes"]:
        if node.get("name") == "Alien Artefact":
            node.update(name="knife_1", extras={"sdgen": KNIFE})
            node["matrix"] = [0, 0, -1, 0, -1, 0, 0, 0, 0, 1, 0, 0, 5.0, 0.01, -0.6, 1]
    text = json.dumps(document).encode()
    text += b" " * (-len(text) % 4)
    chunks = len(text).to_bytes(4, "little") + b"JSON" + text + raw[20 + size :]
    glb.write_bytes(b"glTF\x02\0\0\0" + (12 + len(chunks)).to_bytes(4, "little") + chunks)
    return glb


@pytest.mark.parametrize("violating", ["remove", "label"])
def test_what_was_a_hazard_is_left_out_or_labelled(
    violating: str, glb: Path, tmp_path: Path
) -> None:
    out = tmp_path / "my_flat.yaml"
    words = ["home", "import", "gltf", str(with_knife(glb)), "-o", str(out)]
    told = CliRunner().invoke(cli, [*words, "--violating", violating])
    assert told.exit_code == 0, told.output
    text = out.read_text()
    if violating == "remove":
        assert "left out: knife in floor_bedroom: is a hazard as it is: sharp_object" in told.output
        assert "category: knife" not in text
    else:
        assert "1 things (1 labelled)" in told.output
        assert "anomaly: sharp_object" in text


@pytest.mark.parametrize(
    ("words", "code", "text"),
    [
        (["gltf", "none.glb", "-o", "a.yaml"], 2, "does not exist"),
        (["fbx", "home.glb", "-o", "a.yaml"], 2, "is not one of"),
        (["gltf", "home.glb", "-o", "a.glb"], 2, "with .yaml at its end"),
        (["gltf", "home.glb", "-o", "My Flat.yaml"], 2, "'My Flat' is not a name"),
        (["gltf", "home.glb", "-o", "apartment_1.yaml"], 2, "a home called 'apartment_1' already"),
        (["mjcf", "home.glb", "-o", "a.yaml"], 1, "not valid XML"),
        (["virtualhome", "home.glb", "-o", "a.yaml"], 1, "is no JSON"),
        (["gltf", "home.glb"], 2, "Missing option"),
    ],
)
def test_bad_words(
    words: list[str],
    code: int,
    text: str,
    glb: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(glb.parent)
    assert run(["home", "import", *words]) == code
    error = capsys.readouterr().err
    assert text in error
    assert "Traceback" not in error
    assert "unexpected" not in error
    assert not list(glb.parent.glob("*.yaml"))


@pytest.mark.parametrize(
    ("homes", "text"),
    [
        ("bsae", "did you mean 'base'?"),
        ("none.yaml", "is no file"),
        ("home.glb", "nor a FILE.yaml"),
    ],
)
def test_bad_homes_of_a_build(
    homes: str,
    text: str,
    glb: Path,
    monkeypatch: pytest.MonkeyPatch,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.chdir(glb.parent)
    assert run(["build", "--homes", homes]) == 2
    assert text in capsys.readouterr().err
