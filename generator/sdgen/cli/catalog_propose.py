"""``sdgen catalog propose``: further objects and placements of a hazard, for a person to review."""

from __future__ import annotations

import json
import os
import shlex
import sys
from collections import Counter
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import click

from sdgen.cli.params import split_names
from sdgen.cli.shared_options import ASSETS, CATALOGS, EXTENSIONS
from sdgen.errors import SdgenError, UsageError, did_you_mean

if TYPE_CHECKING:
    from sdgen.proposals.check import Idea, Refused, Why

#: What to say of placements that are not taken, by why.
_REFUSED: dict[Why, str] = {
    "unknown": "words that name nothing",
    "malformed": "lines that are no recipe",
    "impossible": "that no model, or not the predicate, allows",
    "beyond": "objects that the predicate knows nothing of",
    "duplicate": "that the hazard has already",
    "unfit": "that fit nowhere",
}


@click.command("propose")
@click.argument("hazard_id", metavar="HAZARD")
@click.option("--model", metavar="NAME", help="The model to ask.")
@click.option(
    "--base-url",
    metavar="URL",
    envvar="OPENAI_BASE_URL",
    help="An OpenAI-compatible endpoint [env: OPENAI_BASE_URL].",
)
@click.option("--temperature", type=click.FloatRange(0.0, 2.0), metavar="T", help="As it has it.")
@click.option(
    "--timeout",
    type=click.FloatRange(1.0, 3600.0),
    metavar="S",
    default=120.0,
    show_default=True,
    help="Seconds that the answer may take.",
)
@click.option("--prompt-only", is_flag=True, help="Print the prompt, to be pasted elsewhere.")
@click.option(
    "--answer",
    type=click.Path(path_type=Path, allow_dash=True),
    metavar="FILE",
    help="Read the answer from a file (- is standard input) in place of asking.",
)
@click.option(
    "-o",
    "--out",
    type=click.Path(dir_okay=False, path_type=Path),
    metavar="HAZARD.yaml",
    help="Write the hazard with what fits, to be reviewed; a new file.",
)
@CATALOGS
@EXTENSIONS
@ASSETS
@click.option("--json", "as_json", is_flag=True, help="Print JSON.")
def propose(
    hazard_id: str,
    model: str | None,
    base_url: str | None,
    temperature: float | None,
    timeout: float,
    prompt_only: bool,
    answer: Path | None,
    out: Path | None,
    catalogs: tuple[Path, ...],
    extensions: tuple[str, ...],
    assets: tuple[Path, ...],
    as_json: bool,
) -> None:
    """Ask a language model for further objects and placements of a hazard.

    Any OpenAI-compatible endpoint will do; its key is in OPENAI_API_KEY (any word, where it wants
    none). Without a key, or with --prompt-only, the prompt is printed, and --answer reads what
    somebody else's model said to it. The answer is checked line by line: categories, states,
    predicates, what the hazard has already; what is left is tried in up to twelve furnished homes,
    with physics, and written with --out as a file that replaces the hazard. Nothing is used before
    you name that file with --catalog.

    \b
    Example: sdgen catalog propose candle_on --model MODEL --out mine/hazards/candle_on.yaml
    Example: sdgen catalog propose candle_on --prompt-only
    Example: sdgen catalog propose candle_on --answer answer.yaml
    """
    from sdgen.catalog.load import load_catalog, written_hazard
    from sdgen.library import load_library
    from sdgen.proposals.answer import read_answer
    from sdgen.proposals.check import checked
    from sdgen.proposals.prompt import prompt_of

    packs = split_names(extensions)
    found = load_catalog(catalogs, packs)
    known = [hazard.id for hazard in found.hazards]
    if hazard_id not in known:
        raise UsageError(f"no hazard {hazard_id!r}{did_you_mean(hazard_id, known)}")
    if out is not None:
        _check_out(out, hazard_id)
    library = load_library(assets)
    prompt = prompt_of(hazard_id, found, library)
    key = os.environ.get("OPENAI_API_KEY", "").strip()
    if answer is None and (prompt_only or not key):
        click.echo(prompt, nl=False)
        if not prompt_only:
            click.echo("no OPENAI_API_KEY: give this to a model, then --answer FILE", err=True)
        return
    if answer is not None:
        raw, name = _read(answer)
    else:
        raw, name = _asked(prompt, key, model, base_url, temperature, timeout)
    hazard = found.hazard(hazard_id)
    judged = checked(read_answer(raw, name), hazard, found, library)
    if judged.ideas:
        click.echo(f"trying {len(judged.ideas)} placements in furnished homes ...", err=True)
    # Physics is loaded late: the prompt needs none.
    from sdgen.proposals.check import Idea
    from sdgen.proposals.trial import tried

    outcomes = list(tried(judged.ideas, hazard, found, library))
    fit = [one for one in outcomes if isinstance(one, Idea)]
    refused = [*judged.refused, *(one for one in outcomes if not isinstance(one, Idea))]
    refused.sort(key=lambda one: one.line)
    if out is not None and fit:
        from sdgen.dataset.output_file import write_output
        from sdgen.proposals.review import check_loads, review_file

        text = review_file(written_hazard(hazard_id, catalogs, packs), fit, refused)
        check_loads(text, hazard_id, out, catalogs, packs)
        write_output(out, text.encode())
    written = out if fit else None
    click.echo(_as_json(hazard_id, fit, refused, written) if as_json else _told(fit, refused))
    if not as_json and out is not None:
        check = _validate_words(out, catalogs, packs, assets)
        text = f"written: {out}; review it, then {check}"
        click.echo(text if fit else f"nothing to write: {out} is not made")


