"""What scenes were asked for: drawn labels, those they imply, and the shares of who lives there."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator

from tests.audit.dataset import DataSet, Finding, Scene

#: A share is another than told when it is off by so many standard errors: by chance in 1 of 16,000.
ERRORS = 4.0
#: Of so few households a share says nothing.
LEAST_HOUSEHOLDS = 20


def implied(scene: Scene) -> Iterator[Finding]:
    """Labels that nobody asked for, of things that no drawn hazard put or brought there."""
    drawn = [one for one in scene.labels["anomalies"] if one["drawn"]]
    objects = {one["object_id"] for one in drawn}
    recipes = [r for one in drawn for r in scene.catalogue.hazards[one["hazard"]]["anomalies"]]
    brought = {
        category
        for recipe in recipes
        if (near := recipe.get("near")) and near["bring"]
        for category in near["to"]
    }
    for one in scene.labels["anomalies"]:
        theirs = one["object_id"] in objects or one["category"] in brought
        # What a home of one's own draws as an anomaly is labelled in every scene of it.
        if not one["drawn"] and not theirs and scene.scene["home"]["kind"] == "procedural":
            yield scene.found(
                scene.things.get(one["object_id"]), f"{one['hazard']} of nobody's making"
            )


def as_asked(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Scenes with fewer or more drawn hazards than asked for, or one twice."""
    options = data.about["options"]
    for scene in scenes:
        names = [one["hazard"] for one in scene.labels["anomalies"] if one["drawn"]]
        if not options["hazards_min"] <= len(set(names)) <= options["hazards_max"]:
            yield Finding(scene.id, None, "so many hazards were drawn", len(set(names)))
        for name in sorted(name for name, many in Counter(names).items() if many > 1):
            yield Finding(scene.id, None, f"{name} was drawn twice")


def dealt_evenly(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Whole blocks of a balanced draw in which a number or class comes more often than others."""
    options, enabled = data.about["options"], data.about["hazards_enabled"]
    if options["draw"] != "balanced":
        return
    numbers = options["hazards_max"] - options["hazards_min"] + 1
    size = numbers * len(enabled)
    by_index = {scene.scene["index"]: scene for scene in scenes}
    for block in range(len(data.manifest) // max(size, 1)):
        there = [by_index.get(block * size + k) for k in range(size)]
        if None in there:
            continue
        drawn = [
            [one["hazard"] for one in scene.labels["anomalies"] if one["drawn"]]
            for scene in there
            if scene is not None
        ]
        for what, told in (
            ("numbers of hazards", Counter(len(names) for names in drawn)),
            ("classes", Counter(name for names in drawn for name in names)),
        ):
            if len(set(told.values())) > 1:
                yield Finding("all", None, f"block {block}: {what} come unevenly: {told}")


def counted_in_manifest(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Scenes of which the manifest counts something else."""
    rows = {row["id"]: row for row in data.manifest}
    for scene in scenes:
        labels = scene.labels["anomalies"]
        told = {
            "anomalies": len(labels),
            "hazards": dict(Counter(one["hazard"] for one in labels)),
            "lookalikes": len(scene.labels["lookalikes"]),
            "objects": len(scene.scene["objects"]),
        }
        for key, value in told.items():
            if rows[scene.id][key] != value:
                yield Finding(scene.id, None, f"{key}: {rows[scene.id][key]} in the manifest")


def trait_shares(data: DataSet, scenes: list[Scene]) -> Iterator[Finding]:
    """Pets, conditions and opt-outs that households have more or less often than they should.

    Where a drawn hazard concerns who lives with it, half of the scenes are of such households: they
    are left out here. What matters to nothing in the catalogue is never there.
    """
    catalogue = scenes[0].catalogue if scenes else data.catalogue
    hazards = catalogue.hazards.values()
    matters = {w for words in catalogue.belongs_to.values() for w in words}
    matters |= {w for h in hazards for w in h["concerns"]["living_with"]}
    matters |= {w for h in hazards for by in h["concerns"]["raised_by"] for w in by["living_with"]}
    counts: dict[tuple[str, str, str, float], list[bool]] = {}
    for scene in scenes:
        rule = catalogue.households[scene.household["template"]]
        drawn = [one["hazard"] for one in scene.labels["anomalies"] if one["drawn"]]
        wished = {w for name in drawn for w in catalogue.hazards[name]["concerns"]["living_with"]}
        for kind in ("pets", "conditions", "opt_outs"):
            for trait in rule[kind]:
                name = trait["name"]
                share = trait["share"] if kind == "opt_outs" or name in matters else 0.0
                if name not in wished:
                    key = (rule["name"], kind, name, share)
                    counts.setdefault(key, []).append(name in scene.household[kind])
    for (template, _, name, share), has in sorted(counts.items()):
        error = (max(share * (1 - share), 0.0) / len(has)) ** 0.5
        told = sum(has) / len(has)
        off = abs(told - share) > ERRORS * error + 1e-9
        if off and (share in (0.0, 1.0) or len(has) >= LEAST_HOUSEHOLDS):
            yield Finding("all", None, f"{template}: {name} in so many, not {share:.0%}", told)
