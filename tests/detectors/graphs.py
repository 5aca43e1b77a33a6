"""Small graphs for tests."""

from __future__ import annotations

from sdgen.scene import BoundingBox, Graph, GraphEdge, GraphNode, ObjTransform

ROOMS = ("kitchen", "living_room")


def node(
    number: int, name: str, states: tuple[str, ...] = (), tags: tuple[str, ...] = ()
) -> GraphNode:
    """A node; rooms and structures by their names."""
    kinds = {"floor": "Floor"} | dict.fromkeys(ROOMS, "Rooms")
    return GraphNode(
        id=number,
        class_name=name,
        category=kinds.get(name, "Props"),
        prefab_name="",
        obj_transform=ObjTransform(position=(0, 0, 0), rotation=(0, 0, 0, 1)),
        bounding_box=BoundingBox(center=(0, 0, 0), size=(1, 1, 1)),
        states=states,
        tags=tags,
    )


def graph(nodes: list[GraphNode], *edges: tuple[int, str, int]) -> Graph:
    """A graph of them."""
    made = tuple(GraphEdge(from_id=a, to_id=b, relation_type=r) for a, r, b in edges)
    return Graph(nodes=tuple(nodes), edges=made)


def kitchen() -> Graph:
    """Two apples, one of them mouldy, milk in a fridge, a mug on nothing."""
    return graph(
        [
            node(1, "kitchen"),
            node(2, "floor"),
            node(3, "kitchen_counter"),
            node(4, "fridge", ("CLOSED", "ON")),
            node(5, "apple"),
            node(6, "apple"),
            node(7, "apple", ("EXPIRED",)),
            node(8, "milk_carton", ("OPENED",), ("IN_WALKWAY",)),
            node(9, "mug"),
        ],
        *((k, "INSIDE", 1) for k in (2, 3, 4, 5, 6, 7, 8, 9)),
        (3, "ON", 2),
        (4, "ON", 2),
        (5, "ON", 3),
        (6, "ON", 3),
        (7, "ON", 3),
        (8, "INSIDE", 4),
        (9, "NEAR_HEAT", 4),
        (9, "ON", 777),
    )
