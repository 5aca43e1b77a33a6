"""Write the facts of each hazard's page from the catalogue: ``make docs``.

What is between the two markers of ``docs/hazards/<id>.md``, and of the extension packs in
``docs/packs.md``, follows from the YAML; the rest of a page is written by hand.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

from sdgen.catalog.folder import extension_names
from sdgen.catalog.load import load_catalog
from sdgen.catalog.records import Catalog, Hazard
from sdgen.catalog.terms import (
    AboveTerm,
    CountTerm,
    DistanceTerm,
    EdgeTerm,
    FacingAwayTerm,
    FacingTerm,
    HeightTerm,
    HoldsTerm,
    OverhangTerm,
    Term,
    ZoneTerm,
)
from sdgen.vocabulary import EVIDENCE_PIXELS

DOCS = Path(__file__).resolve().parent.parent / "docs"
PAGES, PACKS = DOCS / "hazards", DOCS / "packs.md"
START, END = "<!-- from the catalogue: make docs -->", "<!-- end -->"


def within(term: Term) -> Iterator[Term]:
    """A term and all terms in it."""
    yield term
    for inner in term.within():
        yield from within(inner)


def thresholds(hazard: Hazard) -> Iterator[str]:
    """The hazard's own limits and margins, in words."""
    for term in within(hazard.predicate):
        if isinstance(term, HeightTerm | DistanceTerm | OverhangTerm | EdgeTerm | AboveTerm):
            yield f"{term.in_words()}; undecided within {term.margin_m:g} m of it"
        elif isinstance(term, ZoneTerm):
            yield f"{term.in_words()}; undecided within {term.margin:.0%} of it"
        elif isinstance(term, FacingTerm | FacingAwayTerm):
            yield f"{term.in_words()}; undecided within {term.margin_deg:g} degrees of it"
        elif isinstance(term, CountTerm):
            near = f"; undecided within {term.margin_m:g} m of it" if term.within_m else ""
            yield f"{term.in_words()}{near}"
        elif isinstance(term, HoldsTerm):
            yield term.in_words()


def concerned(hazard: Hazard) -> str:
    """Whom it concerns."""
    concern = hazard.concerns
    if concern.min_age is not None:
        return f"people of {concern.min_age} and older"
    if concern.living_with:
        return f"who lives with: {', '.join(concern.living_with)}"
    if concern.max_age is None:
        return "everyone"
    reach = ", where such a child reaches it" if concern.by_reach else ""
    return f"children up to {concern.max_age}{reach}"


def shown_by(hazard: Hazard) -> str:
    """What a picture must show of it."""
    whole = f"at least {EVIDENCE_PIXELS} pixels of it in some view, at 640 x 480"
    names = " or ".join(hazard.evidence_parts)
    parts = f"its {names}" if names else ""
    if hazard.evidence_state is not None:
        parts = f"what is {hazard.evidence_state}"
    if parts:
        whole += f", and {hazard.evidence_pixels} of {parts} where it has such a part"
    if hazard.evidence_outdoors:
        whole += f", and {hazard.evidence_outdoors} of the outdoors, seen through its opening"
    return whole


def facts(hazard: Hazard) -> str:
    """The table between the markers."""
    limits = "<br>".join(thresholds(hazard)) or "none of its own: those of states and relations"
    harm = hazard.severity
    severity = f"{harm.harm} ({harm.source})" if harm is not None else "not said"
    rows = (
        ("class of the paper", hazard.paper_class),
        ("group, label", f"{hazard.group}, {hazard.label}"),
        ("concerns", concerned(hazard)),
        ("urgency", hazard.urgency),
        ("definition", hazard.predicate.in_words()),
        ("thresholds", limits),
        ("shown by", shown_by(hazard)),
        ("severity", severity),
        ("source", "<br>".join(map(str, hazard.guidance)) or hazard.source),
    )
    table = "\n".join(f"| {key} | {value} |" for key, value in rows)
    return f"{START}\n| | |\n|---|---|\n{table}\n{END}"


def packs() -> str:
    """The tables of the extension packs, a section a pack."""
    shipped = {hazard.id for hazard in load_catalog().hazards}
    sections = []
    for name in extension_names():
        rows = [
            f"| `{hazard.id}` | {hazard.title} | {hazard.predicate.in_words()} | "
            f"{concerned(hazard)} | {'<br>'.join(map(str, hazard.guidance))} |"
            for hazard in load_catalog(extensions=(name,)).hazards
            if hazard.id not in shipped
        ]
        head = "| id | title | holds when | concerns | source |\n|---|---|---|---|---|"
        sections.append(f"### `{name}`\n\n{head}\n" + "\n".join(rows))
    return f"{START}\n" + "\n\n".join(sections) + f"\n{END}"


def between(text: str, inner: str) -> str:
    """A page with what is between its markers, which ``inner`` begins and ends with. ValueError
    where a marker is missing."""
    before, rest = text.split(START, 1)
    _, after = rest.split(END, 1)
    return f"{before}{inner}{after}"


def with_facts(text: str, hazard: Hazard) -> str:
    """A hazard's page with its table as the catalogue has it."""
    return between(text, facts(hazard))


def main() -> int:
    catalog: Catalog = load_catalog()
    for hazard in catalog.hazards:
        page = PAGES / f"{hazard.id}.md"
        page.write_text(with_facts(page.read_text(encoding="utf-8"), hazard), encoding="utf-8")
    PACKS.write_text(between(PACKS.read_text(encoding="utf-8"), packs()), encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
