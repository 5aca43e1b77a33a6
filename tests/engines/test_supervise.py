"""A build survives what its workers do."""

import errno
import os
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import pytest
from sdgen import seeding
from sdgen.engines import serve
from sdgen.engines.processes import Processes
from sdgen.engines.protocol import Answer, Died, Message, Outcome, Ready, Replaced
from sdgen.engines.supervise import STARTS, Limits, Supervised
from sdgen.errors import InputError, SceneRejected, SdgenError, WorkerFault
from sdgen.rejection import Cause
from sdgen.scratch import PREFIX


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
                held = bytearray(300_000_000)
                held[::4096] = b"x" * len(held[::4096])
                time.sleep(60)
            if how.endswith("raise"):
                raise ZeroDivisionError("oops")
            if how.endswith("reject"):
                raise SceneRejected(f"{job:06d}", {Cause("hazards", "no_place"): 3})
            if how.endswith("broken file"):
                raise InputError(["a.yaml:3: first", "a.yaml:4: second"])
            if how.endswith("no memory"):
                raise MemoryError
            if how.endswith("full disk"):
                raise OSError(errno.ENOSPC, "No space left on device", "/tmp/a.obj")
            if how.endswith("litter"):
                tempfile.mkdtemp(prefix="litter-")
        return job * job

    def close(self) -> None:
        pass


def broken_factory() -> Work:
    raise SdgenError("no renderer")


def dying_factory() -> Work:
    os._exit(7)


def clumsy_factory() -> Work:
    return {}["missing"]


def refused_factory() -> Work:
    open("/nowhere/at/all").close()


def engine(workers, factory, args=(), **limits):
    return Supervised(Processes(workers, factory, args), Limits(**limits))


def outcomes(tmp_path, bad, jobs=range(6), **limits):
    with engine(2, Work, (str(tmp_path), bad), **limits) as running:
        events = list(running.run(jobs))
        assert running.peak_mb > 10
    done = {e.job: e for e in events if isinstance(e, Outcome)}
    return done, [e for e in events if isinstance(e, Replaced)]


@pytest.fixture(autouse=True)
def own_temporary_folder(tmp_path_factory, monkeypatch):
    """Whatever a test leaves among the temporary files is a failure."""
    folder = tmp_path_factory.mktemp("tmp")
    monkeypatch.setattr(tempfile, "tempdir", str(folder))
    yield folder
    assert list(folder.iterdir()) == []


def test_all_jobs_come_back(tmp_path):
    done, recycled = outcomes(tmp_path, {})
    assert {k: o.result for k, o in done.items()} == {k: k * k for k in range(6)}
    assert recycled == []


def test_a_death_and_a_lack_of_memory_cost_one_retry_each(tmp_path):
    done, recycled = outcomes(tmp_path, {1: "once die", 3: "once no memory"})
    assert {k: o.result for k, o in done.items()} == {k: k * k for k in range(6)}
    assert sorted(event.why for event in recycled) == [
        "scene 000001: worker died (exit code 9)",
        "scene 000003: out of memory",
    ]


def test_a_programming_error_is_told_with_its_place_and_not_tried_again(tmp_path):
    done, recycled = outcomes(tmp_path, {3: "always raise"})
    assert {k for k, o in done.items() if o.error is None} == {0, 1, 2, 4, 5}
    error = done[3].error
    assert isinstance(error, WorkerFault)
    assert str(error).startswith("unexpected ZeroDivisionError: oops (test_supervise.py:")
    assert recycled == []


def test_an_error_of_the_input_comes_home_whole(tmp_path):
    bad = {0: "broken file"}
    with (
        engine(1, Work, (str(tmp_path), bad)) as running,
        pytest.raises(InputError) as caught,
    ):
        list(running.run([0]))
    assert caught.value.problems == ("a.yaml:3: first", "a.yaml:4: second")


def test_what_the_system_refuses_concerns_all_and_is_no_bug(tmp_path):
    with (
        engine(1, Work, (str(tmp_path), {0: "full disk"})) as running,
        pytest.raises(SdgenError) as caught,
    ):
        list(running.run(range(3)))
    assert not isinstance(caught.value, WorkerFault)
    assert str(caught.value) == "/tmp/a.obj: No space left on device"
    with engine(1, refused_factory) as running, pytest.raises(SdgenError) as caught:
        list(running.run([0]))
    assert str(caught.value) == "/nowhere/at/all: No such file or directory"


