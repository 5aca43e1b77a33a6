"""What a machine has, and what each worker may take of it."""

import os
import platform

import pytest
from sdgen.engines import machine
from sdgen.engines.machine import (
    WORKER_MB,
    free_mb,
    give_back,
    held_mb,
    peak_mb,
    worker_share_mb,
    workers_that_fit,
)


def fake(root, available_kb, cgroup="0::/\n", files=()):
    """A machine's root folder with these files of the kernel."""
    (root / "proc/self").mkdir(parents=True)
    (root / "proc/meminfo").write_text(f"MemTotal: 99 kB\nMemAvailable: {available_kb} kB\n")
    (root / "proc/self/cgroup").write_text(cgroup)
    for name, text in files:
        path = root / "sys/fs/cgroup" / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    return root


def test_without_limits_the_machine_counts(tmp_path):
    assert free_mb(fake(tmp_path, 20_000_000)) == pytest.approx(20_480)


def test_a_container_s_limit_counts_less_what_is_used_and_cannot_be_dropped(tmp_path):
    files = [
        ("memory.max", "4000000000\n"),
        ("memory.current", "1500000000\n"),
        ("memory.stat", "anon 1\ninactive_file 500000000\n"),
    ]
    assert free_mb(fake(tmp_path, 20_000_000, files=files)) == pytest.approx(3000)


def test_the_narrowest_group_on_the_way_up_counts(tmp_path):
    files = [
        ("slurm/job/memory.max", "max\n"),
        ("slurm/memory.max", "2000000000\n"),
        ("slurm/memory.current", "0\n"),
        ("slurm/memory.stat", "inactive_file 0\n"),
        ("memory.max", "9000000000\n"),
        ("memory.current", "0\n"),
        ("memory.stat", ""),
    ]
    assert free_mb(fake(tmp_path, 20_000_000, "0::/slurm/job\n", files)) == pytest.approx(2000)


def test_version_1_groups_are_read_too(tmp_path):
    files = [
        ("memory/slurm/memory.limit_in_bytes", "3000000000"),
        ("memory/slurm/memory.usage_in_bytes", "1000000000"),
        ("memory/slurm/memory.stat", "total_inactive_file 0\n"),
    ]
    cgroup = "5:cpu,cpuacct:/other\n4:memory:/slurm\n"
    assert free_mb(fake(tmp_path, 20_000_000, cgroup, files)) == pytest.approx(2000)


def test_where_nobody_can_tell_there_is_no_limit(tmp_path):
    assert free_mb(tmp_path) == 0.0
    assert worker_share_mb(4, 0.0) == float("inf")
    assert workers_that_fit(0.0) > 1000


def test_workers_share_what_is_free_and_never_get_too_little():
    assert 8000 < worker_share_mb(2, 22_000) < 11_000
    assert worker_share_mb(2, 22_000) == pytest.approx(2 * worker_share_mb(4, 22_000))
    assert worker_share_mb(16, 4000) == WORKER_MB
    for free in (3000.0, 6000.0, 64_000.0):
        count = workers_that_fit(free)
        assert count == 1 or count * worker_share_mb(count, free) <= 0.8 * free
    assert workers_that_fit(500) == 1


def test_default_workers_are_cores_as_far_as_memory_goes(monkeypatch):
    monkeypatch.setattr(machine, "usable_cores", lambda: 8)
    monkeypatch.setattr(machine, "free_mb", lambda: 64_000.0)
    assert machine.default_workers() == 8
    monkeypatch.setattr(machine, "free_mb", lambda: 5000.0)
    assert machine.default_workers() == 2


def test_without_proc_the_most_ever_held_is_in_the_system_s_own_unit(monkeypatch):
    resource = pytest.importorskip("resource")
    used = resource.getrusage(resource.RUSAGE_SELF)
    monkeypatch.setattr(resource, "getrusage", lambda _: used)
    monkeypatch.setattr(machine.sys, "platform", "linux")
    assert machine._ever_mb() == pytest.approx(used.ru_maxrss * 1024 / 1e6)
    monkeypatch.setattr(machine.sys, "platform", "darwin")
    assert machine._ever_mb() == pytest.approx(used.ru_maxrss / 1e6)


@pytest.mark.skipif(not os.path.exists("/proc/self/clear_refs"), reason="Linux only")
def test_peak_memory_is_that_since_the_last_call():
    peak_mb()
    held = b"x" * 200_000_000
    before = held_mb()
    del held
    most = peak_mb()
    assert most >= before - 5  # the kernel counts in batches
    assert peak_mb() < most - 150


@pytest.mark.skipif(not os.path.exists("/proc/self/statm"), reason="Linux only")
def test_mapped_files_do_not_count_as_held(tmp_path):
    import mmap

    path = tmp_path / "big"
    path.write_bytes(b"x" * 100_000_000)
    before = held_mb()
    with path.open("rb") as file, mmap.mmap(file.fileno(), 0, access=mmap.ACCESS_READ) as mapped:
        assert mapped[:: mmap.PAGESIZE].count(b"x") > 20_000
        assert held_mb() < before + 30


@pytest.mark.skipif(platform.libc_ver()[0] != "glibc", reason="glibc alone is asked")
def test_freed_memory_between_what_is_held_is_given_back():
    held, freed = [], []
    for _ in range(100):
        freed += [bytes(4096) for _ in range(500)]
        held.append(bytes(4096))
    freed.clear()
    before = held_mb()
    give_back()
    assert held_mb() < before - 100
    assert len(held) == 100
