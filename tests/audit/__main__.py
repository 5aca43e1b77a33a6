"""``python -m tests.audit FOLDER``: audit a data set; a table on stdout, all findings as JSON."""

from __future__ import annotations

import argparse
import json
import sys
from dataclasses import asdict
from pathlib import Path

from tests.audit.checks import run
from tests.audit.dataset import ROOT, DataSet, Finding


def table(found: dict[str, list[Finding]], examples: int) -> str:
    """One line a check: findings, scenes, and the first few."""
    lines = [f"{'check':42} {'found':>6} {'scenes':>6}"]
    for name, findings in found.items():
        lines.append(f"{name:42} {len(findings):6} {len({f.scene for f in findings}):6}")
        # Spread over the findings: the first ones are often of one home.
        step = max(1, len(findings) // max(1, examples))
        lines.extend(f"    {finding}" for finding in findings[::step][:examples])
    return "\n".join(lines)


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.audit", description=__doc__)
    parser.add_argument("folder", type=Path, help="a data set")
    parser.add_argument("--assets", type=Path, default=ROOT / "assets", help="folder of models")
    parser.add_argument("--only", default="", help="only checks whose name holds this")
    parser.add_argument("--limit", type=int, help="only so many scenes")
    parser.add_argument("--examples", type=int, default=3, help="findings shown a check")
    parser.add_argument("--json", type=Path, help="where all findings are written")
    parser.add_argument("--probes", action="store_true", help="what gives labels away, too")
    args = parser.parse_args()
    data = DataSet(args.folder, args.assets)
    found = run(data, args.limit, args.only)
    print(table(found, args.examples))
    if args.json:
        args.json.write_text(
            json.dumps({name: [asdict(f) for f in findings] for name, findings in found.items()})
        )
    if args.probes:
        from tests.audit.probes import report

        print(report(list(data.scenes())[: args.limit]))
    return 1 if any(found.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
