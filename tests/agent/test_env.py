"""The gymnasium environment: its contract, its rewards, and several of them at once."""

from __future__ import annotations

import dataclasses
import warnings
from functools import partial
from typing import Any

import numpy as np
import pytest
from sdgen.agent.moves import LABELS, MOVES
from sdgen.catalog.load import load_catalog
from sdgen.dataset import Dataset
from sdgen.errors import InputError, UsageError
from sdgen.options import BuildOptions
from sdgen.truth.observability import observability

from tests.agent import homes
from tests.shipped import shipped_library

gymnasium = pytest.importorskip("gymnasium")
env_module = pytest.importorskip("sdgen.agent.env")
HomeEnv, action = env_module.HomeEnv, env_module.action


def made(**more: Any) -> Any:
    return HomeEnv.of_dataset(homes.SAMPLE, homes.OPTIONS, shipped_library(), **more)


def in_a_process() -> Any:
    return HomeEnv.of_dataset(homes.SAMPLE, homes.OPTIONS)


def test_gymnasium_finds_nothing_wrong() -> None:
    from gymnasium.utils.env_checker import check_env

    gymnasium.register("sdgen/Home-v0", entry_point=made)
    env = gymnasium.make("sdgen/Home-v0", render_mode="rgb_array")
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        check_env(env.unwrapped)
    env.close()


def test_a_seed_gives_the_same_episode() -> None:
    told = []
    for _ in range(2):
        env = made()
        env.action_space.seed(4)
        observation, info = env.reset(seed=9)
        rows = [(info["scene"], observation["rgb"].tobytes())]
        for _ in range(30):
            observation, reward, done, cut, info = env.step(env.action_space.sample())
            rows.append((reward, done, cut, info["refused"], observation["instance"].tobytes()))
            if done or cut:
                break
        told.append(rows)
        env.close()
    assert told[0] == told[1]


def test_a_reset_tells_who_lives_there_and_no_truth() -> None:
    env = made()
    _, info = env.reset(seed=0, options={"home": 1})
    item = homes.sample()[1]
    assert info["scene"] == item.id
    assert info["household"] == item.household.model_dump(mode="json")
    assert info["rooms"] == {room.id: room.type for room in item.scene.home.rooms}
    assert set(info) == {"scene", "household", "rooms"}
    env.close()


def test_rewards_add_up_to_cas_less_false_alarms() -> None:
    """Whatever is said, said again, and taken back."""
    env = made()
    home = next(k for k in range(3) if any(a.report for a in homes.stage(k).anomalies))
    env.reset(seed=0, options={"home": home})
    wrong = homes.stage(home).anomalies
    bad = {one.object_id for one in wrong}
    wanted = {one.object_id for one in wrong if one.report}
    clean = [item.id for item in homes.stage(home).scene.objects if item.id not in bad][:2]
    paid = 0.0
    said = [(key, notify) for key in (*bad, *clean) for notify in ("silent", "now")]
    said += [(next(iter(wanted)), "silent"), (clean[0], "silent"), (next(iter(wanted)), "summary")]
    for key, notify in said:
        paid += env.step(action("report", key, LABELS[0], notify))[1]
    *_, done, cut, info = env.step(action("stop"))
    assert (done, cut) == (True, False)
    score, reports = info["score"], env.episode.reports
    alarms = sum(reports[key].notify != "silent" for key in clean)
    assert alarms == 1
    assert paid == pytest.approx(score["CAS"] - alarms / len(wanted))
    assert score["AS"] == 1.0
    env.close()


def test_it_is_cut_off_after_its_steps() -> None:
    options = homes.OPTIONS.model_copy(update={"max_steps": 3})
    env = HomeEnv.of_dataset(homes.sample(), options, shipped_library())
    env.reset(seed=0)
    ends = [env.step(action("turn_left"))[2:4] for _ in range(3)]
    assert ends == [(False, False), (False, False), (False, True)]
    with pytest.raises(UsageError, match="over"):
        env.step(action("forward"))
    env.close()


