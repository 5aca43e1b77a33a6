"""What a worker on a Ray cluster may hold, without a cluster."""

from pathlib import Path

from sdgen.engines import on_ray
from sdgen.engines.machine import usable_cores, worker_share_mb
from sdgen.engines.on_ray import Actor, workers_on
from sdgen.engines.protocol import Ready
from sdgen.engines.remote import Order

NODES = [
    {"NodeID": "big", "Resources": {"CPU": 16.0, "memory": 1e10}},
    {"NodeID": "small", "Resources": {"CPU": 2.0}},
    {"NodeID": "none", "Resources": {}},
]


def test_a_machine_s_memory_is_shared_by_the_workers_that_may_be_there():
    assert workers_on(NODES, "big", None) == 16
    assert workers_on(NODES, "big", 3) == 3
    assert workers_on(NODES, "small", 3) == 2
    assert workers_on(NODES, "none", None) == 1
    assert workers_on(NODES, "gone", None) == usable_cores()


def test_a_worker_s_share_follows_from_the_workers_that_were_asked_for(monkeypatch):
    monkeypatch.setattr(on_ray, "set_up", lambda *_: None)
    monkeypatch.setattr(on_ray, "free_mb", lambda: 20_000.0)
    monkeypatch.setattr(on_ray, "_workers_here", lambda asked: asked)
    order = Order(setup=None, versions={}, shipped=Path("x"), probe=None, workers=1)
    assert Actor.__new__(Actor).start(order) == Ready(worker_share_mb(1, 20_000.0))
