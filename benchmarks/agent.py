"""How fast an agent sees, whether it keeps to the floor, and whether certificates tell the truth.

    python benchmarks/agent.py DATASET [--homes 50] [--poses 10] [--steps 10000]

Speed: the same walk in each home, drawn whole and with only what can be seen (median of homes), on
as many threads as LP_NUM_THREADS allows, and how many pixels of the masks differ. Floor: so many
random moves, the same twice. Certificates: at random poses of each home, half of them toward an
anomaly, rays against pictures.
"""

from __future__ import annotations

import argparse
import hashlib
import statistics
import time

import numpy as np
from sdgen.agent.env import HomeEnv, action
from sdgen.agent.eyes import Eyes
from sdgen.agent.options import AgentOptions
from sdgen.agent.stage import stage_of
from sdgen.agent.walk import Floor
from sdgen.cameras.lens import Lens, camera_at, toward
from sdgen.cameras.outdoors import outer_openings
from sdgen.dataset import Dataset
from sdgen.library import Library, load_library
from sdgen.physics.rays import RayWorld
from sdgen.render.process import process_renderer
from sdgen.scene import Frame
from sdgen.seeding import Rng, lane
from sdgen.truth.observability import evidence_from
from sdgen.truth.visibility import part_names, shows, view_visibility
from shapely.geometry import Point

#: Steps of the walk that speed is measured on, after some that bring its models in.
WALK, WARM = 100, 5
MOVES = ("forward", "forward", "turn_left", "turn_right")


def walk(data: Dataset, library: Library, homes: int, whole: bool) -> tuple[list[float], list]:
    """Steps a second in each home, and the masks seen."""
    options = AgentOptions(whole_home=whole, max_steps=WALK + WARM)
    env = HomeEnv.of_dataset(data, options, library)
    rates, masks = [], []
    for home in range(homes):
        env.reset(seed=home, options={"home": home})
        rng = lane(home, 0, "walk")
        moves = [MOVES[int(rng.integers(len(MOVES)))] for _ in range(WALK + WARM)]
        for move in moves[:WARM]:
            env.step(action(move))
        start = time.perf_counter()
        for move in moves[WARM:]:
            masks.append(env.step(action(move))[0]["instance"])
        rates.append(WALK / (time.perf_counter() - start))
    env.close()
    return rates, masks


def speed(data: Dataset, library: Library, homes: int) -> None:
    rates, masks = {}, {}
    for whole in (True, False):
        rates[whole], masks[whole] = walk(data, library, homes, whole)
        low, high = min(rates[whole]), max(rates[whole])
        what = "whole home" if whole else "what can be seen"
        middle = statistics.median(rates[whole])
        print(f"{what}: {middle:.1f} steps/s (median of {homes} homes; {low:.1f} to {high:.1f})")
    pairs = list(zip(masks[True], masks[False], strict=True))
    wrong = sum(int((a != b).sum()) for a, b in pairs)
    print(f"masks: {wrong} pixels of {len(pairs)} pictures differ")


def floor(data: Dataset, library: Library, homes: int, steps: int) -> None:
    told = []
    for _ in range(2):
        options = AgentOptions(camera=Lens(width=16, height=16), max_steps=10**6, start="random")
        env = HomeEnv.of_dataset(data, options, library)
        digest, worst, refused, collided = hashlib.sha256(), 0.0, 0, 0
        each = steps // homes
        for home in range(homes):
            env.reset(seed=home, options={"home": home})
            env.action_space.seed(home)
            ids = [*env.episode.house.bodies, *(r.id for r in env.episode.stage.scene.home.rooms)]
            rng = lane(home, 1, "walk")
            for _ in range(each):
                wish = env.action_space.sample()
                if wish["move"] == 0:
                    wish["move"] = 1  # stop would end it
                if rng.random() < 0.5:
                    wish["target"] = ids[int(rng.integers(len(ids)))]
                seen, reward, *_, info = env.step(wish)
                digest.update(seen["pose"].tobytes() + seen["instance"].tobytes())
                digest.update(repr((reward, info["refused"])).encode())
                gaze = env.episode.gaze
                worst = max(worst, env.episode.house.floor.shape.distance(Point(gaze.point)))
                refused += info["refused"] is not None
                collided += info["collided"]
        env.close()
        told.append(digest.hexdigest())
    print(
        f"floor: {homes * each} random moves, at most {worst * 1000:.1f} mm off it; "
        f"{refused} refused, {collided} collisions; the same twice: {told[0] == told[1]}"
    )


def certificates(data: Dataset, library: Library, homes: int, poses: int) -> None:
    lens = Lens()
    agree = pairs = real_seen = said_seen = both = 0
    with Eyes(library, process_renderer(), whole_home=True) as eyes:
        done = 0
        for item in data:
            if done == homes or not item.entry.anomalies:
                if done == homes:
                    break
                continue
            done += 1
            stage = stage_of(data, item)
            scene, rng = stage.scene, lane(done, 2, "poses")
            free, parts, openings = Floor(scene), part_names(scene), outer_openings(scene.home)
            eyes.show(scene)
            with RayWorld(library, scene) as world:
                for k in range(poses):
                    gaze = _pose(free, stage, lens, rng, aimed=k % 2 == 1)
                    room = free.room_at(gaze.point)
                    look = eyes.look(gaze, room, lens, colours=False)
                    frame = Frame(
                        look.camera, look.rgb, look.depth_mm, look.instance, look.part, {}
                    )
                    view = view_visibility(frame, parts, openings)
                    eye = np.array([[*gaze.point, lens.height_m]])
                    turn = np.asarray(camera_at(gaze, room, lens).world_from_camera)[None, :3, :3]
                    for one in stage.anomalies:
                        rays = evidence_from(library, scene, world.cast, one, eye, lens)
                        said = bool(rays.shown(turn, lens)[0, 0] >= 1.0)
                        real = shows(view, one, lens.width, lens.height)
                        pairs += 1
                        agree += said == real
                        real_seen += real
                        said_seen += said
                        both += real and said
    print(
        f"certificates: {agree / pairs:.2%} of {pairs} pairs of pose and anomaly agree "
        f"({done * poses} poses of {done} homes); pictures show {real_seen}, rays {said_seen}, "
        f"both {both}"
    )


def _pose(free: Floor, stage, lens: Lens, rng: Rng, aimed: bool):
    gaze = free.random(rng)
    assert gaze is not None
    if not aimed:
        return gaze._replace(pitch_rad=float(rng.uniform(-0.8, 0.5)))
    one = stage.anomalies[int(rng.integers(len(stage.anomalies)))]
    at = np.array(stage.scene.object(one.object_id).pose.position_m)
    yaw, pitch = toward(np.array([*gaze.point, lens.height_m]), at)
    return gaze._replace(yaw_rad=yaw + float(rng.normal(0, 0.4)), pitch_rad=pitch)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset")
    parser.add_argument("--homes", type=int, default=50)
    parser.add_argument("--poses", type=int, default=10)
    parser.add_argument("--steps", type=int, default=10_000)
    args = parser.parse_args()
    data, library = Dataset(args.dataset), load_library()
    speed(data, library, min(12, args.homes))
    certificates(data, library, args.homes, args.poses)
    floor(data, library, min(10, args.homes), args.steps)


if __name__ == "__main__":
    main()
