"""``sdgen assets retexture``: a model in a new state, by a texture that Blender bakes."""

from __future__ import annotations

from pathlib import Path

import click

from sdgen.cli.shared_options import ASSETS
from sdgen.importing.retexture.looks import WORN
from sdgen.options import MAX_SEED


@click.command("retexture")
@ASSETS
@click.option(
    "--as",
    "word",
    required=True,
    metavar="|".join(WORN),
    help="The state to bake; it also names the variant.",
)
@click.option(
    "-o",
    "--out",
    type=click.Path(path_type=Path),
    metavar="LIBRARY",
    help="Asset folder, made when missing: a copy of the model there (<id>_copy) gets the state.",
)
@click.option(
    "--seed",
    type=click.IntRange(min=0, max=MAX_SEED),
    metavar="N",
    default=0,
    show_default=True,
    help="Where the spots are.",
)
@click.option("--overwrite", is_flag=True, help="Bake a state anew that was baked before.")
@click.argument("model", metavar="MODEL")
def retexture_model(
    assets: tuple[Path, ...],
    word: str,
    out: Path | None,
    seed: int,
    overwrite: bool,
    model: str,
) -> None:
    """Give a model a state by a new texture: rotten, overripe, dirty, wet or dusty.

    Blender bakes it onto the model's own texture coordinates; shape and files of the default
    variant stay. It needs the package bpy or a system's Blender, 3.4 or later ($BLENDER names
    one). The variant is added to the model in its asset folder; shipped models are copied to --out
    first.

    \b
    Example: sdgen assets retexture ycb_banana --as expired --assets my_assets
    Example: sdgen assets retexture mug_01 --as dirty --out my_assets
    """
    from sdgen.importing.retexture.run import retexture

    done = retexture(model, word, assets, out, seed, overwrite)
    for note in done.notes:
        click.echo(f"note: {note}", err=True)
    if not done.files:
        click.echo(f"{done.asset_id}: is {done.state} in a variant already; nothing was changed")
        return
    click.echo(
        f"{done.asset_id}: {done.state} is its variant {done.variant!r}, baked by {done.blender}"
    )
    for name in done.files:
        click.echo(f"  {done.folder / name}")
