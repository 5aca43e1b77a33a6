"""Proof: which (object, hazard) pairs hold, which surely do not, and whether any is in doubt."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from sdgen.catalog.predicate import Verdict
from sdgen.catalog.records import Catalog
from sdgen.catalog.terms import AllTerm, AnyTerm, CategoryTerm, Term
from sdgen.facts import Facts
from sdgen.library.records import AssetInfo
from sdgen.scene import Certificate, Scene


@dataclass(frozen=True)
class Positive:
    """A pair that holds, or that lies within a dead band (``verdict.sure`` is False)."""

    object_id: int
    hazard: str
    verdict: Verdict


@dataclass(frozen=True)
class Survey:
    """All pairs of a scene: those that hold or are in doubt, and how many were looked at."""

    positives: tuple[Positive, ...]
    pairs: int


def facts_of(
    scene: Scene, infos: Mapping[str, AssetInfo], catalog: Catalog, known: Facts | None = None
) -> Facts:
    """Facts of a scene with the catalogue's category properties; ``known`` are those of another
    with the same home."""
    properties = {c.name: c.properties for c in catalog.categories}
    return Facts(scene, infos, properties, known, catalog.climbs)


def survey(facts: Facts, catalog: Catalog) -> Survey:
    """Evaluate every hazard's predicate for every object.

    An object's category alone settles most pairs: a predicate whose terms all must hold, one of
    them on the category, is surely false of others.
    """
    positives = []
    limits = [(hazard, categories_of(hazard.predicate)) for hazard in catalog.hazards]
    for item in sorted(facts.scene.objects, key=lambda o: o.id):
        for hazard, concerned in limits:
            if concerned is not None and item.category not in concerned:
                continue
            verdict = hazard.predicate.evaluate(item.id, facts)
            if verdict.value or not verdict.sure:
                positives.append(Positive(item.id, hazard.id, verdict))
    return Survey(tuple(positives), len(facts.scene.objects) * len(catalog.hazards))


def categories_of(predicate: Term) -> frozenset[str] | None:
    """The only categories a predicate can be other than surely false of; None for any."""
    if isinstance(predicate, CategoryTerm):
        return frozenset(predicate.any_of)
    if isinstance(predicate, AnyTerm):
        branches = [categories_of(term) for term in predicate.terms]
        known = [names for names in branches if names is not None]
        return frozenset().union(*known) if len(known) == len(branches) else None
    if isinstance(predicate, AllTerm):
        found = [names for term in predicate.terms if (names := categories_of(term)) is not None]
        return frozenset.intersection(*found) if found else None
    return None


def certificate(catalog: Catalog, assets_sha256: str, surveyed: Survey) -> Certificate:
    """What was checked of a scene whose survey holds nothing in doubt."""
    return Certificate(
        hazards_enabled=tuple(sorted(hazard.id for hazard in catalog.hazards)),
        catalogue_sha256=catalog.sha256,
        assets_sha256=assets_sha256,
        pairs_checked=surveyed.pairs,
        pairs_positive=len(surveyed.positives),
    )


def certify(scene: Scene, infos: Mapping[str, AssetInfo], catalog: Catalog) -> tuple[Positive, ...]:
    """Pairs that hold or are in doubt, from records alone (what ``validate`` runs again)."""
    return survey(facts_of(scene, infos, catalog), catalog).positives
