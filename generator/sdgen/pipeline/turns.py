"""The views that are written: those that were chosen, or a turn of views in each room; and what
their cameras do to colours. Scenes are made and proved before, and are the same with any of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import shapely
from shapely.geometry import Polygon

from sdgen.cameras.nearest import with_near_planes
from sdgen.cameras.posts import swept_by
from sdgen.cameras.spots import spots_of
from sdgen.cameras.turn import Post, panoramas_of, posts, standing_clear, turn_cameras
from sdgen.cameras.view import CLEARANCE_M, HEIGHT_JITTER_M
from sdgen.geometry import Array
from sdgen.looks import BLUR_AT_WIDTH, drawn_look
from sdgen.options import EYE_HEIGHT_M, BuildOptions
from sdgen.physics.client import Client
from sdgen.physics.rays import RayWorld
from sdgen.pipeline.furnished import FurnishedHome
from sdgen.scene import Camera, Panorama, Scene, SceneBundle
from sdgen.seeding import Rng

#: Outlines of where cameras may stand are this exact: plain overlays stumble over slivers.
_GRID_M = 1e-4
#: Panoramas draw their looks where no view does.
_PANORAMAS_FROM = 100


def turned(
    bundle: SceneBundle,
    home: FurnishedHome,
    boxes: Array,
    options: BuildOptions,
    client: Client,
    rng: Rng,
) -> SceneBundle:
    """The bundle, and its twins, with a turn of views in each room instead of its cameras.

    ``boxes`` (N, 2, 3) are those of all that is drawn of the scene or of a twin.
    """
    size = (options.width, options.height)
    found = _posts(home, bundle.scene, client, rng)
    raise_m = np.array([0.0, 0.0, options.eye_height_m - EYE_HEIGHT_M])
    cameras = turn_cameras([one._replace(eye_m=one.eye_m + raise_m) for one in found], size)
    cameras = with_near_planes(cameras, boxes)
    panoramas = panoramas_of(cameras) if options.stitches else ()
    return _seen_by(bundle, cameras, panoramas)


def with_looks(
    bundle: SceneBundle, options: BuildOptions, lane: Callable[[str], Rng]
) -> SceneBundle:
    """The bundle, and its twins, with what each camera does to colours: the same in all of them,
    so that they differ where the scenes do."""
    if not options.look:
        return bundle
    cameras = tuple(
        camera.model_copy(
            update={
                "look": drawn_look(
                    options.look, camera.width / BLUR_AT_WIDTH, lane(f"look:{camera.index}")
                )
            }
        )
        for camera in bundle.cameras
    )
    return _seen_by(
        bundle, cameras, tuple(_stitched(one, options, lane) for one in bundle.panoramas)
    )


def _stitched(panorama: Panorama, options: BuildOptions, lane: Callable[[str], Rng]) -> Panorama:
    """A panorama with a look of its own: of pictures whose corners were made as light as their
    middles."""
    look = drawn_look(
        options.look.model_copy(update={"vignetting": 0.0}),
        options.width / BLUR_AT_WIDTH,
        lane(f"look:{_PANORAMAS_FROM + panorama.index}"),
    )
    return panorama.model_copy(update={"look": look})


def _seen_by(
    bundle: SceneBundle, cameras: tuple[Camera, ...], panoramas: tuple[Panorama, ...]
) -> SceneBundle:
    def seen(one: SceneBundle) -> SceneBundle:
        return replace(one, cameras=cameras, panoramas=panoramas)

    return replace(
        seen(bundle),
        twin=bundle.twin and seen(bundle.twin),
        toggles=tuple(seen(toggle) for toggle in bundle.toggles),
    )


def _posts(home: FurnishedHome, scene: Scene, client: Client, rng: Rng) -> list[Post]:
    """Where the camera turns: of each room the place that sees most of the home before anything
    lies there and that stands clear once it does, or the best one where none does. Where hazards
    are says nothing, then; what is set open has kept its floor free."""
    context, layout = home.context, home.layout
    spots = spots_of(context, layout, rng, home.things)
    swept = swept_by(layout, spots.states).buffer(CLEARANCE_M)
    free = shapely.union_all([Polygon(ring) for ring in home.free_space])
    free = shapely.difference(free, swept, grid_size=_GRID_M)
    height_m = EYE_HEIGHT_M + float(rng.uniform(-HEIGHT_JITTER_M, HEIGHT_JITTER_M))
    with RayWorld(layout.library, home.scene(0, layout.items), client.still) as world:
        ranked = posts(
            context.home.rooms,
            free,
            spots.points_m,
            spots.weight[: len(spots.points_m)],
            world.cast,
            height_m,
            rng,
        )
    if not ranked:
        return []
    with RayWorld(layout.library, scene, client.still) as world:
        return [_first_clear(among, world) for among in ranked]


def _first_clear(among: Sequence[Post], world: RayWorld) -> Post:
    return among[int(np.argmax(standing_clear(among, world.cast)))]