def _validate_words(
    out: Path, catalogs: Sequence[Path], packs: Sequence[str], assets: Sequence[Path]
) -> str:
    """The command that checks what was written, beside what it was written for."""
    words = ["sdgen", "catalog", "validate"]
    words += [f"--extensions={','.join(packs)}"] if packs else []
    words += [f"--assets={folder}" for folder in assets]
    return shlex.join([*words, *map(str, catalogs), str(out)])


def _check_out(out: Path, hazard_id: str) -> None:
    from sdgen.dataset.output_file import check_output

    if out.name not in (f"{hazard_id}.yaml", f"{hazard_id}.yml"):
        raise UsageError(f"{out}: a hazard's file has its id as its name: {hazard_id}.yaml")
    check_output(out)
    if out.exists():
        raise SdgenError(f"{out}: exists already; name a new file, or take it away first")


def _read(answer: Path) -> tuple[bytes, str]:
    from sdgen.files import read_plain
    from sdgen.proposals.answer import MAX_BYTES

    if answer == Path("-"):
        return sys.stdin.buffer.read(MAX_BYTES + 1), "standard input"
    return read_plain(answer, str(answer), MAX_BYTES), str(answer)


def _asked(
    prompt: str,
    key: str,
    model: str | None,
    base_url: str | None,
    temperature: float | None,
    timeout: float,
) -> tuple[bytes, str]:
    from sdgen.chat.endpoint import Endpoint, ask

    if not model:
        raise UsageError("say which model to ask: --model NAME (or --prompt-only, --answer FILE)")
    asked = Endpoint(model, key, base_url or None, temperature, timeout)
    return ask(asked, prompt).encode("utf-8", "replace"), f"answer of {model}"


def _told(fit: Sequence[Idea], refused: Sequence[Refused]) -> str:
    """What became of the answer, in words."""
    from sdgen.proposals.review import joined

    lines = [f"{len(fit) + len(refused)} proposed, {len(fit)} fit"]
    lines += [f"  {line}  # {reason}" for line, reason in joined(fit)]
    counts = Counter(one.why for one in refused)
    for why, words in _REFUSED.items():
        if counts[why]:
            lines.append(f"{counts[why]} not taken: {words}")
        lines += [
            f"  line {one.line}: {': '.join(filter(None, (one.what, one.detail)))}"
            for one in refused
            if one.why == why
        ]
    return "\n".join(lines)


def _as_json(
    hazard_id: str, fit: Sequence[Idea], refused: Sequence[Refused], written: Path | None
) -> str:
    rows = {
        "hazard": hazard_id,
        "proposed": len(fit) + len(refused),
        "fit": [
            {
                "line": one.line,
                "recipe": one.recipe.model_dump(mode="json", exclude_defaults=True),
                "reason": one.reason,
                "also": list(one.also),
            }
            for one in fit
        ],
        "refused": [one._asdict() for one in refused],
        "written": None if written is None else str(written),
    }
    return json.dumps(rows, indent=1, ensure_ascii=False)
