"""The repository as a whole: nothing in it that should not be published."""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

import pytest
import sdgen

from tests.shipped import shipped_library

ROOT = Path(__file__).resolve().parent.parent
TEXT = {".py", ".md", ".toml", ".yaml", ".yml", ".json", ".jsonl", ".txt", ".cff", ".sh", ""}
#: Packed into a wheel it is two thirds of this; a wheel is to stay below 80 MB.
DATA_LIMIT = 90_000_000
FILE_LIMIT = 4_000_000

#: Absolute paths of somebody's machine, put together so that this file does not match itself.
MACHINE_PATH = re.compile(
    r"(?<![\w./])/(?:work/(?:main|shared)|root|home/[a-z]\w*|Users/\w+)" + "/"
)


def published_files() -> list[Path]:
    """Files git tracks or would track; every file when this is not a checkout."""
    try:
        listed = subprocess.run(
            ["git", "ls-files", "-co", "--exclude-standard", "-z"],
            cwd=ROOT,
            capture_output=True,
            check=True,
        ).stdout.decode()
        names = [name for name in listed.split("\0") if name]
    except (OSError, subprocess.CalledProcessError):
        pytest.skip("not a git checkout")
    return [ROOT / name for name in sorted(names) if (ROOT / name).is_file()]


def test_no_machine_paths() -> None:
    found = []
    for path in published_files():
        if path.suffix in TEXT and path.stat().st_size < FILE_LIMIT:
            text = path.read_text(encoding="utf-8", errors="replace")
            found += [
                f"{path.relative_to(ROOT)}: {hit.group()}" for hit in MACHINE_PATH.finditer(text)
            ]
    assert found == []


def test_no_large_file_storage_and_no_links() -> None:
    assert not (ROOT / ".gitattributes").exists() or "lfs" not in (
        ROOT / ".gitattributes"
    ).read_text(encoding="utf-8")
    assert [path for path in published_files() if path.is_symlink()] == []


def test_data_stays_small() -> None:
    files = published_files()
    large = [str(path.relative_to(ROOT)) for path in files if path.stat().st_size > FILE_LIMIT]
    assert large == []
    data = [
        path
        for path in files
        if path.relative_to(ROOT).parts[0] in ("assets", "hazard_catalog", "output")
    ]
    assert 0 < sum(path.stat().st_size for path in data) < DATA_LIMIT


def test_changelog_names_this_version() -> None:
    text = (ROOT / "CHANGELOG.md").read_text(encoding="utf-8")
    headings = re.findall(r"^## (.+)$", text, flags=re.MULTILINE)
    assert headings
    for heading in headings:
        assert re.fullmatch(r"Unreleased|\d+\.\d+\.\d+ \(\d{4}-\d{2}-\d{2}\)", heading), heading
    assert any(heading.startswith(f"{sdgen.__version__} ") for heading in headings)
    sections = set(re.findall(r"^### (.+)$", text, flags=re.MULTILINE))
    assert sections <= {"Added", "Changed", "Fixed", "Removed", "Format"}


def test_citation_names_this_version_and_the_paper() -> None:
    import yaml

    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    assert cited["version"] == sdgen.__version__
    assert cited["license"] == "MIT"
    assert "Milk Back" in cited["references"][0]["title"]


@pytest.mark.parametrize("name", ["README.md", "CONTRIBUTING.md", "CHANGELOG.md", "LICENSE"])
def test_front_matter_is_there(name: str) -> None:
    assert (ROOT / name).stat().st_size > 200


def test_every_licence_an_asset_names_has_its_text() -> None:

    named = {asset.licence for asset in shipped_library().assets.values()}
    texts = {path.stem for path in (ROOT / "assets" / "LICENSES").iterdir()}
    assert named <= texts
