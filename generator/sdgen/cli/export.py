"""``sdgen export``: a data set for other tools."""

from __future__ import annotations

import json
from pathlib import Path

import click

from sdgen.cli.disk import human_bytes
from sdgen.cli.quiet import QUIET
from sdgen.cli.shared_options import ASSETS
from sdgen.export.formats import FORMATS

_WHAT = "; ".join(f"{name}: {known.words}" for name, known in FORMATS.items())


@click.command(short_help="Write a data set for other tools.")
@click.argument("dataset", type=click.Path(path_type=Path), metavar="DATASET")
@click.option(
    "--format",
    "name",
    type=click.Choice(list(FORMATS)),
    default="tar",
    show_default=True,
    help=f"What to write. {_WHAT}.",
)
@click.option(
    "-o",
    "--out",
    "--output",
    "output",
    type=click.Path(path_type=Path),
    required=True,
    help="File to write for tar (its ending .tar or .tar.gz decides the compression), for all "
    "others a new folder.",
)
@click.option("--split", help="Only the scenes of train, val or test (not for tar).")
@click.option("--meshes", is_flag=True, help="huggingface: also each scene's GLB, as a column.")
@ASSETS
@QUIET
@click.option("--json", "as_json", is_flag=True, help="Print one JSON object.")
def export(
    dataset: Path,
    name: str,
    output: Path,
    split: str | None,
    meshes: bool,
    assets: tuple[Path, ...],
    as_json: bool,
) -> None:
    """Write a data set in a format that other tools read; docs/exports.md tells of each.

    \b
    Example: sdgen export output/sdgen-n12-s7 -o homes.tar
    Example: sdgen export output/sdgen-n12-s7 --format huggingface -o homes-hf
    """
    from sdgen.cli.bar import bar
    from sdgen.dataset import Dataset
    from sdgen.dataset.output_file import check_output
    from sdgen.dataset.output_folder import check_output_folder
    from sdgen.errors import UsageError
    from sdgen.export import export as write
    from sdgen.library import load_library

    known = FORMATS[name]
    # Before the work.
    (check_output if known.output == "file" else check_output_folder)(output)
    if split is not None and name == "tar":
        raise UsageError("--split: a tar file holds the whole data set")
    if meshes and not known.meshes:
        raise UsageError(f"--meshes: {name} has no column for them")
    data = Dataset(dataset, split=split)
    library = load_library(assets) if known.models or meshes else None
    with bar("writing") as on_scene:
        write(data, name, output, on_scene, library)
    files = [output] if output.is_file() else [p for p in output.rglob("*") if p.is_file()]
    size = sum(file.stat().st_size for file in files)
    if as_json:
        record = {
            "out": str(output),
            "format": name,
            "scenes": len(data),
            "files": len(files),
            "bytes": size,
        }
        click.echo(json.dumps(record, indent=1, ensure_ascii=False))
        return
    number = f" in {len(files)} files" if output.is_dir() else ""
    click.echo(f"{output}: {human_bytes(size)}{number}")
