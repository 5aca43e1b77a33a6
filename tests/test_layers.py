"""The floors of the package: who may import whom. The table is the contract."""

from __future__ import annotations

import ast
from collections.abc import Collection, Iterator, Mapping, Sequence
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parent.parent
PACKAGE = ROOT / "generator" / "sdgen"

#: Floor -> its rooms. A room imports lower floors, and rooms named before it on its own floor;
#: rooms named together do not know each other.
FLOORS: dict[int, tuple[tuple[str, ...], ...]] = {
    1: (
        ("rejection",),
        ("errors", "seeding", "geometry", "resources", "vocabulary", "kleene", "locks", "closing"),
        ("files", "scratch"),
        ("yaml_source",),
        ("strict",),
    ),
    2: (
        ("scene",),
        ("looks",),
        ("options",),
        ("library",),
        ("catalog",),
        ("facts", "freespace"),
        ("walkways",),
        ("zones",),
        ("actions",),
    ),
    # Hazards stand on the same placing code as everyday clutter, or placing would tell them apart.
    # Cameras decide content by rays alone: they know neither the simulator nor the renderer.
    3: (("home", "households"), ("cameras",), ("hazards",)),
    4: (("physics",), ("render",)),
    5: (("truth",), ("perception",), ("dataset",)),
    6: (("pipeline",), ("engines",)),
    7: (
        ("chat",),
        ("validate", "export", "gallery", "importing", "detectors", "proposals"),
        ("benchmark",),
        ("agent",),
    ),
    8: (("cli",),),
    9: (("__main__",),),
}
#: Room -> (floor, place on the floor).
ROOMS = {
    room: (floor, place)
    for floor, places in FLOORS.items()
    for place, rooms in enumerate(places)
    for room in rooms
}

#: Third-party module -> rooms that may import it (the package's own promise, not taste).
KEPT_FOR = {
    "pybullet": {"physics", "render"},
    "pybullet_data": {"physics", "render"},
    "click": {"cli"},
    "bpy": set(),
    "bmesh": set(),
}


def imports(path: Path) -> Iterator[tuple[str, int]]:
    """Dotted names a file imports anywhere in it (``from a import b`` gives a and a.b)."""
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from ((alias.name, node.lineno) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level:
            assert PACKAGE not in path.parents, f"{path}:{node.lineno}: relative import"
        elif isinstance(node, ast.ImportFrom):
            assert node.module is not None
            yield node.module, node.lineno
            yield from ((f"{node.module}.{alias.name}", node.lineno) for alias in node.names)


def room_of(path: Path) -> str:
    return path.relative_to(PACKAGE).parts[0].removesuffix(".py")


def may_import(importer: str, imported: str) -> bool:
    return importer == imported or ROOMS[imported] < ROOMS[importer]


SOURCES = sorted(path for path in PACKAGE.rglob("*.py") if path != PACKAGE / "__init__.py")


def module_of(path: Path, root: Path = PACKAGE.parent) -> str:
    return ".".join(path.relative_to(root).with_suffix("").parts).removesuffix(".__init__")


def import_graph(files: Collection[Path], root: Path = PACKAGE.parent) -> dict[str, list[str]]:
    """Module -> modules of the same files it imports: at its top, in functions, for types."""
    modules = {module_of(path, root): path for path in files}
    graph: dict[str, list[str]] = {}
    for name, path in modules.items():
        meant: set[str | None] = set()
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Import):
                meant |= {alias.name for alias in node.names}
            elif isinstance(node, ast.ImportFrom):
                for full in (f"{node.module}.{alias.name}" for alias in node.names):
                    meant.add(full if full in modules else node.module)
        graph[name] = sorted(meant & modules.keys())
    return graph


def circle(graph: Mapping[str, Sequence[str]]) -> list[str]:
    """A circle of modules, the first of them named again at the end; empty where there is none."""
    done: set[str] = set()
    for start in graph:
        way: list[str] = []
        todo = [iter([start])]
        while todo:
            name = next(todo[-1], None)
            if name is None:
                todo.pop()
                done.update(way[-1:])
                del way[-1:]
            elif name in way:
                return [*way[way.index(name) :], name]
            elif name not in done:
                way.append(name)
                todo.append(iter(graph[name]))
    return []