def test_a_scan_gives_all_its_pictures() -> None:
    env = made()
    env.reset(seed=0)
    observation, *_, info = env.step(action("scan"))
    assert len(info["scan"]) == 12
    assert all(env.observation_space.contains(one) for one in info["scan"])
    assert (info["scan"][-1]["rgb"] == observation["rgb"]).all()
    env.close()


@pytest.mark.parametrize(
    ("wrong", "why"),
    [
        (3, "mapping"),
        ({"target": 3}, "no move"),
        ({"move": len(MOVES)}, "not in 0 to"),
        ({"move": -1}, "not in 0 to"),
        ({"move": 1.5}, "whole number"),
        ({"move": "forward"}, "whole number"),
        ({"move": MOVES.index("go_to"), "target": 70_000}, "target: 70000"),
        ({"move": MOVES.index("report"), "target": 3, "label": 9}, "label: 9"),
        ({"move": 1, "speed": 3}, "no 'speed'"),
        ({1: 2, "a": 3, "move": 1}, "no '1'"),
        ({"move": [1, 2]}, "whole number"),
        ({"move": True}, "whole number"),
        ({"move": np.array([1, 2])}, "whole number"),
        ({"move": 10**30}, "not in 0 to"),
    ],
)
def test_an_action_that_is_none_is_an_error_and_no_step(wrong: Any, why: str) -> None:
    env = made()
    env.reset(seed=0)
    with pytest.raises(UsageError, match=why):
        env.step(wrong)
    assert env.episode.steps == 0
    env.step(action("forward"))  # and it goes on
    env.close()


def test_bad_input_is_told() -> None:
    with pytest.raises(InputError):
        HomeEnv.of_dataset(homes.SAMPLE / "scenes")
    env = made()
    with pytest.raises(UsageError, match="not reset"):
        env.step(action("forward"))
    with pytest.raises(UsageError, match="home 9"):
        env.reset(options={"home": 9})
    for options in ({"house": 1}, {"home": 1.5}, {"home": "x"}, [1]):
        with pytest.raises(UsageError, match="reset"):
            env.reset(options=options)
    with pytest.raises(UsageError, match="did you mean"):
        action("foward")


def test_a_fresh_home_is_the_one_that_a_build_would_write() -> None:
    data = Dataset(homes.SAMPLE)
    options = data.info.options
    env = HomeEnv.of_fresh(
        load_catalog(), homes.OPTIONS, BuildOptions(n=1, seed=options.seed), shipped_library()
    )
    _, info = env.reset(seed=0)
    assert info["scene"] == "000000"
    assert env.step(action("scan"))[0]["rgb"].std() > 5.0
    env.close()


@pytest.mark.slow
def test_environments_run_in_processes_and_beside_each_other() -> None:
    both = gymnasium.vector.AsyncVectorEnv([in_a_process] * 2, context="spawn")
    seen, _ = both.reset(seed=1)
    both.close()
    assert seen["rgb"].shape == (2, 48, 64, 3)
    beside = gymnasium.vector.SyncVectorEnv([partial(made)] * 2)
    alike, _ = beside.reset(seed=1)
    beside.close()
    for name in seen:
        assert np.array_equal(seen[name], alike[name])


def test_a_home_with_certificates_has_a_shortest_tour() -> None:
    home = next(k for k in range(3) if homes.stage(k).anomalies)
    stage = homes.stage(home)
    found = observability(
        shipped_library(), stage.scene, stage.anomalies, stage.catalog, homes.OPTIONS.camera
    )
    for certificates, told in ((found, True), (None, False)):
        known = dataclasses.replace(stage, certificates=certificates)
        env = HomeEnv(lambda _, known=known: known, 1, shipped_library(), homes.OPTIONS)
        env.reset(seed=0)
        score = env.step(action("stop"))[-1]["score"]
        assert (score["observable"] is not None) == told
        env.close()
