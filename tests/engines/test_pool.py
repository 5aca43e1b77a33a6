"""The pool survives what workers do."""

import os
import time

import pytest
from sdgen.engines.pool import Limits, Outcome, Pool, Recycled, peak_mb, resident_mb
from sdgen.errors import SceneRejected, SdgenError
from sdgen.rejection import Cause

NO_PLACE = Cause("hazards", "no_place", hazard="spill")


class Work:
    """Squares jobs; misbehaves on some, once or always, noted by files in ``folder``."""

    def __init__(self, folder: str, bad: dict[int, str]) -> None:
        self.folder, self.bad = folder, bad

    def __call__(self, job: int) -> int:
        how = self.bad.get(job)
        mark = os.path.join(self.folder, str(job))
        if how and not (how.startswith("once") and os.path.exists(mark)):
            open(mark, "w").close()
            if how.endswith("die"):
                os._exit(9)
            if how.endswith("hang"):
                time.sleep(60)
            if how.endswith("bloat"):
                held = bytearray(600_000_000)
                held[::4096] = b"x" * len(held[::4096])
                time.sleep(60)
            if how.endswith("raise"):
                raise ZeroDivisionError("oops")
            if how.endswith("reject"):
                raise SceneRejected(f"{job:06d}", {NO_PLACE: 3})
        return job * job

    def close(self) -> None:
        pass


def broken_factory() -> Work:
    raise SdgenError("no renderer")


def outcomes(tmp_path, bad, jobs=range(6), **limits):
    with Pool(2, Work, (str(tmp_path), bad), Limits(**limits)) as pool:
        events = list(pool.run(jobs))
    done = {e.job: e for e in events if isinstance(e, Outcome)}
    return done, [e for e in events if isinstance(e, Recycled)]


def test_all_jobs_come_back(tmp_path):
    done, recycled = outcomes(tmp_path, {})
    assert {k: o.result for k, o in done.items()} == {k: k * k for k in range(6)}
    assert recycled == []


def test_a_death_and_an_exception_cost_one_retry_each(tmp_path):
    done, recycled = outcomes(tmp_path, {1: "once die", 3: "once raise"})
    assert {k: o.result for k, o in done.items()} == {k: k * k for k in range(6)}
    assert len(recycled) == 2


def test_a_hung_worker_is_replaced(tmp_path):
    done, recycled = outcomes(tmp_path, {2: "once hang"}, jobs=range(3), timeout_s=4.0)
    assert {k: o.result for k, o in done.items()} == {0: 0, 1: 1, 2: 4}
    assert "no answer" in recycled[0].why


def test_a_job_that_always_fails_is_named_and_the_rest_is_done(tmp_path):
    done, _ = outcomes(tmp_path, {4: "always die", 5: "reject"})
    assert [k for k, o in sorted(done.items()) if o.error is None] == [0, 1, 2, 3]
    assert isinstance(done[4].error, SceneRejected)
    assert done[5].error.causes == {NO_PLACE: 3}
    assert done[4].error.causes == {Cause("worker", "died"): 2}


def test_a_bloated_worker_is_recycled(tmp_path):
    done, recycled = outcomes(tmp_path, {}, memory_mb=1.0)
    assert len(done) == 6
    assert recycled


def test_a_worker_that_bloats_within_a_job_is_replaced(tmp_path):
    done, recycled = outcomes(tmp_path, {1: "once bloat"}, jobs=range(3), bloat_mb=500.0)
    assert {k: o.result for k, o in done.items()} == {0: 0, 1: 1, 2: 4}
    assert "more than 500" in recycled[0].why


def test_what_each_job_held_at_most_is_told(tmp_path):
    done, _ = outcomes(tmp_path, {})
    assert all(5 < outcome.memory_mb < 1000 for outcome in done.values())


@pytest.mark.skipif(not os.path.exists("/proc/self/clear_refs"), reason="Linux only")
def test_peak_memory_is_that_since_the_last_call():
    peak_mb()
    held = b"x" * 200_000_000
    before = resident_mb()
    del held
    assert peak_mb() >= before - 5  # the kernel counts in batches
    assert peak_mb() < before - 100


def test_a_worker_that_cannot_start_says_why():
    with Pool(1, broken_factory, ()) as pool, pytest.raises(SdgenError, match="no renderer"):
        list(pool.run([0]))
