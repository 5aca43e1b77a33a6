"""What only our own OpenGL draws: light, glass, what glows, and the world between bars."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
import pytest
from sdgen.errors import RendererError
from sdgen.library import Library
from sdgen.render import choose_renderer, open_renderer
from sdgen.render.protocol import Renderer
from sdgen.scene import Daylight, Scene

from tests.fakes import box_room, camera_at, thing

pytestmark = pytest.mark.skipif(
    choose_renderer("auto").kind != "egl", reason="EGL does not start here"
)

LAMP = thing(60, "ceiling_lamp_91", (0.0, 0.0, 2.39), fixed=True)


@pytest.fixture(scope="module")
def renderer() -> Iterator[Renderer]:
    with open_renderer("egl") as made:
        yield made


def night(*things) -> Scene:
    scene = box_room(things)
    home = scene.home.model_copy(update={"daylight": Daylight(time="night")})
    return scene.model_copy(update={"home": home})


def test_nothing_loaded_is_one_clear_error() -> None:
    with open_renderer("egl") as renderer, pytest.raises(RendererError, match="nothing is loaded"):
        renderer.draw(camera_at((0, 0, 1), (1, 0, 1), (32, 24)))


def test_what_is_seen_through_has_its_own_mask_and_depth(
    renderer: Renderer, library: Library
) -> None:
    view = camera_at((-1.0, 0.0, 0.5), (0.5, 0.0, 0.1), (160, 120))
    behind = thing(10, "cube_01", (0.6, 0.0, 0.0))
    pictures = []
    for front in (None, "glass_91", "cube_02"):
        before = [] if front is None else [thing(11, front, (0.2, 0.0, 0.0))]
        renderer.load(library, night(LAMP, behind, *before))
        pictures.append(renderer.draw(view))
    bare, glass, solid = pictures
    assert np.array_equal(glass.instance, solid.instance)
    assert np.array_equal(glass.part, solid.part)
    assert glass.depth_m == pytest.approx(solid.depth_m, abs=1e-4)
    # Red shines through blue glass, and not through a green cube.
    both = (glass.instance == 11) & (bare.instance == 10)
    assert both.sum() > 100
    red = [int(np.median(one.rgb[both][:, 0])) for one in pictures]
    assert red[0] > red[1] > red[2] + 20


def test_a_room_without_windows_or_lamps_is_still_seen(
    renderer: Renderer, library: Library
) -> None:
    renderer.load(library, night(thing(10, "cube_01", (0.6, 0.0, 0.0))))
    picture = renderer.draw(camera_at((-1.0, 0.0, 0.8), (0.5, 0.0, 0.2), (160, 120)))
    assert np.median(picture.rgb[picture.instance == 2]) > 40
    red, green, blue = picture.rgb[picture.instance == 10].mean(axis=0)
    assert red > 2 * green
    assert red > 2 * blue


def test_a_lamp_inside_a_wall_is_no_error(renderer: Renderer, library: Library) -> None:
    inside = thing(60, "ceiling_lamp_91", (2.05, 0.0, 1.0), fixed=True)
    renderer.load(library, night(inside))
    picture = renderer.draw(camera_at((-1.0, 0.0, 0.8), (0.5, 0.0, 0.2), (64, 48)))
    assert picture.rgb.max() > 0


def test_things_throw_a_contact_shade_on_what_they_stand_on(
    renderer: Renderer, library: Library
) -> None:
    view = camera_at((-0.9, 0.0, 0.9), (0.2, 0.0, 0.0), (320, 240))
    renderer.load(library, night(LAMP))
    bare = renderer.draw(view)
    renderer.load(library, night(LAMP, thing(10, "cube_01", (0.2, 0.0, 0.0))))
    stood = renderer.draw(view)
    floor = (bare.instance == 2) & (stood.instance == 2)
    darker = bare.rgb.astype(int).sum(axis=2) - stood.rgb.astype(int).sum(axis=2)
    rows, columns = np.nonzero(stood.instance == 10)
    foot = floor.copy()
    foot[: rows.max() - 4] = foot[rows.max() + 6 :] = False
    foot[:, : columns.min()] = foot[:, columns.max() :] = False
    assert foot.sum() > 20
    assert darker[foot].mean() > 20
    assert np.abs(darker[:20][floor[:20]]).max(initial=0) <= 6


def test_without_colours_masks_and_depth_are_the_same(renderer: Renderer, library: Library) -> None:
    view = camera_at((-1.0, 0.0, 0.5), (0.5, 0.0, 0.1), (160, 120))
    renderer.load(library, night(LAMP, thing(10, "glass_91", (0.6, 0.0, 0.0))))
    whole, plain = renderer.draw(view), renderer.draw(view, colours=False)
    assert not plain.rgb.any()
    assert whole.rgb.any()
    for name in ("instance", "part", "depth_m"):
        assert np.array_equal(getattr(whole, name), getattr(plain, name))


def test_only_what_is_to_be_shown_is(renderer: Renderer, library: Library) -> None:
    view = camera_at((-1.0, 0.0, 0.5), (0.5, 0.0, 0.1), (160, 120))
    things = [thing(10 + k, "cube_01", (0.6, 0.4 * k - 0.4, 0.0)) for k in range(3)]
    renderer.load(library, night(LAMP, *things))
    every = renderer.draw(view)
    renderer.show_only([2, 11])
    some = renderer.draw(view)
    assert set(np.unique(some.instance).tolist()) == {0, 2, 11}
    renderer.show_only(None)
    again = renderer.draw(view)
    assert np.array_equal(every.instance, again.instance)
    assert np.array_equal(every.rgb, again.rgb)


def test_pictures_do_not_depend_on_what_was_drawn_before(
    renderer: Renderer, library: Library
) -> None:
    plain = night(LAMP, thing(10, "cube_01", (0.6, 0.0, 0.0)))
    glazed = night(LAMP, thing(11, "glass_91", (0.2, 0.0, 0.0)))
    view = camera_at((-1.0, 0.0, 0.5), (0.5, 0.0, 0.1), (160, 120))
    renderer.load(library, plain)
    first = renderer.draw(view).rgb
    for factor in (1, 2):
        renderer.load(library, glazed)
        renderer.draw_colours(view, factor)
        renderer.load(library, plain)
        assert np.array_equal(renderer.draw(view).rgb, first)


def test_two_renderers_draw_in_turn(renderer: Renderer, library: Library) -> None:
    view = camera_at((-1.0, 0.0, 0.5), (0.5, 0.0, 0.1), (64, 48))
    renderer.load(library, night(LAMP, thing(10, "cube_01", (0.6, 0.0, 0.0))))
    first = renderer.draw(view).rgb
    with open_renderer("egl") as other:
        other.load(library, night(LAMP, thing(11, "cube_02", (0.4, 0.2, 0.0))))
        second = other.draw(view).rgb
        assert np.array_equal(renderer.draw(view).rgb, first)
        assert np.array_equal(other.draw(view).rgb, second)
    assert np.array_equal(renderer.draw(view).rgb, first)
    assert not np.array_equal(first, second)


def test_edges_are_as_smooth_as_in_a_picture_of_four_times_the_size(
    renderer: Renderer, library: Library
) -> None:
    renderer.load(library, night(LAMP, thing(10, "cube_01", (0.6, 0.0, 0.0))))
    view = camera_at((-1.0, 0.1, 0.7), (0.5, 0.0, 0.1), (160, 120))
    picture = renderer.draw(view)
    large = renderer.draw_colours(view, 4).astype(float)
    ideal = large.reshape(120, 4, 160, 4, 3).mean(axis=(1, 3))
    cube = picture.instance == 10
    edge = np.zeros_like(cube)
    edge[1:-1, 1:-1] = (cube[1:-1, 1:-1] != cube[:-2, 1:-1]) | (cube[1:-1, 1:-1] != cube[1:-1, 2:])
    assert edge.sum() > 50
    rough = large[2::4, 2::4]
    error, before = (np.abs(one - ideal)[edge].mean() for one in (picture.rgb.astype(float), rough))
    assert error < 0.7 * before


def test_no_wall_beside_a_lamp_burns_out(renderer: Renderer, library: Library) -> None:
    near = thing(60, "ceiling_lamp_91", (1.7, 0.0, 1.2), fixed=True)
    renderer.load(library, night(near))
    picture = renderer.draw(camera_at((-1.0, 0.0, 1.2), (1.0, 0.0, 1.2), (160, 120)))
    wall = (picture.instance > 0) & (picture.instance != 60)
    assert np.quantile(picture.rgb[wall].min(axis=1), 0.99) < 250
