"""The paper's seven ways to ask a language model, and one that shows it pictures.

Mullen et al. print one prompt, that of ``cot-sg-c``; it is here word for word, with LaTeX's quotes
as plain ones. The others are our reconstructions from what the paper says of them.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Literal

#: What a model is shown of a scene: relation strings, names alone, sentences, or pictures.
Shown = Literal["relations", "names", "description", "pictures"]

_TEMPLATES = Path(__file__).parent / "templates"


@dataclass(frozen=True)
class Prompt:
    """A way to ask. ``title``: as the paper's table has it; ``examples``: it shows some, ``cot``:
    with reasons; ``categories``: it asks for the four labels; ``every``: of each thing (else only
    what is wrong is named); ``reconstruction``: the paper does not print it."""

    name: str
    title: str
    shown: Shown
    examples: bool
    categories: bool
    every: bool
    cot: bool = False
    reconstruction: bool = True

    @property
    def template(self) -> str:
        """Its text, with ``[CONTENT]`` where what is asked about goes."""
        return _template(self.name)

    @property
    def sha256(self) -> str:
        """Digest of its text."""
        return hashlib.sha256(self.template.encode()).hexdigest()

    def filled(self, content: str, who: str = "") -> str:
        """The prompt about something; ``who``: a paragraph on the household, put before it."""
        # At once: what is asked about may hold anything, our own marks too.
        before, after = self.template.split("[CONTENT]")
        return f"{who}\n\n{before}{content}{after}" if who else f"{before}{content}{after}"


@cache
def _template(name: str) -> str:
    return (_TEMPLATES / f"{name}.txt").read_text(encoding="utf-8").rstrip("\n")


_ALL = (
    Prompt("object-list", "Object List + E, C", "names", True, True, True),
    Prompt("scene-description", "Scene Description + E, C", "description", True, True, False),
    Prompt("sg", "SG, no C", "relations", False, False, False),
    Prompt("e-sg", "E + SG, no C", "relations", True, False, False),
    Prompt("sg-c", "SG & C", "relations", False, True, True),
    Prompt("e-sg-c", "E + SG & C", "relations", True, True, True),
    Prompt("cot-sg-c", "CoT + SG & C", "relations", True, True, True, True, False),
    Prompt("views", "Views", "pictures", False, True, False),
)
#: By name: the paper's seven in the order of its table, and ours with pictures.
PROMPTS: Mapping[str, Prompt] = {prompt.name: prompt for prompt in _ALL}
