"""Write the command reference from the commands themselves: ``make docs``."""

from __future__ import annotations

import sys
from collections.abc import Iterator

import click
from sdgen.cli.main import COMMANDS, cli

HEAD = """# Commands

Written by `make docs` from the commands themselves; `sdgen COMMAND --help` says the same.

Exit codes: 0 all done, 1 an error (one line: what, where, how to mend it), 2 a command line that
makes no sense, 3 some scenes could not be made (or anomalies, by `catalog test`), 130 interrupted,
143 terminated (a build goes on with the same command).
"""


def value_name(option: click.Option) -> str:
    """``--size`` takes ``WxH``, a choice takes its words, a flag nothing."""
    if option.is_flag:
        return ""
    if option.metavar:
        return f" {option.metavar}"
    if isinstance(option.type, click.Choice):
        return " " + "|".join(str(choice) for choice in option.type.choices)
    return f" {option.type.name.split()[0].upper()}"


def option_row(option: click.Option) -> str:
    """One line of the table of options."""
    names = ", ".join(f"`{name}`" for name in option.opts)
    notes = [(option.help or "").strip()]
    if option.multiple and "epeatable" not in notes[0]:
        notes.append("Repeatable.")
    default = option.default
    if option.show_default and isinstance(default, str | int | float):
        notes.append(f"Default: {default}.")
    cells = [f"{names}{value_name(option)}", " ".join(notes)]
    return "".join(["| ", " | ".join(cell.replace("|", "\\|") for cell in cells), " |"])


def section(command: click.Command, path: str) -> str:
    """A command's heading, description, arguments and options."""
    arguments = [p for p in command.params if isinstance(p, click.Argument)]
    words = " ".join(str(a.metavar or a.human_readable_name).upper() for a in arguments)
    lines = [f"## {path} {words}".rstrip(), "", describe(command)]
    options = [p for p in command.params if isinstance(p, click.Option) and not p.hidden]
    if options and not isinstance(command, click.Group):
        lines += ["", "| option | meaning |", "|---|---|", *map(option_row, options)]
    return "\n".join(lines) + "\n"


def describe(command: click.Command) -> str:
    """The help text, its examples as a block."""
    text = (command.help or "").replace("\b", "")
    lines = [line.strip() for line in text.splitlines()]
    examples = [line.removeprefix("Example: ") for line in lines if line.startswith("Example: ")]
    plain = "\n".join(line for line in lines if not line.startswith("Example: ")).strip()
    block = "\n".join(["", "", "```sh", *examples, "```"]) if examples else ""
    return plain + block


def sections(group: click.Group, path: str) -> Iterator[str]:
    """The sections of a group's commands, in the order it lists them."""
    ctx = click.Context(group)
    for name in group.list_commands(ctx):
        command = group.get_command(ctx, name)
        if command is None:
            raise LookupError(f"{path} {name} is listed and missing")
        yield section(command, f"{path} {name}")
        if isinstance(command, click.Group):
            yield from sections(command, f"{path} {name}")


def reference() -> str:
    """The whole page."""
    table = "\n".join(f"| `{name}` | {line} |" for name, line in COMMANDS.items())
    head = f"{HEAD}\n| command | what it does |\n|---|---|\n{table}\n"
    return "\n".join([head, *sections(cli, "sdgen")])


if __name__ == "__main__":
    sys.stdout.write(reference())
