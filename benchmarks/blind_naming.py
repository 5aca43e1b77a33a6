"""Can somebody who does not know the labels name our models, and tell their states?

``blind_naming.py draw FOLDER --commit SHA`` renders the 200 models that come first by
sha256(asset id + commit), each alone at 256 x 256 as scenes are rendered, and both sides of 60
pairs of states drawn the same way, onto numbered sheets without names; the key goes to a folder
beside it. A reviewer who sees only the sheets writes ``names.txt`` and ``states.txt``, one line
``number: answer`` a picture. ``blind_naming.py score FOLDER`` compares them with the key and the
synonyms written down before, and writes ``names.csv`` and ``states.csv``.
"""

from __future__ import annotations

import argparse
import csv
import hashlib
import json
import re
import sys
from pathlib import Path

import yaml
from PIL import Image
from sdgen.gallery.sheet import contact_sheet, pages
from sdgen.library import Library, load_library
from sdgen.render import open_renderer
from sdgen.render.portraits import Look, look_in_state, looks_of, portrait

SYNONYMS = Path(__file__).resolve().parent.parent / "docs" / "blind-naming" / "synonyms.yaml"
PER_PAGE, COLUMNS, SIZE = 20, 5, 256
#: State shown, its plain counterpart, and the question the reviewer is asked.
PAIRS = {
    "BROKEN": ("intact", "broken"),
    "EXPIRED": ("fresh", "rotten"),
    "ON": ("off", "on"),
    "OPEN": ("closed", "open"),
    "DIRTY": ("clean", "dirty"),
    "FULL": ("empty", "full"),
}


def rank(name: str, commit: str) -> str:
    """Where something comes in the draw."""
    return hashlib.sha256((name + commit).encode()).hexdigest()


def drawn_models(library: Library, commit: str, count: int) -> list[str]:
    """The first ``count`` asset ids by rank."""
    return sorted(library.assets, key=lambda name: rank(name, commit))[:count]


def drawn_pairs(library: Library, commit: str, count: int) -> list[tuple[str, str]]:
    """``count`` pairs (asset id, state), as many of each state as there are, one a category."""
    by_state: dict[str, list[tuple[str, str]]] = {}
    for state in PAIRS:
        ids = [a.id for a in library.assets.values() if state in a.state_names]
        seen: set[str] = set()
        by_state[state] = []
        for name in sorted(ids, key=lambda i: rank(i + state, commit)):
            category = library.assets[name].category
            if category not in seen:
                seen.add(category)
                by_state[state].append((name, state))
    out: list[tuple[str, str]] = []
    while len(out) < count and any(by_state.values()):
        for state in PAIRS:
            if by_state[state] and len(out) < count:
                out.append(by_state[state].pop(0))
    return out


def draw(folder: Path, commit: str, count: int, pairs: int) -> None:
    """Write the sheets, and the key beside them."""
    library = load_library()
    names: list[tuple[str, Look, str]] = []
    for name in drawn_models(library, commit, count):
        names.append((name, looks_of(library.info(name))[0], library.assets[name].category))
    states: list[tuple[str, Look, str]] = []
    for name, state in drawn_pairs(library, commit, pairs):
        look = look_in_state(library.info(name), state)
        if look is None:
            raise SystemExit(f"{name} cannot be shown {state}")
        plain, shown = PAIRS[state]
        states.append((name, looks_of(library.info(name))[0], plain))
        states.append((name, look, shown))
    states.sort(key=lambda item: rank(item[0] + item[2], commit))
    key_folder = folder.with_name(folder.name + "-key")
    for path in (folder, key_folder):
        path.mkdir(parents=True, exist_ok=True)
    with open_renderer("auto") as renderer:
        for kind, items in (("names", names), ("states", states)):
            tiles, key = [], {}
            for number, (name, look, truth) in enumerate(items, start=1):
                label = f"{number:03d}"
                key[label] = {"id": name, "truth": truth}
                if kind == "states":
                    question = next(f"{a} or {b}?" for a, b in PAIRS.values() if truth in (a, b))
                    label += f"  {question}"
                tiles.append((label, portrait(renderer, library, name, look, SIZE)))
            for page, indices in enumerate(pages(len(tiles), PER_PAGE), start=1):
                sheet = contact_sheet([tiles[k] for k in indices], COLUMNS)
                Image.fromarray(sheet).save(folder / f"{kind}-{page:02d}.png")
            (key_folder / f"{kind}.json").write_text(json.dumps(key, indent=1))
    sys.stdout.write(f"{folder}: {len(names)} models, {len(states)} states; key: {key_folder}\n")


