"""Whether the library is the one that ``make test-library`` last passed on.

``library_digest.py --check`` ends with 0 when it is, with 1 and a line when not;
``library_digest.py --record`` notes it in ``assets/verified.sha256``, to be committed.
The digest covers the models, the sizes they must have, what checks them and what that calls to
read, measure and simulate a model. So any change in ``library`` or ``physics`` makes CI check them
all, some minutes more, until a passing run is recorded: rather that than a wrong pass,
and a list of single modules would soon lack one. What lies below (geometry, records) and the
simulator's version are left to the suite, which checks a sample of the models at every change.
"""

from __future__ import annotations

import hashlib
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
RECORD = Path("assets") / "verified.sha256"
CHECKED = (
    "assets/manifest.yaml",
    "assets/meshes/*",
    "assets/textures/*",
    "hazard_catalog/categories/*.yaml",
    "generator/sdgen/library/*.py",
    "generator/sdgen/physics/*.py",
    "generator/sdgen/validate/assets.py",
    "generator/sdgen/validate/models.py",
    "scripts/distinct_geometries.py",
    "tests/library/test_whole_library.py",
)


def library_digest(root: Path) -> str:
    """SHA-256 over names and bytes of all that :data:`CHECKED` names below ``root``."""
    total = hashlib.sha256()
    for pattern in CHECKED:
        files = sorted(root.glob(pattern))
        if not files:
            raise FileNotFoundError(f"{root / pattern}: nothing there")
        for path in files:
            total.update(path.relative_to(root).as_posix().encode() + b"\0")
            total.update(hashlib.sha256(path.read_bytes()).digest())
    return total.hexdigest()


def main(root: Path, action: str) -> int:
    """Exit status."""
    digest, record = library_digest(root), root / RECORD
    if action == "--record":
        record.write_text(digest + "\n", encoding="ascii")
        return 0
    if record.exists() and record.read_text(encoding="ascii").strip() == digest:
        return 0
    print(f"the library is not the one {RECORD} names: all of it is checked ('make test-library')")
    return 1


if __name__ == "__main__":
    if sys.argv[1:] not in (["--check"], ["--record"]):
        sys.exit("usage: library_digest.py --check|--record")
    sys.exit(main(ROOT, sys.argv[1]))
