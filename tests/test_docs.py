"""The documents are true: commands run, links lead somewhere, everything is mentioned."""

from __future__ import annotations

import re
import shlex
import shutil
import subprocess
import sys
from importlib.util import find_spec
from itertools import pairwise
from pathlib import Path

import click
import pytest
import sdgen
from sdgen.catalog.load import load_catalog
from sdgen.cli.main import COMMANDS, cli
from sdgen.facts.thresholds import CLIMB_NEAR_M
from sdgen.vocabulary import FLAT_M
from sdgen.walkways import OPEN_FLOOR_M, WALKWAY_HALF_M

from tests.by_path import ROOT, module_at
from tests.shared import Shared
from tests.shipped import shipped_library

PAGES = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    *(ROOT / name / "README.md" for name in ("assets", "examples", "hazard_catalog", "output")),
    *sorted((ROOT / "docs").rglob("*.md")),
]
#: Pages whose console and python blocks are run, in order, in one empty folder. The first and the
#: last share a build: not neighbours, or one worker would wait for the other.
STORIES = [
    ROOT / "README.md",
    ROOT / "docs" / "python.md",
    ROOT / "docs" / "agent.md",
    ROOT / "docs" / "mending.md",
    ROOT / "docs" / "extending.md",
    ROOT / "docs" / "exports.md",
    ROOT / "docs" / "base-homes.md",
    ROOT / "docs" / "training.md",
    ROOT / "docs" / "metrics.md",
    ROOT / "docs" / "gallery.md",
    ROOT / "docs" / "cluster.md",
    ROOT / "docs" / "quickstart.md",
]


def name_of(page: Path) -> str:
    """How a test calls a page."""
    return page.relative_to(ROOT).as_posix()


TINY = ["--n", "2", "--views", "2", "--size", "96x72", "--workers", "1"]


def blocks(page: Path, *languages: str) -> list[tuple[str, str]]:
    """(language, text) of a page's fenced blocks in these languages, in order."""
    fenced = re.findall(r"^```(\w+)\n(.*?)^```", page.read_text(encoding="utf-8"), re.M | re.S)
    return [(language, text) for language, text in fenced if language in languages]


def commands(text: str) -> list[list[str]]:
    """The command lines of a console block: those that start with a dollar sign."""
    return [shlex.split(line[2:]) for line in text.splitlines() if line.startswith("$ ")]


def tiny(words: list[str]) -> list[str]:
    """The same command on a data set that takes seconds."""
    if words[1] != "build":
        return words
    at = words.index("--n")
    part = float(TINY[1]) / float(words[at + 1])
    kept = [
        ":".join(str(round(int(end) * part)) for end in word.split(":"))
        if before == "--range"
        else word
        for before, word in pairwise(words)
    ]
    kept = [words[0], *kept]
    return [*kept[:at], *kept[at + 2 :], *TINY]


def run(line: list[str], folder: Path) -> None:
    """Run a command in a folder; it must succeed."""
    done = subprocess.run(line, cwd=folder, capture_output=True, text=True, timeout=900)
    assert done.returncode == 0, f"{line}\n{done.stdout}{done.stderr}"


def build(words: list[str], folder: Path, shared: Shared) -> None:
    """Run a build; one that another page has run already is not run again."""
    out = words[words.index("--out") + 1]

    def make(place: Path) -> None:
        place.mkdir()
        run([sys.executable, "-m", "sdgen", *words], place)

    made = shared.folder("-".join(words).replace("/", "_"), make)
    shutil.copytree(made / out, folder / out)


@pytest.mark.slow
@pytest.mark.parametrize("page", STORIES, ids=name_of)
def test_what_a_page_tells_to_run_runs(page: Path, tmp_path: Path, shared: Shared) -> None:
    story = blocks(page, "console", "python")
    assert story
    for language, text in story:
        if language == "python":
            if "import torch" in text and find_spec("torch") is None:
                continue  # a gigabyte, which nothing else here needs
            run([sys.executable, "-c", text], tmp_path)
            continue
        lines = [tiny(words)[1:] for words in commands(text)]
        assert lines, text
        for words in lines:
            # A catalogue of the page's own lies in its folder alone.
            if words[0] == "build" and "--catalog" not in words:
                build(words, tmp_path, shared)
            else:
                run([sys.executable, "-m", "sdgen", *words], tmp_path)


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_console_blocks_hold_our_commands_only(page: Path) -> None:
    for _, text in blocks(page, "console"):
        assert all(words[0] == "sdgen" for words in commands(text))


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_every_command_a_page_names_exists(page: Path) -> None:
    known = set(COMMANDS)
    lines = [text for _, text in blocks(page, "console", "sh")]
    named = re.findall(r"(?:^|[`$/ ])sdgen ([a-z]+)", "\n".join(lines), flags=re.M)
    named += re.findall(r"`sdgen ([a-z]+)", page.read_text(encoding="utf-8"))
    assert set(named) <= known


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_every_option_a_page_shows_is_understood(page: Path) -> None:
    text = "\n".join(text for _, text in blocks(page, "console", "sh"))
    for line in re.findall(r"^(?:\$ )?(sdgen .*)$", text.replace("\\\n", " "), flags=re.M):
        for part in line.split(" && "):
            words = shlex.split(part, comments=True)[1:]
            command, context = cli, click.Context(cli, info_name="sdgen")
            while isinstance(command, click.Group) and words:
                _, found, words = command.resolve_command(context, words)
                assert found is not None, line
                command = found
                context = click.Context(command, context, command.name)
            # Raises for an option it does not have.
            command.make_parser(context).parse_args(words)


