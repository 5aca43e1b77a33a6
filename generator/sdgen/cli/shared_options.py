"""Options that several commands have, in the same words."""

from __future__ import annotations

from pathlib import Path

import click

from sdgen.cli.params import parsed, size
from sdgen.options import MAX_VIEWS
from sdgen.render.registry import AUTO, RENDERERS

CATALOGS = click.option(
    "--catalog",
    "catalogs",
    type=click.Path(exists=True, path_type=Path),
    multiple=True,
    help="Extra catalogue folder or file; repeatable.",
)
EXTENSIONS = click.option(
    "--extensions",
    multiple=True,
    metavar="NAME,...",
    help="Shipped packs of hazards to switch on, such as electrical,heat,water.",
)
ASSETS = click.option(
    "--assets",
    type=click.Path(exists=True, path_type=Path),
    multiple=True,
    help="Extra asset folder; repeatable.",
)
VIEWS = click.option(
    "--views",
    type=click.IntRange(min=0, max=MAX_VIEWS),
    metavar="K",
    default=8,
    show_default=True,
    help="Cameras a scene.",
)
SIZE = click.option(
    "--size",
    "pixels",
    metavar="WxH",
    callback=parsed(size),
    default="640x480",
    show_default=True,
    help="Pixels of each view.",
)
RENDERER = click.option(
    "--renderer",
    type=click.Choice([AUTO, *RENDERERS]),
    default=AUTO,
    show_default=True,
    help="auto takes EGL where it starts, else PyBullet's CPU renderer.",
)
