"""Certificates say from where an anomaly can be seen, and pictures agree."""

from __future__ import annotations

import math
from functools import cache

import numpy as np
import pytest
from pydantic import ValidationError
from sdgen.actions import settled_states
from sdgen.agent.walk import Floor
from sdgen.cameras.lens import Gaze, Lens, camera_at, toward
from sdgen.cameras.outdoors import outer_openings
from sdgen.physics.rays import RayWorld
from sdgen.scene import Frame
from sdgen.seeding import lane
from sdgen.truth.observability import evidence_from, lattice, observability
from sdgen.truth.observable import Observability, gaze_of, seen_at
from sdgen.truth.visibility import part_names, shows, view_visibility
from shapely.geometry import Point

from tests.agent import homes
from tests.agent.conftest import no_renderer_is_left as no_renderer_is_left
from tests.shipped import shipped_library

LENS = Lens(width=160, height=120)


@cache
def found(home: int = 0) -> Observability:
    stage = homes.stage(home)
    return observability(
        shipped_library(), stage.scene, stage.anomalies, stage.catalog, LENS, spacing_m=0.8
    )


def drawn(home: int, gaze: Gaze) -> list[bool]:
    """Which anomalies a picture shows."""
    stage = homes.stage(home)
    scene = stage.scene
    eyes = homes.eyes()
    eyes.show(scene)
    look = eyes.look(gaze, Floor(scene).room_at(gaze.point), LENS, colours=False)
    frame = Frame(look.camera, look.rgb, look.depth_mm, look.instance, look.part, {})
    view = view_visibility(frame, part_names(scene), outer_openings(scene.home))
    return [shows(view, one, LENS.width, LENS.height) for one in stage.anomalies]


@pytest.mark.parametrize("home", [0, 1, 2])
def test_rays_and_pictures_agree(home: int) -> None:
    stage, rng = homes.stage(home), lane(home, 0, "poses")
    floor, agree, seen = Floor(stage.scene), 0, 0
    poses: list[Gaze] = []
    for one in stage.anomalies:
        for _ in range(18):
            gaze = floor.random(rng)
            assert gaze is not None
            at = np.array(stage.scene.object(one.object_id).pose.position_m)
            yaw, pitch = toward(np.array([*gaze.point, LENS.height_m]), at)
            poses.append(gaze._replace(yaw_rad=yaw + float(rng.normal(0, 0.3)), pitch_rad=pitch))
    with RayWorld(shipped_library(), stage.scene) as world:
        for gaze in poses:
            eye = np.array([[*gaze.point, LENS.height_m]])
            turn = np.asarray(camera_at(gaze, 1, LENS).world_from_camera)[None, :3, :3]
            said = [
                bool(
                    evidence_from(shipped_library(), stage.scene, world.cast, one, eye, LENS).shown(
                        turn, LENS
                    )[0, 0]
                    >= 1.0
                )
                for one in stage.anomalies
            ]
            real = drawn(home, gaze)
            agree += sum(a == b for a, b in zip(said, real, strict=True))
            seen += sum(real)
    assert seen > 0 or not stage.anomalies
    assert agree >= 0.95 * len(poses) * len(stage.anomalies)


def test_the_best_pose_shows_the_anomaly_and_poses_behind_walls_do_not() -> None:
    certificates = found()
    assert certificates.anomalies
    for k, one in enumerate(certificates.anomalies):
        assert one.best is not None
        assert drawn(0, gaze_of(certificates, one.best))[k]
        seen = seen_at(certificates, one.seen)
        assert seen.shape == (len(certificates.positions_m), 3, 12)
        assert seen.sum() == one.poses_seen
        assert 0 < seen.mean() < 0.5
        sure = seen_at(certificates, one.sure)
        assert not (sure & ~seen).any()
        # Whoever sees the anomaly sees that its twin looks different.
        differs = seen_at(certificates, one.differs)
        assert (differs & seen).sum() >= 0.9 * seen.sum()


def test_looking_away_sees_nothing() -> None:
    certificates = found()
    for one in certificates.anomalies:
        assert one.best is not None
        place, pitch, heading = one.best
        seen = seen_at(certificates, one.seen)
        assert not seen[place, pitch, (heading + 6) % 12]


def test_places_are_on_the_floor_of_every_room() -> None:
    scene = homes.stage().scene
    places, floor = lattice(scene), Floor(scene)
    assert all(floor.open_shape.distance(Point(place)) < 0.01 for place in places)
    assert {floor.room_at(place) for place in places} == {room.id for room in scene.home.rooms}
    assert places == tuple(sorted(places))


def test_a_scene_without_anomalies_has_no_certificates() -> None:
    stage = homes.stage()
    empty = observability(shipped_library(), stage.scene, (), stage.catalog, LENS)
    assert empty.anomalies == ()
    assert empty.positions_m


def test_a_pose_of_the_lattice_is_where_its_numbers_say() -> None:
    certificates = found()
    gaze = gaze_of(certificates, (3, 1, 9))
    assert gaze.point == certificates.positions_m[3]
    assert gaze.yaw_rad == pytest.approx(-math.pi / 2)
    assert gaze.pitch_rad == 0.0


@pytest.mark.parametrize(
    ("change", "why"),
    [
        ({"seen": ()}, "a number for each"),
        ({"sure": ((-1,),)}, "a number for each"),
        ({"best": (0, 0, 99)}, "best is no pose"),
        ({"poses_seen": 9}, "are not the bits"),
    ],
)
def test_certificates_that_do_not_fit_are_refused(change: dict[str, object], why: str) -> None:
    record = found().model_dump(mode="json")
    record["anomalies"][0] |= change
    with pytest.raises(ValidationError, match=why):
        Observability.model_validate(record)
    bits = found().model_dump(mode="json")
    bits["anomalies"][0]["seen"][0][0] = 2**70
    with pytest.raises(ValidationError, match="other bits"):
        Observability.model_validate(bits)


def test_sure_poses_of_an_open_front_door_show_it() -> None:
    """Slits beside a leaf are narrow: what counts is how wide they are in the picture."""
    stage = homes.stage()
    door = next(i for i in stage.scene.objects if i.category == "front_door")
    info = shipped_library().info(door.asset)
    (joint,) = info.joints
    ajar = settled_states(door.model_copy(update={"joints": {joint.name: joint.upper / 6}}), info)
    objects = tuple(ajar if i.id == door.id else i for i in stage.scene.objects)
    scene = stage.scene.model_copy(update={"objects": objects})
    anomaly = stage.anomalies[0].model_copy(
        update={
            "object_id": door.id,
            "evidence_parts": (),
            "evidence_objects": (),
            "evidence_pixels_needed": 100,
            "evidence_outdoors_needed": 100,
        }
    )
    certificates = observability(shipped_library(), scene, [anomaly], stage.catalog, LENS)
    (one,) = certificates.anomalies
    sure = np.argwhere(seen_at(certificates, one.sure))
    assert len(sure)
    eyes = homes.eyes()
    eyes.show(scene)
    right = 0
    for pose in sure[:: max(1, len(sure) // 20)][:20]:
        place, pitch, heading = pose.tolist()
        gaze = gaze_of(certificates, (place, pitch, heading))
        look = eyes.look(gaze, Floor(scene).room_at(gaze.point), LENS, colours=False)
        frame = Frame(look.camera, look.rgb, look.depth_mm, look.instance, look.part, {})
        view = view_visibility(frame, part_names(scene), outer_openings(scene.home))
        right += shows(view, anomaly, LENS.width, LENS.height)
    assert right >= 0.95 * min(20, len(sure))
