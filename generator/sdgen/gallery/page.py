"""Writes the page: an index of scenes, and one page a scene. Plain files, no network."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path, PurePosixPath
from urllib.parse import quote

from jinja2 import Environment, PackageLoader, StrictUndefined, select_autoescape

from sdgen.dataset import Dataset, SceneItem
from sdgen.dataset.derived import derived_from
from sdgen.dataset.disk import remove_tree
from sdgen.dataset.output_file import refuse_data_set, refuse_links, write_output
from sdgen.dataset.records import count
from sdgen.dataset.scene_folder import view_folder
from sdgen.errors import SdgenError
from sdgen.gallery.drawing import draw_home
from sdgen.gallery.pictures import depth_colours, mask_colours, small_png, thumbnail
from sdgen.scene import Anomaly, EvidenceValue, Lookalike
from sdgen.truth.visibility import shows

INDEX = "index.html"
STYLE = "style.css"
#: How the style begins: it is written first and shows that a folder is a page of ours, which may
#: be written over, finished or not.
MARK = b"/* sdgen view */"

#: By anomaly and view, whether all that is needed shows, and its evidence's pixels.
SeenIn = Mapping[str, list[tuple[bool, int]]]


@dataclass(frozen=True)
class Shown:
    """A finished page: where it is, and how many of the scenes it shows."""

    index: Path
    scenes: int
    total: int


@dataclass(frozen=True)
class BoxOnView:
    """A rectangle over a picture, in its pixels. ``kind``: anomaly, lookalike or object."""

    kind: str
    x: int
    y: int
    width: int
    height: int
    text: str


@dataclass(frozen=True)
class ViewOnPage:
    """One view: its pictures as links relative to the page, None where there is none."""

    index: int
    kind: str
    width: int
    height: int
    rgb: str | None
    mask: str | None
    depth: str | None
    boxes: tuple[BoxOnView, ...]


def write_gallery(
    data: Dataset,
    out: Path,
    limit: int | None = None,
    on_scene: Callable[[int, int], None] | None = None,
) -> Shown:
    """Write the page of a data set into the folder ``out``.

    Colour pictures are linked, not copied: keep the page beside the data set. ``limit`` shows
    only the first scenes. Raises SdgenError when ``out`` holds something else, is a link or lies
    among a data set's scenes, InputError for a broken scene; a new page that cannot be finished
    is taken away again.
    """
    refuse_foreign(out, MARK)
    fresh = not out.exists()
    try:
        return _write(data, out, limit, on_scene)
    except BaseException:
        if fresh:
            remove_tree(out)
        raise


def _write(
    data: Dataset, out: Path, limit: int | None, on_scene: Callable[[int, int], None] | None
) -> Shown:
    environment = templates()
    environment.filters["evidence"] = _evidence
    items = list(data)[:limit]
    begin_page(out, environment, MARK)
    page = environment.get_template("scene.html.j2")
    cards = []
    for k, item in enumerate(items):
        folder = out / item.id
        refuse_links(folder, "folder")
        folder.mkdir(exist_ok=True)
        with derived_from(data, item):
            shown = _seen_in(item)
            cover = _cover(shown, item.entry.views)
            text = page.render(
                item=item,
                index=k,
                before=items[k - 1].id if k else None,
                after=items[k + 1].id if k + 1 < len(items) else None,
                views=[_view(data, item, folder, view) for view in range(item.entry.views)],
                drawing=draw_home(
                    item.scene,
                    data.infos,
                    item.cameras,
                    {a.object_id for a in item.anomalies.anomalies},
                    {a.object_id for a in item.anomalies.lookalikes},
                ),
                category={thing.id: thing.category for thing in item.scene.objects},
                best=_best_views(shown),
            )
        write_output(folder / INDEX, text.encode("utf-8"))
        thumb = item.entry.views > 0 and item.rgb_path(0) is not None
        if thumb:
            write_output(folder / "thumb.jpg", thumbnail(item.rgb(cover)))
        cards.append({"item": item, "thumb": thumb})
        if on_scene is not None:
            on_scene(k + 1, len(items))
    text = environment.get_template("index.html.j2").render(
        data=data,
        info=data.info,
        counts=count(data.entries),
        cards=cards,
        hazards=sorted({h for item in items for h in item.entry.hazards}),
    )
    write_output(out / INDEX, text.encode("utf-8"))
    return Shown(out / INDEX, len(items), len(data))


def templates() -> Environment:
    """The page templates, strict about names and careful with text from files."""
    environment = Environment(
        loader=PackageLoader("sdgen.gallery", "templates"),
        autoescape=select_autoescape(default=True, default_for_string=True),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
    )
    environment.filters["words"] = lambda text: str(text).replace("_", " ")
    return environment


def begin_page(out: Path, environment: Environment, mark: bytes) -> None:
    """Make the folder of a page, with its style, which begins with ``mark``."""
    out.mkdir(parents=True, exist_ok=True)
    style = environment.get_template("style.css.j2").render()
    write_output(out / STYLE, mark + b"\n" + style.encode("utf-8"))


def refuse_foreign(out: Path, mark: bytes) -> None:
    """Raise SdgenError for a folder that holds something other than a page with this mark."""
    refuse_links(out, "folder")
    refuse_data_set(out)
    if out.exists() and not out.is_dir():
        raise SdgenError(f"{out}: is a file; choose another place for the page")
    style = out / STYLE
    ours = style.is_file() and style.read_bytes().startswith(mark)
    if out.is_dir() and any(out.iterdir()) and not ours:
        raise SdgenError(f"{out}: is not empty; choose another place for the page")


def _view(data: Dataset, item: SceneItem, folder: Path, view: int) -> ViewOnPage:
    camera = item.cameras[view]
    sensors = data.info.options.sensors
    mask = depth = rgb = None
    if "instance" in sensors:
        mask = f"{view:02d}-mask.png"
        write_output(folder / mask, small_png(mask_colours(item.instance(view))))
    if "depth" in sensors:
        depth = f"{view:02d}-depth.png"
        write_output(folder / depth, small_png(depth_colours(item.depth_mm(view))))
    path = item.rgb_path(view)
    if path is not None:
        rgb = _link(folder, item.folder / view_folder(view) / path.name)
    return ViewOnPage(
        view, camera.kind, camera.width, camera.height, rgb, mask, depth, _boxes(item, view)
    )


def _link(folder: Path, target: Path) -> str:
    relative = os.path.relpath(target.resolve(), folder.resolve())
    return quote(PurePosixPath(Path(relative).as_posix()).as_posix())


def _boxes(item: SceneItem, view: int) -> tuple[BoxOnView, ...]:
    """Boxes of what a view shows, the marked ones last (on top)."""
    wrong = {a.object_id: a for a in item.anomalies.anomalies}
    near = {a.object_id: a for a in item.anomalies.lookalikes}
    category = {thing.id: thing.category for thing in item.scene.objects}
    out = []
    for shown in (v for v in item.visibility.views if v.view == view):
        for thing in shown.objects:
            kind, text = "object", category.get(thing.object_id, "?")
            if thing.object_id in near:
                kind, text = "lookalike", f"{text}: {near[thing.object_id].near_miss_of}?"
            if thing.object_id in wrong:
                kind, text = "anomaly", f"{text}: {wrong[thing.object_id].hazard}"
            out.append(BoxOnView(kind, *thing.bbox, text.replace("_", " ")))
    order = ("object", "lookalike", "anomaly")
    return tuple(sorted(out, key=lambda box: (order.index(box.kind), -box.width * box.height)))


def _seen_in(item: SceneItem) -> SeenIn:
    """Per anomaly, view by view: whether all that is needed shows, and its evidence's pixels."""
    labels = {anomaly.id: anomaly for anomaly in item.anomalies.anomalies}
    size = (item.cameras[0].width, item.cameras[0].height) if item.cameras else (0, 0)
    return {
        seen.anomaly_id: [
            (shows(view, labels[seen.anomaly_id], *size), pixels)
            for view, pixels in zip(item.visibility.views, seen.evidence_pixels, strict=True)
        ]
        for seen in item.visibility.anomalies
    }


def _best_views(shown: SeenIn) -> dict[str, tuple[int, int]]:
    """Per anomaly the view that shows most of its evidence, and how many pixels; first of those
    that show it by all that is needed."""
    best = {}
    for anomaly_id, views in shown.items():
        if views:
            view = max(range(len(views)), key=lambda k: (*views[k], -k))
            best[anomaly_id] = (view, views[view][1])
    return best


def _cover(shown: SeenIn, views: int) -> int:
    """The view that stands for a scene: it shows most anomalies and, of several that do, most of
    their evidence. The first where there is nothing to show."""

    def value(k: int) -> tuple[int, int, int]:
        seen = [of_views[k] for of_views in shown.values()]
        return sum(whole for whole, _ in seen), sum(pixels for _, pixels in seen), -k

    return max(range(views), key=value, default=0)


def _evidence(record: Anomaly | Lookalike) -> str:
    def shown(value: EvidenceValue) -> str:
        return f"{value:g}" if isinstance(value, float) else str(value)

    return ", ".join(f"{k} {shown(v)}".replace("_", " ") for k, v in record.evidence.items())
