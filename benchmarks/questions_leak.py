"""What the words and boxes of questions tell without their pictures.

    python benchmarks/questions_leak.py FOLDER

FOLDER is what ``sdgen export --format questions`` wrote. A random forest sees the options in their
order and the box of every question about what is wrong; scenes are held out by five folds. Prints
how often it tells whether anything is wrong (chance: 0.5), and which option is right (chance: one
of four; always "nothing": 0.5).
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

import numpy as np
from sdgen.export.questions import NOTHING
from sklearn.ensemble import RandomForestClassifier
from sklearn.model_selection import GroupKFold, cross_val_predict


def main(folder: Path) -> None:
    """Measure and print."""
    lines = (folder / "questions.jsonl").read_text(encoding="utf-8").splitlines()
    rows = [row for row in map(json.loads, lines) if row["kind"] != "notify"]
    words = sorted({option for row in rows for option in row["options"]})
    place = {word: k for k, word in enumerate(words)}
    seen = np.zeros((len(rows), len(words) + 4))
    for k, row in enumerate(rows):
        for letter, option in enumerate(row["options"]):
            seen[k, place[option]] = letter + 1
        seen[k, -4:] = row["box"]
    groups = [row["scene"].split("-")[0] for row in rows]
    answers = ["ABCD".index(row["answer"]) for row in rows]
    wrong = [row["options"][a] != NOTHING for row, a in zip(rows, answers, strict=True)]
    for title, target in (("whether anything is wrong", wrong), ("which option", answers)):
        forest = RandomForestClassifier(300, random_state=0)
        said = cross_val_predict(forest, seen, target, groups=groups, cv=GroupKFold(5))
        right = np.array(said) == np.array(target)
        error = right.std() / np.sqrt(len(right))
        print(f"{title}: {right.mean():.3f} ± {error:.3f} of {len(right)} questions")


if __name__ == "__main__":
    main(Path(sys.argv[1]))
