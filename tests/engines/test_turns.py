"""Builds with turns, panoramas and looks, as users run them."""

import numpy as np
import pytest
from sdgen.catalog.load import load_catalog
from sdgen.dataset import Dataset
from sdgen.engines.build import build as run_build
from sdgen.looks import PRESETS
from sdgen.options import BuildOptions
from sdgen.render.looks import as_seen
from sdgen.validate import validate

from tests.shipped import shipped_library

SMALL = {"n": 1, "seed": 7, "hazards_min": 2, "hazards_max": 2, "width": 96, "height": 72}
TURNS = {"views_mode": "panorama", "equirect": True}


@pytest.fixture(scope="module")
def build(tmp_path_factory):
    tools = {"catalog": load_catalog(), "library": shipped_library()}

    def made(**more):
        out = tmp_path_factory.mktemp("build") / "set"
        options = BuildOptions.model_validate({**SMALL, "twins": True, **more})
        assert run_build(options, out, **tools).complete
        assert [problem.text for problem in validate(out)] == []
        return Dataset(out)[0]

    return made


@pytest.fixture(scope="module")
def turned(build):
    return build(**TURNS)


@pytest.mark.slow
def test_a_look_is_on_the_colours_and_on_nothing_else(build):
    plain, looked = build(views=2), build(views=2, look=PRESETS["robot"])
    assert plain.entry.content_sha256 == looked.entry.content_sha256
    for one, other in ((plain, looked), (plain.twin, looked.twin)):
        for view in range(2):
            look = other.cameras[view].look
            assert look == looked.cameras[view].look
            assert np.array_equal(as_seen(one.rgb(view), look), other.rgb(view))
            for name in ("depth.png", "instance.png", "part.png"):
                name = f"views/{view:02d}/{name}"
                assert one.entry.files[name] == other.entry.files[name]
        assert one.visibility == other.visibility


@pytest.mark.slow
def test_turns_show_the_scene_that_chosen_views_show(build, turned):
    chosen = build(views=2, sensors=())
    assert turned.entry.content_sha256 == chosen.entry.content_sha256
    assert turned.twin.entry.content_sha256 == chosen.twin.entry.content_sha256
    assert turned.entry.views == len(turned.visibility.views) == 6 * len(turned.panoramas)
    rooms = {camera.room_id for camera in turned.cameras}
    seen = {one.object_id for view in turned.visibility.views for one in view.objects}
    furniture = {one.id for one in turned.scene.objects if one.fixed and one.room_id in rooms}
    assert len(seen & furniture) > 0.7 * len(furniture)
    for panorama in turned.panoramas:
        ids = turned.panorama_instance(panorama.index)
        assert (ids > 0).mean() > 0.9  # all but what is seen through windows
        floors = {
            one.id
            for one in turned.scene.home.structures
            if one.category == "floor" and one.room_id == panorama.room_id
        }
        # Rugs lie on it.
        low = {one.id for one in turned.scene.objects if one.pose.position_m[2] < 0.05}
        assert np.isin(ids[-4:], sorted(floors | low)).mean() > 0.5
