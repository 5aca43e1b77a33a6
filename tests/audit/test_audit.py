"""A fresh build holds what the audit asks of it.

``SDGEN_AUDIT_SCENES`` sets how many homes are built and looked at.
"""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.audit.checks import run
from tests.audit.dataset import DataSet

SCENES = int(os.environ.get("SDGEN_AUDIT_SCENES", "10"))


@pytest.mark.slow
def test_a_fresh_build_holds_nothing_that_the_audit_finds(tmp_path: Path) -> None:
    folder = tmp_path / "homes"
    options = ["--n", str(SCENES), "--seed", "1010", "--views", "8", "--size", "320x240"]
    command = [sys.executable, "-m", "sdgen", "build", *options, "--workers", "1"]
    subprocess.run([*command, "--out", str(folder)], check=True, capture_output=True)
    found = run(DataSet(folder))
    wrong = [f"{name}: {finding}" for name, findings in found.items() for finding in findings]
    assert wrong == []
