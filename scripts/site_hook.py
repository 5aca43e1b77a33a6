"""Hook of ``mkdocs.yml``: pages and files outside ``docs/`` that a page links to join the site.

The guides link to READMEs, examples and schemas of the repository by relative paths, which work
where one reads the files themselves. Here they are taken along as ``repository/PATH``, with all
that they link to in turn; a folder becomes its README.
"""

from __future__ import annotations

import os
import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files
from mkdocs.structure.pages import Page

#: ``](target#part)`` and ``src="target"``, of what is no address and no place on the same page.
LINK = re.compile(r"(\]\(|src=\")(?![a-z]+:|#)([^)#\s\"]+)")
TAKEN = "repository"


def on_files(files: Files, *, config: MkDocsConfig) -> Files:
    """Add what pages link to outside the folder of the guides."""
    root, docs = Path(config.config_file_path).parent, Path(config.docs_dir)
    left = [docs / file.src_uri for file in files.documentation_pages()]
    seen = set(left)
    while left:
        page = left.pop()
        if page.suffix != ".md":
            continue
        for _, target in LINK.findall(page.read_text(encoding="utf-8")):
            there = _file(page.parent, target)
            if there is None or there in seen or not there.is_relative_to(root):
                continue
            seen.add(there)
            if not there.is_relative_to(docs):
                uri = _uri(there, root, docs)
                files.append(File.generated(config, uri, abs_src_path=str(there)))
                left.append(there)
    return files


def on_page_markdown(markdown: str, *, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Let links lead to where their files are in the site."""
    root, docs = Path(config.config_file_path).parent, Path(config.docs_dir)
    here = Path(page.file.abs_src_path or "")

    def moved(match: re.Match[str]) -> str:
        there = _file(here.parent, match[2])
        if there is None or not there.is_relative_to(root):
            return match[0]
        uri = _uri(there, root, docs)
        # As from the page's own address: other links of markdown are told from there, too.
        return match[1] + os.path.relpath(uri, Path(page.file.src_uri).parent)

    return LINK.sub(moved, markdown)


def _file(folder: Path, target: str) -> Path | None:
    """The file a link names; None where there is none."""
    path = Path(os.path.normpath(folder / target))
    for one in (path, path / "README.md", path / "index.md"):
        if one.is_file():
            return one
    return None


def _uri(path: Path, root: Path, docs: Path) -> str:
    """Where a file of the repository is in the site."""
    if path.is_relative_to(docs):
        return path.relative_to(docs).as_posix()
    # READMEs would become the index of their folder; links to them keep their name.
    return f"{TAKEN}/{path.relative_to(root).as_posix()}"