@pytest.mark.parametrize("path", SOURCES, ids=lambda path: str(path.relative_to(PACKAGE)))
def test_file_keeps_to_its_floor(path: Path) -> None:
    importer = room_of(path)
    assert importer in ROOMS, f"{importer} has no floor: add it to ROOMS and ARCHITECTURE"
    for name, line in imports(path):
        parts = name.split(".")
        where = f"{path.relative_to(ROOT)}:{line}"
        if parts[0] in KEPT_FOR:
            assert importer in KEPT_FOR[parts[0]], f"{where}: {parts[0]} is kept for others"
        if parts[0] == "sdgen" and len(parts) > 1 and parts[1] in ROOMS:
            assert may_import(importer, parts[1]), f"{where}: {importer} may not import {parts[1]}"


def test_every_room_of_the_package_has_a_floor() -> None:
    folders = {path.name for path in PACKAGE.iterdir() if (path / "__init__.py").exists()}
    files = {path.stem for path in PACKAGE.glob("*.py")} - {"__init__"}
    assert (folders | files) <= set(ROOMS)


def test_no_module_imports_itself_by_way_of_others() -> None:
    # Imports for types count, too: what knows each other's types is one thing in two files. The
    # package's own __init__ is excused: it names what others may use, and loads none of it.
    assert circle(import_graph(SOURCES)) == []


@pytest.mark.parametrize(
    "last",
    [
        "import house.a",
        "from house import a",
        "from house.a import thing",
        "def late():\n    from house.a import thing",
        "if TYPE_CHECKING:\n    from house.a import thing",
    ],
)
def test_a_circle_is_found_however_it_is_imported(tmp_path: Path, last: str) -> None:
    house = tmp_path / "house"
    house.mkdir()
    (house / "a.py").write_text("from house.b import thing\n")
    (house / "b.py").write_text("from house import c\nimport house.d\n")
    (house / "c.py").write_text(f"{last}\n")
    (house / "d.py").write_text("import house.e\n")
    (house / "e.py").write_text("")
    found = circle(import_graph(list(house.iterdir()), tmp_path))
    assert sorted(set(found)) == ["house.a", "house.b", "house.c"]
    assert found[0] == found[-1]
    (house / "c.py").write_text("from house.d import thing\n")
    assert circle(import_graph(list(house.iterdir()), tmp_path)) == []


@pytest.mark.parametrize(
    ("importer", "imported", "allowed"),
    [
        ("cli", "validate", True),
        ("home", "physics", False),
        ("cameras", "physics", False),
        ("cameras", "render", False),
        ("render", "cameras", True),
        ("home", "hazards", False),
        ("home", "households", False),
        ("catalog", "library", True),
        ("library", "catalog", False),
        ("engines", "pipeline", True),
        ("pipeline", "engines", False),
        ("export", "gallery", False),
        ("errors", "scene", False),
        ("truth", "dataset", False),
        ("detectors", "benchmark", False),
        ("truth", "truth", True),
    ],
)
def test_the_rule_itself(importer: str, imported: str, allowed: bool) -> None:
    assert may_import(importer, imported) is allowed


def test_only_the_blender_scripts_import_blender() -> None:
    offenders = [
        str(path.relative_to(ROOT))
        for folder in ("tests", "examples", "scripts", "benchmarks")
        for path in sorted((ROOT / folder).rglob("*.py"))
        if any(name.split(".")[0] in ("bpy", "bmesh") for name, _ in imports(path))
    ]
    assert offenders == []


def test_blender_scripts_import_nothing_of_the_package() -> None:
    scripts = sorted((ROOT / "assets" / "blender").rglob("*.py"))
    assert scripts
    # It runs in the package's own Python, after Blender is done.
    scripts.remove(ROOT / "assets" / "blender" / "assemble.py")
    for path in scripts:
        text = ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        for node in text:
            if isinstance(node, ast.Import | ast.ImportFrom):
                names = [alias.name for alias in node.names] + [getattr(node, "module", "") or ""]
                assert not any(name.split(".")[0] == "sdgen" for name in names), path


def test_contributing_names_every_room() -> None:
    text = (ROOT / "CONTRIBUTING.md").read_text(encoding="utf-8")
    rows = [line for line in text.splitlines() if line.startswith("|")]
    named = {word for row in rows for word in row.split("|")[2].replace("`", "").split(", ")}
    rooms = {room for room in ROOMS if room != "__main__"}
    assert {room for room in rooms if room not in {w.strip() for w in named}} == set()