@pytest.mark.parametrize("page", PAGES, ids=name_of)
def test_links_lead_somewhere(page: Path) -> None:
    targets = re.findall(r"\]\(([^)#\s]+)", page.read_text(encoding="utf-8"))
    local = [target for target in targets if not re.match(r"\w+:", target)]
    missing = [target for target in local if not (page.parent / target).exists()]
    assert missing == []


def test_every_guide_is_in_the_index() -> None:
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    for page in (ROOT / "docs").glob("*.md"):
        assert page.name == "index.md" or f"({page.name})" in index


def test_every_command_and_option_is_documented() -> None:
    written = (ROOT / "docs" / "commands.md").read_text(encoding="utf-8")
    assert written == module_at("scripts/command_reference.py").reference(), "run 'make docs'"


@pytest.mark.parametrize(
    ("page", "script"),
    [("files.md", "scripts/file_reference.py"), ("api.md", "scripts/api_reference.py")],
)
def test_every_key_of_a_file_and_every_public_name_is_documented(page: str, script: str) -> None:
    written = (ROOT / "docs" / page).read_text(encoding="utf-8")
    assert written == module_at(script).reference(), "run 'make docs'"


def test_every_name_the_package_exports_is_in_the_reference() -> None:
    written = (ROOT / "docs" / "api.md").read_text(encoding="utf-8")
    for name in set(sdgen.__all__) - {"__version__"}:
        assert f"### sdgen.{name}\n" in written, name


def test_every_hazard_is_documented() -> None:
    readme = (ROOT / "README.md").read_text(encoding="utf-8")
    for hazard in load_catalog().hazards:
        assert f"`{hazard.id}`" in readme, hazard.id


def test_every_hazard_has_a_page_that_says_what_its_yaml_says() -> None:
    pages, catalog = module_at("scripts/hazard_pages.py"), load_catalog()
    index = (ROOT / "docs" / "index.md").read_text(encoding="utf-8")
    ids = {hazard.id for hazard in catalog.hazards}
    assert {page.stem for page in (ROOT / "docs" / "hazards").glob("*.md")} == ids
    for hazard in catalog.hazards:
        text = (ROOT / "docs" / "hazards" / f"{hazard.id}.md").read_text(encoding="utf-8")
        assert f"(hazards/{hazard.id}.md)" in index
        assert pages.with_facts(text, hazard) == text, "run 'make docs'"
        assert len(text.split("## What is one, and what is not")[1].split("\n- ")) > 1


def test_the_page_of_the_packs_says_what_their_yaml_says() -> None:
    pages = module_at("scripts/hazard_pages.py")
    text = (ROOT / "docs" / "packs.md").read_text(encoding="utf-8")
    assert pages.between(text, pages.packs()) == text, "run 'make docs'"


def test_measures_on_the_pages_of_hazards_are_those_of_the_code() -> None:
    def says(hazard: str, *measures: str) -> bool:
        text = (ROOT / "docs" / "hazards" / f"{hazard}.md").read_text(encoding="utf-8")
        return all(words in " ".join(text.split()) for words in measures)

    wide, off = f"{2 * WALKWAY_HALF_M:g} m wide", f"more than {OPEN_FLOOR_M:g} m from walls"
    assert says("tripping_hazard", wide, off, f"flatter than {FLAT_M:g} m")
    for hazard in ("choking_hazard", "sharp_object", "poison_cleaning", "poison_medication"):
        assert says(hazard, f"same room within {CLIMB_NEAR_M.limit:g} m")
    library = shipped_library()
    for hazard, category in (("front_door_open", "front_door"), ("fridge_open", "fridge")):
        limits = {
            f"{rule.min:g} {'rad' if asset.joint(rule.joint).type == 'revolute' else 'm'}"
            for asset in library.by_category(category)
            for rule in asset.states
            if rule.state == "OPEN" and rule.joint is not None
        }
        assert says(hazard, *limits)


def test_small_python_blocks_run() -> None:
    small = blocks(ROOT / "docs" / "data-format.md", "python")
    assert small
    for _, text in small:
        exec(compile(text, "docs/data-format.md", "exec"), {})


def test_tiny_keeps_the_rest_of_a_command() -> None:
    words = ["sdgen", "build", "--n", "1000", "--seed", "7", "--out", "homes"]
    assert tiny(words) == ["sdgen", "build", "--seed", "7", "--out", "homes", *TINY]
    words = ["sdgen", "build", "--n", "1000", "--range", "500:1000"]
    assert tiny(words) == ["sdgen", "build", "--range", "1:2", *TINY]
    assert tiny(["sdgen", "stats", "homes"]) == ["sdgen", "stats", "homes"]
