"""Every hazard of the catalogue can be made, proved, seen and undone."""

import numpy as np
import pytest
from sdgen.cameras.outdoors import outer_openings
from sdgen.catalog.load import load_catalog
from sdgen.facts import Facts, unheld
from sdgen.hazards.certify import certify, facts_of
from sdgen.hazards.twin import undone
from sdgen.library.states import undecided_states
from sdgen.options import BuildOptions
from sdgen.pipeline import make_scene
from sdgen.render import open_renderer
from sdgen.render.frames import render_frames
from sdgen.truth.visibility import part_names, shows, view_visibility

HAZARDS = [hazard.id for hazard in load_catalog().hazards]
OPTIONS = BuildOptions(n=10, seed=3, hazards_min=1, hazards_max=1, views=4)


@pytest.fixture(scope="module")
def renderer():
    with open_renderer("auto") as one:
        yield one


@pytest.mark.slow
@pytest.mark.parametrize("hazard", HAZARDS)
def test_a_hazard_is_made_proved_seen_and_undone(hazard, library, renderer):
    catalog = load_catalog(only=[hazard])
    bundle = make_scene(0, catalog, library, OPTIONS)
    (anomaly,) = bundle.anomalies.anomalies
    scene = bundle.scene
    assert anomaly.hazard == hazard

    # Proved, and nothing in doubt.
    (positive,) = certify(scene, library.infos, catalog)
    assert (positive.object_id, positive.verdict.sure) == (anomaly.object_id, True)
    assert anomaly.evidence == positive.verdict.evidence
    item = scene.object(anomaly.object_id)
    assert set(anomaly.evidence_parts) <= set(item.parts)
    assert not undecided_states(library.info(item.asset), item.variant, item.joints)

    # Undone: benign, with the same other objects; only what stands in or on a part that is shut may
    # be elsewhere, and all of them stand.
    benign = undone(scene, [anomaly], catalog, library.infos)
    assert certify(benign, library.infos, catalog) == ()
    left = {o.id: o for o in benign.objects if o.id != anomaly.object_id}
    assert list(left) == [o.id for o in scene.objects if o.id != anomaly.object_id]
    moved = [o.id for o in scene.objects if o.id in left and left[o.id] != o]
    facts = Facts(scene, library.infos)
    assert all(
        any(r.target_id in (anomaly.object_id, *moved) for r in (*facts.on(k), *facts.inside(k)))
        for k in moved
    )
    assert not list(unheld(Facts(benign, library.infos)))

    # Seen in some view, and undoing it changes 100 pixels there.
    parts = part_names(scene)
    frames = list(render_frames(renderer, library, scene, bundle.cameras))
    size = (OPTIONS.width, OPTIONS.height)
    outer = outer_openings(scene.home)
    best = next(f for f in frames if shows(view_visibility(f, parts, outer), anomaly, *size))
    (after,) = render_frames(renderer, library, benign, [best.camera])
    changed = np.any(after.rgb.astype(int) != best.rgb.astype(int), axis=2)
    assert changed.sum() >= 100


@pytest.mark.slow
def test_lookalikes_are_benign_and_named(catalog, library, scene_bundle):
    for index in range(6):
        bundle = scene_bundle(index)
        positive = {p.object_id for p in certify(bundle.scene, library.infos, catalog)}
        facts = facts_of(bundle.scene, library.infos, catalog)
        assert bundle.anomalies.lookalikes
        for one in bundle.anomalies.lookalikes:
            assert one.object_id not in positive
            assert one.near_miss_of in HAZARDS
            assert one.object_id in facts.bodies
