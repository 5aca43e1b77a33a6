"""graph.json: VirtualHome's keys, nothing lost, nothing given away."""

from sdgen.hazards.certify import facts_of
from sdgen.truth import build_graph
from sdgen.truth.graph import opaque_name

from tests import toy


def test_every_room_structure_and_object_is_a_node_sorted_by_id() -> None:
    made = toy.bundle(3)
    graph = made.graph
    home = made.scene.home
    ids = {r.id for r in home.rooms} | {s.id for s in home.structures}
    ids |= {item.id for item in made.scene.objects}
    assert [node.id for node in graph.nodes] == sorted(ids)


def test_keys_are_virtualhomes() -> None:
    node = toy.bundle(0).graph.model_dump()["nodes"][0]
    assert set(node) == {
        "id",
        "class_name",
        "category",
        "prefab_name",
        "obj_transform",
        "bounding_box",
        "properties",
        "states",
        "tags",
    }
    assert set(node["obj_transform"]) == {"position", "rotation", "scale"}
    assert set(node["bounding_box"]) == {"center", "size"}


def test_edges_say_what_stands_where() -> None:
    graph = toy.bundle(3).graph
    edges = {(e.from_id, e.relation_type, e.to_id) for e in graph.edges}
    assert (600, "ON", 77) in edges  # knife on the table
    assert (4000, "ON", 77) in edges
    assert (4000, "INSIDE", 305) not in edges
    assert (42, "BETWEEN", 100) in edges
    assert (42, "BETWEEN", 101) in edges
    assert (512, "INSIDE", 101) in edges
    assert (200, "INSIDE", 100) in edges
    assert not any(a == b for a, _, b in edges)


def test_edges_are_sorted_and_unique() -> None:
    edges = toy.bundle(3).graph.edges
    keys = [(e.from_id, e.to_id, e.relation_type) for e in edges]
    assert keys == sorted(set(keys))


def test_close_keeps_to_a_room() -> None:
    made = toy.bundle(3)
    room = {item.id: item.room_id for item in made.scene.objects}
    for edge in made.graph.edges:
        if edge.relation_type == "CLOSE":
            assert room[edge.from_id] == room[edge.to_id]


def test_prefab_names_say_nothing_of_the_variant() -> None:
    on = {n.id: n for n in toy.bundle(1).graph.nodes}[11]
    off = {n.id: n for n in toy.bundle(0).graph.nodes}[11]
    assert on.states == ("ON",)
    assert off.states == ("OFF",)
    assert on.prefab_name == off.prefab_name
    assert "stove" not in on.prefab_name.lower()


def test_opaque_names_tell_models_apart_and_never_change() -> None:
    assert opaque_name("mug_01") != opaque_name("mug_02")
    assert opaque_name("mug_01") == "PRE_" + opaque_name("mug_01")[4:]
    assert len(opaque_name("mug_01")) == 16


def test_room_box_spans_floor_to_ceiling() -> None:
    room = {n.id: n for n in toy.bundle(0).graph.nodes}[101]
    assert room.bounding_box.center == (2.0, 4.55, 1.25)
    assert room.bounding_box.size == (4.0, 2.9, 2.5)


def test_graph_depends_on_poses_not_on_object_order() -> None:
    made = toy.bundle(3).scene
    turned = made.model_copy(update={"objects": tuple(reversed(made.objects))})
    both = [
        build_graph(s, toy.infos(), toy.catalog(), facts_of(s, toy.infos(), toy.catalog()))
        for s in (made, turned)
    ]
    assert both[0] == both[1]
