"""The site of the guides: it builds without a warning, leads nowhere wrong and needs no network."""

from __future__ import annotations

import os
import re
import subprocess
import sys
import threading
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.parse import unquote

import nbformat
import pytest

from tests import browser
from tests.by_path import ROOT, module_at
from tests.shared import Shared

pytestmark = [pytest.mark.slow, pytest.mark.xdist_group("site")]
NOTEBOOK = ROOT / "docs" / "notebooks" / "first-look.ipynb"


@pytest.fixture(scope="module")
def site(shared: Shared) -> Path:
    """The site, built strictly: a link to nowhere, or a page in no menu, ends it."""

    def make(place: Path) -> None:
        command = [sys.executable, "-m", "mkdocs", "build", "--strict", "--site-dir", str(place)]
        # Its authors tell of their next project on standard error.
        environment = {**os.environ, "NO_MKDOCS_2_WARNING": "1"}
        done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, env=environment)
        assert done.returncode == 0, done.stderr
        assert "WARNING" not in done.stderr

    return shared.folder("site", make)


def attributes(page: Path, name: str) -> list[str]:
    """The values of an attribute in a page of HTML."""
    return re.findall(rf'\s{name}="([^"]*)"', page.read_text(encoding="utf-8"))


def test_every_link_and_picture_of_the_site_is_in_it(site: Path) -> None:
    missing = []
    for page in site.rglob("*.html"):
        for target in attributes(page, "href") + attributes(page, "src"):
            path = unquote(re.split("[#?]", target)[0])
            local = path and not re.match(r"[a-z]+:", path) and page.name != "404.html"
            if local and not (page.parent / path).exists():
                missing.append(f"{page.relative_to(site)}: {target}")
    assert missing == []


def test_the_site_loads_nothing_from_elsewhere(site: Path) -> None:
    loaded = [
        (page.name, one)
        for page in site.rglob("*.html")
        for one in re.findall(r"<(?:script|img|link|iframe)\b[^>]*", page.read_text("utf-8"))
        if re.search(r'(?:src|href)="(?:https?:)?//', one) and 'rel="canonical"' not in one
    ]
    assert loaded == []


def test_what_the_guides_link_to_is_taken_along(site: Path) -> None:
    index = (site / "extending.html").read_text(encoding="utf-8")
    assert 'href="repository/hazard_catalog/index.html' in index
    assert (site / "repository/examples/my_detector.py").is_file()


def test_the_notebook_is_shown_as_it_was_run(site: Path) -> None:
    shown = (site / "notebooks" / "first-look.html").read_text(encoding="utf-8")
    assert re.search(r"is no [a-z]+_[a-z]+", shown)
    assert shown.count("data:image/jpeg;base64") >= 3


@pytest.mark.skipif(browser.chromium() is None, reason="no Chromium")
def test_the_site_is_read_on_a_phone_and_searched(site: Path) -> None:
    handler = partial(SimpleHTTPRequestHandler, directory=str(site))
    with ThreadingHTTPServer(("127.0.0.1", 0), handler) as server, browser.browser() as page:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        page.size(390, 844, phone=True)
        page.open(site / "concepts.html")
        assert page.run("document.documentElement.scrollWidth") <= 390
        page.size(1280, 900)
        page.open(f"http://127.0.0.1:{server.server_port}/index.html")
        page.until("document.querySelector('.md-search__input').focus() || true")
        for letter in "lookalike":
            page.press(letter)
        page.until("document.querySelectorAll('.md-search-result__item').length > 0")
        assert page.problems() == []
        server.shutdown()


def test_the_notebook_prints_what_it_says() -> None:
    runner = module_at("scripts/run_notebook.py")
    kept, now = nbformat.read(NOTEBOOK, as_version=4), runner.run(NOTEBOOK)
    assert printed(kept) == printed(now), "run 'make docs'"
    assert sum(1 for cell in kept.cells if cell.get("outputs")) >= 9


def printed(notebook: nbformat.NotebookNode) -> list[str]:
    """What each cell of code printed, in however many pieces it came."""
    return [
        "".join(out.text for out in cell.outputs if out.output_type == "stream")
        for cell in notebook.cells
        if cell.cell_type == "code"
    ]
