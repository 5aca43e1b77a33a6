"""How much of what a hazard is about is benign: for each hazard that puts things somewhere, the
share of its categories' occurrences in a data set that are no anomaly of it, and by category.

    python benchmarks/benign.py DATASET

At least half is wanted, spills and broken things excepted: a puddle or a shard is never benign.
Counted are all things of the scenes, and those that some view shows (at least 100 pixels).
"""

from __future__ import annotations

import argparse
from collections import Counter
from pathlib import Path

from sdgen import Dataset
from sdgen.catalog.records import PlaceRecipe

SHOWN_PIXELS = 100


def main() -> None:
    """Print a table."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("dataset", type=Path)
    data = Dataset(parser.parse_args().dataset)
    there: Counter[str] = Counter()
    seen: Counter[str] = Counter()
    wrong: Counter[tuple[str, str]] = Counter()
    wrong_seen: Counter[tuple[str, str]] = Counter()
    for item in data:
        shown = {
            one.object_id
            for view in item.visibility.views
            for one in view.objects
            if one.pixels >= SHOWN_PIXELS
        }
        there.update(thing.category for thing in item.scene.objects)
        seen.update(thing.category for thing in item.scene.objects if thing.id in shown)
        for one in item.anomalies.anomalies:
            wrong[one.hazard, one.category] += 1
            wrong_seen[one.hazard, one.category] += one.object_id in shown
    print(f"{len(data)} scenes")
    for hazard in data.catalog.hazards:
        names = sorted(
            {
                category
                for recipe in hazard.anomalies
                if isinstance(recipe, PlaceRecipe)
                for category in recipe.categories
            }
        )
        if not names:
            continue
        total, bad = sum(there[n] for n in names), sum(wrong[hazard.id, n] for n in names)
        in_view, bad_in_view = (
            sum(seen[n] for n in names),
            sum(wrong_seen[hazard.id, n] for n in names),
        )
        few = [
            f"{n} {there[n] - wrong[hazard.id, n]}/{there[n]}"
            for n in names
            if there[n] and 2 * wrong[hazard.id, n] > there[n]
        ]
        share, share_seen = 1 - bad / max(total, 1), 1 - bad_in_view / max(in_view, 1)
        line = f"{hazard.id:24} benign {total - bad:5} of {total:5} ({share:5.0%}), in view "
        line += f"{in_view - bad_in_view:4} of {in_view:4} ({share_seen:5.0%})"
        print(line + (f"; fewer than half: {', '.join(few)}" if few else ""))


if __name__ == "__main__":
    main()
