"""Hook of ``mkdocs.yml``: pages and files outside ``docs/`` that a page links to join the site.

The guides link to READMEs, examples and schemas of the repository by relative paths, which work
where one reads the files themselves. Here they are taken along as ``repository/PATH``, with all
that they link to in turn; a folder becomes its README, or a list of what is in it.
"""

from __future__ import annotations

import os
import re
from pathlib import Path

from mkdocs.config.defaults import MkDocsConfig
from mkdocs.structure.files import File, Files, InclusionLevel
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
            if there.is_relative_to(docs):
                continue
            if there.is_dir():
                inside = sorted(one for one in there.rglob("*") if one.is_file())
                left += [one for one in inside if one not in seen]
                seen.update(inside)
                for one in inside:
                    files.append(_taken(one, root, docs, config))
                files.append(_list(there, inside, root, docs, config))
                continue
            files.append(_taken(there, root, docs, config))
            left.append(there)
    return files


def _taken(path: Path, root: Path, docs: Path, config: MkDocsConfig) -> File:
    """A file of the repository as one of the site, in no menu."""
    file = File.generated(config, _uri(path, root, docs), abs_src_path=str(path))
    file.inclusion = InclusionLevel.NOT_IN_NAV
    return file


def _list(folder: Path, inside: list[Path], root: Path, docs: Path, config: MkDocsConfig) -> File:
    """A page with links to what is in a folder."""
    names = [path.relative_to(folder).as_posix() for path in inside]
    lines = [f"# {folder.relative_to(root)}", "", *(f"- [{name}]({name})" for name in names)]
    file = File.generated(config, _uri(folder, root, docs), content="\n".join(lines))
    file.inclusion = InclusionLevel.NOT_IN_NAV
    return file


def on_page_markdown(markdown: str, *, page: Page, config: MkDocsConfig, files: Files) -> str:
    """Let links lead to where their files are in the site."""
    root, docs = Path(config.config_file_path).parent, Path(config.docs_dir)
    if page.file.abs_src_path is None:  # a list of ours
        return markdown
    here = Path(page.file.abs_src_path)

    def moved(match: re.Match[str]) -> str:
        there = _file(here.parent, match[2])
        if there is None or not there.is_relative_to(root):
            return match[0]
        uri = _uri(there, root, docs)
        # As from the page's own address: other links of markdown are told from there, too.
        return match[1] + os.path.relpath(uri, Path(page.file.src_uri).parent)

    return LINK.sub(moved, markdown)


def _file(folder: Path, target: str) -> Path | None:
    """The file a link names, or a folder without a page of its own; None where there is none."""
    path = Path(os.path.normpath(folder / target))
    for one in (path, path / "README.md", path / "index.md"):
        if one.is_file():
            return one
    return path if path.is_dir() else None


def _uri(path: Path, root: Path, docs: Path) -> str:
    """Where a file of the repository is in the site."""
    if path.is_relative_to(docs):
        return path.relative_to(docs).as_posix()
    uri = f"{TAKEN}/{path.relative_to(root).as_posix()}"
    return f"{uri}/index.md" if path.is_dir() else uri