def answers(path: Path) -> dict[str, str]:
    """``number: answer`` lines."""
    found = re.findall(r"^\s*(\d+)\s*[:.)]\s*(.+?)\s*$", path.read_text(), re.MULTILINE)
    return {f"{int(number):03d}": text for number, text in found}


def names_it(answer: str, synonyms: list[str]) -> bool:
    """True when a synonym stands in the answer as whole words (a plural counts)."""
    text = " " + " ".join(re.findall(r"[a-z]+", answer.lower())) + " "
    for synonym in synonyms:
        words = " ".join(re.findall(r"[a-z]+", synonym.lower()))
        if any(f" {words}{ending} " in text for ending in ("", "s", "es")):
            return True
    return False


def score(folder: Path, out: Path) -> None:
    """Print the rates and what was not recognized; write the raw answers with their verdicts."""
    synonyms = yaml.safe_load(SYNONYMS.read_text())
    key_folder = folder.with_name(folder.name + "-key")
    out.mkdir(parents=True, exist_ok=True)
    for kind in ("names", "states"):
        key = json.loads((key_folder / f"{kind}.json").read_text())
        given = answers(folder / f"{kind}.txt")
        rows = []
        for number, item in key.items():
            answer = given.get(number, "")
            if kind == "names":
                category = item["truth"]
                right = names_it(answer, [category.replace("_", " "), *synonyms.get(category, [])])
            else:
                right = answer.lower().split()[:1] == [item["truth"]]
            rows.append((number, item["id"], item["truth"], answer, "yes" if right else "no"))
        with (out / f"{kind}.csv").open("w", newline="", encoding="utf-8") as file:
            writer = csv.writer(file, lineterminator="\n")
            writer.writerow(("number", "id", "truth", "answer", "right"))
            writer.writerows(rows)
        wrong = [row for row in rows if row[-1] == "no"]
        rate = 1 - len(wrong) / len(rows)
        sys.stdout.write(f"{kind}: {len(rows) - len(wrong)} of {len(rows)} right ({rate:.1%})\n")
        if kind == "states":
            pairs = {row[1] + "/" + _state_of(row[2]) for row in rows}
            bad = {row[1] + "/" + _state_of(row[2]) for row in wrong}
            sys.stdout.write(f"pairs told on both sides: {len(pairs) - len(bad)} of {len(pairs)}\n")
        for row in wrong:
            sys.stdout.write(f"  {row[0]} {row[1]} ({row[2]}): {row[3]!r}\n")


def _state_of(word: str) -> str:
    return next(state for state, words in PAIRS.items() if word in words)


def main() -> None:
    """Run one of the two steps."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    steps = parser.add_subparsers(dest="step", required=True)
    first = steps.add_parser("draw")
    first.add_argument("folder", type=Path)
    first.add_argument("--commit", required=True)
    first.add_argument("--count", type=int, default=200)
    first.add_argument("--pairs", type=int, default=60)
    second = steps.add_parser("score")
    second.add_argument("folder", type=Path)
    second.add_argument("-o", "--out", type=Path, default=Path("blind-naming"))
    args = parser.parse_args()
    if args.step == "draw":
        draw(args.folder, args.commit, args.count, args.pairs)
    else:
        score(args.folder, args.out)


if __name__ == "__main__":
    main()
