"""A scene graph in the paper's words: ``apple INSIDE kitchen ON counter``.

Mullen et al. parsed "the edge representing the room the object was inside, and the edge for what
the object was on top of". What lies in a container and on nothing has INSIDE for it. Their class
names alone told of spills and rotten fruit; ours do not, so the states that a graph shows stand in
brackets behind the name, those that are nothing out of the ordinary (OFF, CLOSED) left out.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property

from sdgen.detectors.told import things
from sdgen.scene import Graph, GraphNode
from sdgen.vocabulary import ROOM_SUPERCLASS

#: States of a thing that is as one leaves it.
ORDINARY = frozenset({"OFF", "CLOSED", "EMPTY", "CLEAN", "DRY", "FOLDED"})
#: Further relations and tags, with ``more``: the word in a string, and of tags the noun.
_MORE_EDGES = {
    "UNDER": "UNDER",
    "BLOCKS": "BLOCKS",
    "NEAR_HEAT": "NEARHEAT",
    "NEAR_WATER": "NEARWATER",
}
_MORE_TAGS = {
    "IN_WALKWAY": "IN walkway",
    "IN_DOORWAY": "IN doorway",
    "NEAR_EDGE": "NEAR edge",
    "IN_REACH_OF_CHILD": "INREACHOF child",
}
#: Of a stranger's name, so much is shown.
_LONGEST = 60


@dataclass(frozen=True)
class Wording:
    """``states``: shown in brackets; ``more``: with tags and our further relations."""

    states: bool = True
    more: bool = False


#: As the graph has it, with the paper's two relations.
AS_SHOWN = Wording()


@dataclass(frozen=True)
class Piece:
    """A thing in words, all nodes it stands for, and the room they are in (None: not known)."""

    text: str
    ids: tuple[int, ...]
    room_id: int | None


class Words:
    """The words of one graph. Nodes and edges may be anybody's: what leads nowhere is left out."""

    def __init__(self, graph: Graph, wording: Wording = AS_SHOWN) -> None:
        self._graph = graph
        self._wording = wording

    @cached_property
    def _nodes(self) -> dict[int, GraphNode]:
        return {node.id: node for node in self._graph.nodes}

    @cached_property
    def _edges(self) -> dict[tuple[int, str], list[GraphNode]]:
        """What a node has some relation to, by id."""
        wanted = {"INSIDE", "ON", *_MORE_EDGES}
        out: dict[tuple[int, str], list[GraphNode]] = {}
        for edge in sorted(self._graph.edges, key=lambda e: e.to_id):
            if edge.relation_type in wanted and edge.to_id in self._nodes:
                to = self._nodes[edge.to_id]
                out.setdefault((edge.from_id, edge.relation_type), []).append(to)
        return out

    def room(self, node: GraphNode) -> GraphNode | None:
        """The room that a thing is in."""
        inside = self._edges.get((node.id, "INSIDE"), ())
        return next((to for to in inside if to.category == ROOM_SUPERCLASS), None)

    def held(self, node: GraphNode) -> tuple[str, GraphNode] | None:
        """What a thing is ON, else what it is INSIDE but the room."""
        for to in self._edges.get((node.id, "ON"), ()):
            return "ON", to
        for to in self._edges.get((node.id, "INSIDE"), ()):
            if to.category != ROOM_SUPERCLASS:
                return "INSIDE", to
        return None

    def name(self, node: GraphNode, gap: str = "") -> str:
        """``milkcarton (open)``; ``gap`` between the words of a name."""
        name = plain_word(node.class_name, gap)
        states = [plain_word(state, " ").lower() for state in node.states if state not in ORDINARY]
        return f"{name} ({', '.join(states)})" if states and self._wording.states else name

    def relation(self, node: GraphNode) -> str:
        """``apple INSIDE kitchen ON counter``."""
        parts = [self.name(node)]
        room, held = self.room(node), self.held(node)
        if room is not None:
            parts.append(f"INSIDE {plain_word(room.class_name)}")
        if held is not None:
            parts.append(f"{held[0]} {plain_word(held[1].class_name)}")
        if self._wording.more:
            parts += self._more(node)
        return " ".join(parts)

    def _more(self, node: GraphNode) -> Iterator[str]:
        for relation, word in _MORE_EDGES.items():
            names = {plain_word(to.class_name) for to in self._edges.get((node.id, relation), ())}
            yield from (f"{word} {name}" for name in sorted(names))
        yield from (word for tag, word in _MORE_TAGS.items() if tag in node.tags)

    def phrase(self, node: GraphNode) -> str:
        """``apple on the counter in the kitchen``."""
        parts = [self.name(node, " ")]
        room, held = self.room(node), self.held(node)
        if held is not None:
            how = "on" if held[0] == "ON" else "in"
            parts.append(f"{how} the {plain_word(held[1].class_name, ' ')}")
        if room is not None:
            parts.append(f"in the {plain_word(room.class_name, ' ')}")
        return " ".join(parts)

    def relations(self) -> tuple[Piece, ...]:
        """All that may be reported, a string once, room by room."""
        return self._pieces(self.relation)

    def phrases(self) -> tuple[Piece, ...]:
        """The same for sentences."""
        return self._pieces(self.phrase)

    def names(self) -> tuple[Piece, ...]:
        """The same by names alone, wherever the things are."""
        return self._pieces(self.name, by_room=False)

    def _pieces(self, words: Callable[[GraphNode], str], by_room: bool = True) -> tuple[Piece, ...]:
        found: dict[str, list[GraphNode]] = {}
        for node in things(self._graph):
            found.setdefault(words(node), []).append(node)
        pieces = [self._piece(text, nodes, by_room) for text, nodes in found.items()]
        return tuple(sorted(pieces, key=lambda piece: (piece.room_id or 0, piece.text)))

    def _piece(self, text: str, nodes: Iterable[GraphNode], by_room: bool) -> Piece:
        nodes = sorted(nodes, key=lambda node: node.id)
        room = self.room(nodes[0]) if by_room else None
        return Piece(text, tuple(node.id for node in nodes), room.id if room else None)


def sentences(pieces: Iterable[Piece]) -> str:
    """A description: ``There is apple on the counter in the kitchen.`` and so on."""
    return " ".join(f"There is {_article(piece.text)}{piece.text}." for piece in pieces)


def _article(text: str) -> str:
    return "an " if text[:1] in "aeiou" else "a "


def plain_word(word: str, gap: str = "") -> str:
    """A stranger's word for a string: no underscores, and nothing that ends a line, a quotation or
    a list."""
    kept = "".join(
        letter if letter.isprintable() and letter not in "'\"`[](){}<>,:;*#\\|" else " "
        for letter in word[: 4 * _LONGEST]
    )
    return gap.join(kept.replace("_", " ").split())[:_LONGEST].strip() or "thing"
