"""How fast a gallery is made, and how fast it opens in headless Chromium.

    python benchmarks/gallery.py DATASET [--scenes 1000] [--pages N] [--keep FOLDER]

Makes the gallery of a data set (pages a second, peak memory when a quarter and when all of them
are there); makes an index of ``--scenes`` scenes of it, its rows and card pictures repeated under
other ids; opens that from disk and through ``--serve`` (time until a filter has been applied,
bytes transferred before anybody scrolls) and the 3-D view of three homes (time from the click
until the whole home is drawn, by Chromium's software WebGL). Nothing else should run meanwhile.
"""

from __future__ import annotations

import argparse
import json
import os
import resource
import shutil
import sys
import tempfile
import threading
import time
from pathlib import Path

from sdgen import Dataset
from sdgen.gallery import serve, write_gallery
from sdgen.library import load_library

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from tests.browser import Page, browser

READY = "document.querySelectorAll('.card').length > 0"
FILTER = (
    "(() => { const one = document.forms[0].hazard; one.selectedIndex = 1;"
    "one.dispatchEvent(new Event('change', {bubbles: true})); return performance.now(); })()"
)


def peak_mb() -> float:
    """The most memory this process has had."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1e3


def make(dataset: Path, out: Path, pages: int | None) -> Path:
    """Make the gallery and print how fast."""
    data, library = Dataset(dataset), load_library()
    at: dict[int, float] = {}
    quarter = 0

    def on_page(done: int, total: int) -> None:
        nonlocal quarter
        quarter = max(1, total // 4)
        at[done] = peak_mb()

    start = time.perf_counter()
    shown = write_gallery(data, out, pages, on_page, library)
    seconds = time.perf_counter() - start
    count = len(at)
    print(
        f"made: {count} pages of {shown.scenes} scenes in {seconds:.1f} s, {count / seconds:.2f}/s"
    )
    print(
        f"peak memory: {at[quarter]:.0f} MB after {quarter} pages, {at[count]:.0f} MB after {count}"
    )
    return shown.index


def repeat(index: Path, scenes: int, out: Path) -> Path:
    """An index of so many scenes: rows and card pictures of another, under other ids."""
    out.mkdir()
    for path in index.parent.iterdir():
        if path.is_file():
            shutil.copy(path, out)
    text = (index.parent / "scenes.js").read_text(encoding="ascii")
    data = json.loads(text.removeprefix("sdgen.index(").removesuffix(");\n"))
    rows = [row for row in data["rows"] if "-" not in row[0]]
    data["rows"] = []
    for k in range(scenes):
        row = list(rows[k % len(rows)])
        old, row[0] = index.parent / row[0], f"{k:06d}"
        (out / row[0]).mkdir()
        for name in {row[7], row[8]} - {""}:
            os.link(old / name, out / row[0] / name)
        data["rows"].append(row)
    (out / "scenes.js").write_text(f"sdgen.index({json.dumps(data)});\n", encoding="ascii")
    return out / "index.html"


def interactive(page: Page, url: str) -> tuple[float, int]:
    """Milliseconds from going there until a filter has been applied; bytes before scrolling."""
    page.open(url)
    page.until(READY)
    ready_ms = float(page.run(FILTER))
    page.open(url)
    page.until(READY)
    before = -1
    while (now := page.received()) != before:  # until nothing more comes
        before = now
        time.sleep(1.0)
    return ready_ms, before


def main() -> None:
    """Print the numbers."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("dataset", type=Path)
    parser.add_argument("--scenes", type=int, default=1000)
    parser.add_argument("--pages", type=int, help="make only the pages of so many scenes")
    parser.add_argument("--keep", type=Path, help="leave what was made there")
    args = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        out = args.keep or Path(folder) / "work"
        out.mkdir()
        index = make(args.dataset, out / "gallery", args.pages)
        many = repeat(index, args.scenes, out / "many")
        told: list[str] = []
        ready = threading.Event()

        def tell(url: str) -> None:
            told.append(url)
            ready.set()

        threading.Thread(target=serve, args=(out / "many", many, 0, tell), daemon=True).start()
        ready.wait(20)
        with browser() as page:
            page.call("Network.setCacheDisabled", cacheDisabled=True)
            for name, (width, height, phone) in {
                "desktop": (1440, 900, False),
                "phone": (390, 844, True),
            }.items():
                page.size(width, height, phone=phone)
                for way, url in (("disk", many.as_uri()), ("--serve", told[0])):
                    ms, received = interactive(page, url)
                    size = f", {received / 1e6:.2f} MB before scrolling" if way != "disk" else ""
                    print(f"{args.scenes} scenes, {name}, {way}: interactive in {ms:.0f} ms{size}")
            page.size(1440, 900)
            for entry in Dataset(args.dataset).entries[:3]:
                page.open(index.parent / entry.id / "index.html")
                page.until("!!document.querySelector('#tree svg')")
                start = time.perf_counter()
                page.run("document.getElementById('open-space').click()")
                page.until("!!document.getElementById('stage').dataset.ready")
                things = page.run("[sdgen.data.things.length, sdgen.data.models.length]")
                seconds = time.perf_counter() - start
                print(
                    f"3-D of {entry.id}: {seconds:.2f} s ({things[0]} things, {things[1]} models)"
                )


if __name__ == "__main__":
    main()
