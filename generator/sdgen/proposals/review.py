"""What was proposed, as a catalogue's file that a person reviews before anything is built."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

import yaml

from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Recipe
from sdgen.errors import InputError, one_line
from sdgen.proposals.check import Idea, Refused
from sdgen.proposals.recipe_text import recipe_line
from sdgen.scratch import scratch_folder

_HEAD = """\
# {title}, with what a language model proposed below "proposed" in its anomalies.
# Each of those found a place in a furnished home, and was proved there. Whether it is dangerous,
# and likely, is for you to say: take out what is not.
"""


class _InFull(yaml.SafeDumper):
    """Repeats lists that a file has an alias for: who edits one means that one."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


def review_file(
    written: Mapping[str, Any], ideas: Sequence[Idea], refused: Sequence[Refused]
) -> str:
    """A hazard's file that replaces it: as it was ``written``, with these ideas after its own
    anomalies, and what was refused as comments at the end."""
    keys = [key for key in written if key not in ("id", "replaces")]
    cut = keys.index("anomalies") + 1
    upto = {"id": written["id"], "replaces": True, **{key: written[key] for key in keys[:cut]}}
    parts = [_HEAD.format(title=one_line(str(written["title"]))), _dumped(upto), "# proposed:\n"]
    parts += [f"# {reason}\n- {line}\n" for line, reason in joined(ideas)]
    if keys[cut:]:
        parts.append(_dumped({key: written[key] for key in keys[cut:]}))
    if refused:
        parts.append("\n# Not taken:\n")
        parts += [f"# line {r.line}: {': '.join(filter(None, r[1::2]))}\n" for r in refused]
    return "".join(parts)


def check_loads(
    text: str, hazard: str, shown: Path, catalogs: Sequence[Path], extensions: Sequence[str]
) -> None:
    """Raise InputError, as of the file ``shown``, unless a catalogue can be read with this text."""
    with scratch_folder() as folder:
        file = folder / f"{hazard}.yaml"
        file.write_text(text, encoding="utf-8")
        try:
            load_catalog([*catalogs, file], extensions)
        except InputError as error:
            raise InputError([p.replace(str(file), str(shown)) for p in error.problems]) from None


def joined(ideas: Sequence[Idea]) -> list[tuple[str, str]]:
    """Ideas as lines of YAML, each with its reason: those of a line of the answer together, as
    far as their categories, targets or rooms are all that differs."""
    found = [(idea.recipe, idea) for idea in ideas]
    for field in ("targets", "rooms", "categories"):
        found = _merged(found, field)
    return [(recipe_line(recipe), _reason(idea)) for recipe, idea in found]


def _merged(
    found: Sequence[tuple[Recipe, Idea]], field: Literal["targets", "rooms", "categories"]
) -> list[tuple[Recipe, Idea]]:
    groups: dict[Any, tuple[Recipe, Idea]] = {}
    for recipe, idea in found:
        words = getattr(recipe, field, ())
        key = (idea.line, idea.also, bool(words), recipe.model_copy(update={field: ()}))
        first, led = groups.get(key, (recipe, idea))
        words = tuple(dict.fromkeys((*getattr(first, field, ()), *words)))
        groups[key] = (first.model_copy(update={field: words}) if words else first, led)
    return list(groups.values())


def _reason(idea: Idea) -> str:
    also = f" (it is also: {', '.join(idea.also)})" if idea.also else ""
    return f"line {idea.line}: {idea.reason or 'no reason given'}{also}"


def _dumped(value: Mapping[str, Any]) -> str:
    """Block style, but for what holds plain words alone."""
    flow = all(not isinstance(below, dict | list) for below in value.values())
    text: str = yaml.dump(
        value,
        Dumper=_InFull,
        sort_keys=False,
        allow_unicode=True,
        width=100,
        default_flow_style=False if flow else None,
    )
    return text