def test_no_room_for_the_order_of_workers_is_said_with_its_place(monkeypatch, own_temporary_folder):
    def full(path, data):
        raise OSError(errno.ENOSPC, "No space left on device")

    monkeypatch.setattr(Path, "write_bytes", full)
    said = rf"^{own_temporary_folder}/{PREFIX}\w+/order: No space left on device$"
    with pytest.raises(SdgenError, match=said):
        Processes(1, Work, ("folder", {}))


def test_what_workers_leave_among_temporary_files_goes_with_them(tmp_path, own_temporary_folder):
    with engine(2, Work, (str(tmp_path), dict.fromkeys(range(4), "litter"))) as running:
        assert sum(isinstance(e, Outcome) for e in running.run(range(4))) == 4
        assert list(own_temporary_folder.glob(f"{PREFIX}*/worker-*/litter-*"))
    assert list(own_temporary_folder.iterdir()) == []


def test_a_hung_worker_is_replaced(tmp_path):
    done, recycled = outcomes(tmp_path, {2: "once hang"}, jobs=range(3), timeout_s=1.0)
    assert {k: o.result for k, o in done.items()} == {0: 0, 1: 1, 2: 4}
    assert "no answer" in recycled[0].why


def test_a_job_that_always_fails_is_named_and_the_rest_is_done(tmp_path):
    done, _ = outcomes(tmp_path, {4: "always die", 5: "reject"})
    assert [k for k, o in sorted(done.items()) if o.error is None] == [0, 1, 2, 3]
    assert isinstance(done[4].error, SceneRejected)
    assert dict(done[5].error.causes) == {Cause("hazards", "no_place"): 3}
    assert dict(done[4].error.causes) == {Cause("worker", "died"): 2}


def test_a_bloated_worker_is_recycled(tmp_path):
    done, recycled = outcomes(tmp_path, {}, memory_mb=1.0)
    assert len(done) == 6
    assert recycled


def test_a_worker_that_bloats_within_a_job_is_replaced(tmp_path):
    done, recycled = outcomes(tmp_path, {1: "once bloat"}, jobs=range(3), bloat_mb=250.0)
    assert {k: o.result for k, o in done.items()} == {0: 0, 1: 1, 2: 4}
    assert "more than 250" in recycled[0].why


def test_what_each_job_held_at_most_is_told(tmp_path):
    done, _ = outcomes(tmp_path, {})
    assert all(5 < outcome.memory_mb < 1000 for outcome in done.values())


def test_a_worker_that_cannot_start_says_why():
    with engine(1, broken_factory) as running, pytest.raises(SdgenError, match="no renderer"):
        list(running.run([0]))


def test_a_programming_error_at_the_start_is_told_with_its_place():
    with engine(1, clumsy_factory) as running, pytest.raises(WorkerFault) as caught:
        list(running.run([0]))
    assert "unexpected KeyError: 'missing' (test_supervise.py:" in str(caught.value)


def test_workers_that_die_at_their_start_end_the_build():
    said = r"workers do not start: worker died \(exit code 7\)"
    with engine(2, dying_factory) as running, pytest.raises(SdgenError, match=said):
        list(running.run(range(4)))


class FakeWorker:
    """Is ready after ``start_s`` (None: dies instead); a job takes no time, or for ever."""

    def __init__(self, start_s: float | None, hangs: bool) -> None:
        self.ready_at = time.monotonic() + (start_s or 0.0)
        self.dies, self.hangs = start_s is None, hangs
        self.greeted = False
        self.job: int | None = None

    def give(self, job: int) -> None:
        self.job = job

    def held_mb(self) -> float:
        return 1.0

    def end(self) -> None:
        pass

    def says(self) -> Message | None:
        if not self.greeted:
            self.greeted = time.monotonic() >= self.ready_at
            if not self.greeted:
                return None
            return Died("died", "worker died (exit code 7)") if self.dies else Ready()
        if self.job is None or self.hangs:
            return None
        job, self.job = self.job, None
        return Answer(job * job)


