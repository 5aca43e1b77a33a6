"""``--quiet`` of commands that show how far they are."""

from __future__ import annotations

import click

_KEY = "sdgen.quiet"


def _note(context: click.Context, _: click.Parameter, value: bool) -> None:
    context.meta[_KEY] = value


#: The option, for a command; what it draws and hints at asks ``quiet()``.
QUIET = click.option(
    "--quiet",
    is_flag=True,
    expose_value=False,
    callback=_note,
    help="No progress and no hints: only the result, warnings and errors.",
)


def quiet() -> bool:
    """True when the command that runs was asked to be quiet."""
    context = click.get_current_context(silent=True)
    return context is not None and bool(context.meta.get(_KEY))


def hint(text: str) -> None:
    """Say on stderr what helps a person and no result hangs on."""
    if not quiet():
        click.echo(text, err=True)
