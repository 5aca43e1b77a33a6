"""The data set card: a README.md that the build writes beside the scenes."""

from __future__ import annotations

from jinja2 import Environment, PackageLoader, StrictUndefined

from sdgen.dataset.records import DatasetInfo


def card(info: DatasetInfo) -> str:
    """Markdown text of the card; the same text for the same data set."""
    # Markdown, not HTML: nothing to escape.
    environment = Environment(
        loader=PackageLoader("sdgen.dataset", "templates"),
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
        autoescape=False,
    )
    return environment.get_template("card.md.j2").render(info=info, options=info.options)
