"""Run the notebook of the guides and keep what it prints and shows: ``make docs``."""

from __future__ import annotations

import logging
import sys
from pathlib import Path

import nbformat
from nbclient import NotebookClient
from nbformat import NotebookNode

NOTEBOOK = Path(__file__).resolve().parent.parent / "docs" / "notebooks" / "first-look.ipynb"


def run(path: Path) -> NotebookNode:
    """The notebook, run anew in its folder, without times and versions: they differ each time."""
    notebook = nbformat.read(path, as_version=4)
    NotebookClient(notebook, timeout=300, resources={"metadata": {"path": path.parent}}).execute()
    notebook.metadata.pop("widgets", None)
    notebook.metadata["language_info"] = {"name": "python"}
    for cell in notebook.cells:
        cell.metadata.pop("execution", None)
        for output in cell.get("outputs", ()):
            if "image/jpeg" in output.get("data", {}):
                output.data.pop("image/png", None)  # a picture is shown once
    return notebook


if __name__ == "__main__":
    logging.disable(logging.WARNING)
    nbformat.write(run(NOTEBOOK), NOTEBOOK)
    sys.stdout.write(f"{NOTEBOOK}\n")
