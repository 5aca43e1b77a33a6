"""``sdgen benchmark``: the tables of a data set, and sealed tests."""

from __future__ import annotations

from pathlib import Path

import click

from sdgen.cli.benchmark_run import run
from sdgen.cli.group import NamedGroup
from sdgen.cli.quiet import QUIET, hint
from sdgen.errors import SdgenError, UsageError

FILE = click.Path(path_type=Path, dir_okay=False)


class RunOrSub(NamedGroup):
    """A group whose first word is one of its commands, or else a data set to run on."""

    def resolve_command(
        self, ctx: click.Context, args: list[str]
    ) -> tuple[str | None, click.Command | None, list[str]]:
        """``run`` is meant where no other command is named."""
        if args and args[0] not in self.commands:
            args = ["run", *args]
        return super().resolve_command(ctx, args)


@click.group(
    cls=RunOrSub,
    short_help="Print the tables of detectors; seal and open secret tests.",
    invoke_without_command=False,
)
def benchmark() -> None:
    """Print the tables of detectors on a data set, or run a test that nobody has seen.

    \b
    Example: sdgen benchmark homes --trained models -o leaderboard.md
    Example: sdgen benchmark seal --seed-file secret.json --dataset sealed -o seal.json -- --n 200
    Example: sdgen benchmark open seal.json --seed-file secret.json --dataset opened
    """


benchmark.add_command(run)


@benchmark.command(
    context_settings={"ignore_unknown_options": True},
    short_help="Build a test set from a secret seed and publish its digest.",
)
@click.option("--seed-file", type=FILE, required=True, help="The secret; a new one is made there.")
@click.option(
    "--dataset",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="Where the test set is built; keep it to yourself.",
)
@click.option(
    "-o",
    "--out",
    "--output",
    "output",
    type=FILE,
    required=True,
    help="The seal, to be published.",
)
@click.argument("build_options", nargs=-1, type=click.UNPROCESSED)
def seal(seed_file: Path, dataset: Path, output: Path, build_options: tuple[str, ...]) -> None:
    """Build a test set from a secret seed and write its seal.

    What follows -- are options of sdgen build (all but --seed and --out); the same command goes on
    where it was stopped. Publish the seal, or the digest that is printed; hand in detectors; then
    publish the secret: with it anybody opens the seal.

    Example: sdgen benchmark seal --seed-file secret.json --dataset sealed -o seal.json -- --n 200
    """
    from sdgen.benchmark.seal import seal as sealed_from
    from sdgen.benchmark.seal import secret_of, without_seeds
    from sdgen.cli.build import build
    from sdgen.dataset import Dataset
    from sdgen.dataset.output_file import (
        check_output,
        is_data_set,
        refuse_mixed,
        write_output,
    )
    from sdgen.dataset.text import record_bytes

    for word in build_options:
        if word.split("=")[0] in ("--seed", "--out", "-o", "--range", "--overwrite"):
            raise UsageError(f"{word}: the secret and --dataset say that")
        if word.endswith((".yaml", ".yml")):
            raise UsageError(f"{word}: whoever opens the test has no such file")
    check_output(output)
    refuse_mixed([output, seed_file, dataset])
    # What build would refuse is refused before a secret is made.
    with build.make_context("sdgen build", [*build_options, "--out", str(dataset)]) as context:
        if not context.params["n"]:
            raise UsageError("--n 0: a test of no scenes")
    new = not seed_file.exists()
    if dataset.is_dir() and any(dataset.iterdir()):
        if not is_data_set(dataset):
            raise SdgenError(f"{dataset}: is not empty, and no data set; name a new folder")
        if new:
            raise SdgenError(f"{dataset}: holds a data set, and {seed_file} is not there")
    secret = secret_of(seed_file, make=True)
    words = [*build_options, "--seed", str(secret.seed), "--out", str(dataset)]
    try:
        with build.make_context("sdgen build", words) as context:
            build.invoke(context)
    except SdgenError as error:
        if new and not is_data_set(dataset):
            seed_file.unlink(missing_ok=True)  # nothing was begun with it
        raise without_seeds(error) from None
    sealed = sealed_from(Dataset(dataset), secret)
    write_output(output, record_bytes(sealed))
    click.echo(f"{output}: {len(sealed.scenes)} scenes sealed")
    click.echo(f"digest {sealed.digest}")
    hint(f"keep {seed_file} and {dataset} to yourself until the test is opened")


@benchmark.command("open", short_help="Prove a sealed test with its secret, byte by byte.")
@click.argument("seal_file", type=FILE, metavar="SEAL")
@click.option("--seed-file", type=FILE, required=True, help="The secret, as it was published.")
@click.option(
    "--dataset",
    type=click.Path(path_type=Path, file_okay=False),
    required=True,
    help="The test set; where there is none it is built from the secret.",
)
@click.option("--digest", metavar="SHA256", help="The digest that was published of the seal.")
@click.option(
    "--catalog",
    "catalogs",
    multiple=True,
    type=click.Path(exists=True, path_type=Path),
    metavar="PATH",
    help="The catalogue folders that it was built with.",
)
@click.option(
    "--assets",
    multiple=True,
    type=click.Path(exists=True, path_type=Path),
    metavar="PATH",
    help="The folders of models that it was built with.",
)
@QUIET
def open_(
    seal_file: Path,
    seed_file: Path,
    dataset: Path,
    digest: str | None,
    catalogs: tuple[Path, ...],
    assets: tuple[Path, ...],
) -> None:
    """Prove that a test set is the one that was sealed: the seed, and every byte.

    Example: sdgen benchmark open seal.json --seed-file secret.json --dataset opened
    """
    from sdgen.benchmark.seal import check_secret, opened, read_seal, same_pictures, secret_of
    from sdgen.cli.bar import bar
    from sdgen.cli.build import Where, carry_out
    from sdgen.cli.quiet import quiet
    from sdgen.dataset import Dataset
    from sdgen.errors import InputError

    sealed = read_seal(seal_file)
    if digest is not None and digest.strip().lower() != sealed.digest:
        raise SdgenError(f"{seal_file}: its digest is {sealed.digest}, not the one published")
    secret = secret_of(seed_file)
    check_secret(sealed, secret)
    options = sealed.options.model_copy(update={"seed": secret.seed})
    if (dataset / "dataset.json").exists():
        if catalogs or assets:
            raise UsageError("--catalog and --assets are for building it, and it is there")
    else:
        where = Where(dataset, (0, options.n), False, None, "local", None, False)
        carry_out(options.model_copy(update={"renderer": "auto"}), where, catalogs, assets, quiet())
    data = Dataset(dataset)
    with bar("comparing") as on_scene:
        problems = list(opened(sealed, secret, data, on_scene))
    if problems:
        raise InputError([f"{dataset}: {problem}" for problem in problems])
    same = same_pictures(sealed, data)
    compared = "every byte" if same else "all but pictures and visibility.json"
    click.echo(f"seed {secret.seed}: {len(sealed.scenes)} scenes are what was sealed, {compared}")
    click.echo(f"digest {sealed.digest}")
    for name in sorted({*sealed.versions, *data.info.versions}):
        then, now = sealed.versions.get(name), data.info.versions.get(name)
        if then != now:
            click.echo(f"{name} was {then or 'not there'} then, {now or 'not there'} now")
    if not same:
        then, now = (" and ".join(one.renderers) for one in (sealed, data.info))
        click.echo(
            f"pictures, and visibility.json, which is counted in them, were not compared: drawn by "
            f"{then} then, {now} now; sdgen validate checks one against the other"
        )