class FakeLauncher:
    """Launches one fake worker after the other; the last one again and again."""

    def __init__(self, count: int, *workers: tuple[float | None, bool]) -> None:
        self.count, self.workers, self.launched = count, workers, 0

    def size(self) -> int:
        return self.count

    def launch(self) -> FakeWorker:
        self.launched += 1
        return FakeWorker(*self.workers[min(self.launched, len(self.workers)) - 1])

    def wait(self, workers, timeout_s: float):
        time.sleep(0.01)
        return [(one, said) for one in workers if (said := one.says()) is not None]

    def close(self) -> None:
        pass


def test_a_hang_longer_than_workers_may_take_to_start_costs_a_retry_too():
    limits = Limits(timeout_s=0.5, start_s=0.3)
    with Supervised(FakeLauncher(1, (0.05, True), (0.05, False)), limits) as running:
        events = list(running.run(range(2)))
    assert [event.why for event in events if isinstance(event, Replaced)] == [
        "scene 000000: no answer in 0 s"
    ]
    assert [event.result for event in events if isinstance(event, Outcome)] == [0, 1]


def test_a_worker_that_is_never_ready_ends_the_build():
    with (
        Supervised(FakeLauncher(1, (60.0, False)), Limits(start_s=0.2)) as running,
        pytest.raises(SdgenError, match="no worker has started"),
    ):
        list(running.run([0]))


def test_replacements_that_do_not_start_end_no_build_whose_other_workers_are_well():
    launcher = FakeLauncher(2, (0.0, False), (None, False))
    with Supervised(launcher) as running:
        assert [event.result for event in running.run(range(40))] == [k * k for k in range(40)]
    assert launcher.launched == 1 + STARTS  # and then a pause


def test_faults_are_told_by_the_innermost_line_of_the_package_and_of_all():
    def by_way_of_the_package():
        InputError(7)  # iterates over its problems

    with pytest.raises(WorkerFault, match=r"\(sdgen/errors\.py:\d+\)"):
        serve.set_up(by_way_of_the_package, ())
    with pytest.raises(WorkerFault) as caught:
        serve.set_up(lambda: seeding.lane(0, 0, 7), ())
    assert str(caught.value).startswith("unexpected AttributeError: ")
    assert "(sdgen/seeding.py:" in str(caught.value)
    assert "/" not in str(caught.value).replace("sdgen/seeding.py", "")


PARENT = """
import sys, time
from sdgen.engines.processes import Processes
from sdgen.engines.supervise import Supervised
from tests.engines.test_supervise import Sleep
with Supervised(Processes(2, Sleep, (sys.argv[1],))) as engine:
    list(engine.run(range(2)))
"""


class Sleep:
    """Notes its process number and sleeps."""

    def __init__(self, folder: str) -> None:
        open(os.path.join(folder, str(os.getpid())), "w").close()

    def __call__(self, job: int) -> int:
        time.sleep(60)
        return job


def alive(number: int) -> bool:
    """A process that is there and no zombie."""
    try:
        text = Path(f"/proc/{number}/stat").read_text(encoding="ascii", errors="replace")
    except OSError:
        return False
    return text.rpartition(")")[2].split()[0] != "Z"


@pytest.mark.skipif(not os.path.exists("/proc/self/stat"), reason="Linux only")
def test_workers_end_at_once_with_a_killed_parent_and_the_next_clears_up(tmp_path):
    notes, scratch = tmp_path / "notes", tmp_path / "scratch"
    notes.mkdir()
    scratch.mkdir()
    env = {**os.environ, "TMPDIR": str(scratch)}
    env["PYTHONPATH"] = os.pathsep.join(sys.path)
    parent = subprocess.Popen(
        [sys.executable, "-c", PARENT, str(notes)], env=env, stderr=subprocess.PIPE
    )
    try:
        deadline = time.monotonic() + 60
        while len(list(notes.iterdir())) < 2 and time.monotonic() < deadline:
            time.sleep(0.02)
        numbers = [int(path.name) for path in notes.iterdir()]
        assert len(numbers) == 2
        assert all(alive(number) for number in numbers)
    finally:
        parent.send_signal(signal.SIGKILL)
        said = parent.communicate()[1]
    deadline = time.monotonic() + 2
    while any(alive(number) for number in numbers) and time.monotonic() < deadline:
        time.sleep(0.01)
    assert not any(alive(number) for number in numbers)
    assert said == b""
    assert len(list(scratch.iterdir())) == 1
    subprocess.run(
        [sys.executable, "-c", "from sdgen.scratch import clear_dead; clear_dead()"],
        env=env,
        check=True,
    )
    assert list(scratch.iterdir()) == []
