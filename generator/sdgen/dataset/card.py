"""The data set card: a README.md that the build writes beside the scenes."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Sequence

from jinja2 import Environment, PackageLoader, StrictUndefined

from sdgen.catalog.records import Catalog
from sdgen.dataset.records import SPLITS, DatasetInfo, ManifestEntry
from sdgen.library.records import AssetInfo
from sdgen.options import command_of

#: Characters of the longest bar of a histogram.
BAR = 30
#: Whose models need no credit beside the licence: those that come with sdgen.
_OWN = "blender:"


def card(
    info: DatasetInfo,
    entries: Iterable[ManifestEntry] = (),
    assets: Iterable[AssetInfo] = (),
    catalog: Catalog | None = None,
) -> str:
    """Markdown text of the card; the same text for the same data set.

    ``entries`` are its manifest, ``assets`` the models its scenes use, ``catalog`` what says who is
    concerned by a hazard.
    """
    scenes = [entry for entry in entries if entry.twin_of is None]
    # As they were made and as they are read back, splits have one order.
    splits = {name: info.splits[name] for name in (*SPLITS, *info.splits) if name in info.splits}
    info = info.model_copy(update={"splits": splits})
    # Markdown, not HTML: nothing to escape.
    environment = Environment(
        loader=PackageLoader("sdgen.dataset", "templates"),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    return environment.get_template("card.md.j2").render(
        info=info,
        options=info.options,
        command=command_of(info.options),
        titles={hazard.id: hazard for hazard in catalog.hazards} if catalog else {},
        by_split=_by_split(scenes),
        anomalies=histogram([entry.anomalies for entry in scenes], 1),
        lookalikes=histogram([entry.lookalikes for entry in scenes], 2),
        objects=histogram([entry.objects for entry in scenes], 50),
        licences=_licences(assets),
    )


def histogram(values: Sequence[int], width: int) -> list[tuple[str, int, str]]:
    """Bins of ``width`` from the least to the most: ``(name, count, bar)``."""
    if not values:
        return []
    counted = Counter(value // width for value in values)
    most = max(counted.values())
    rows = []
    for k in range(min(counted), max(counted) + 1):
        name = f"{k * width}" if width == 1 else f"{k * width}-{(k + 1) * width - 1}"
        rows.append((name, counted[k], "█" * round(BAR * counted[k] / most)))
    return rows


def _by_split(scenes: Sequence[ManifestEntry]) -> dict[str, Counter[str]]:
    """Anomalies by hazard, by split."""
    out: dict[str, Counter[str]] = {}
    for entry in scenes:
        out.setdefault(entry.split, Counter()).update(entry.hazards)
    return out


def _licences(assets: Iterable[AssetInfo]) -> list[tuple[str, int, list[str]]]:
    """``(licence, models, whom to credit)``, most models first."""
    counted: Counter[str] = Counter()
    credits: dict[str, set[str]] = {}
    for asset in assets:
        counted[asset.licence] += 1
        named = credits.setdefault(asset.licence, set())
        if not asset.source.startswith(_OWN):
            named.add(" ".join((asset.attribution or asset.source).split()))
    return [(name, number, sorted(credits[name])) for name, number in counted.most_common()]
