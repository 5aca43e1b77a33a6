"""Parts as links of bodies: their handles in the EGL plugin."""

from __future__ import annotations

from sdgen.render.part_bodies import NOBODY, _Handles


def test_a_part_has_its_own_number_for_a_handle_whatever_was_drawn_before() -> None:
    """The plugin gives what came back last out first, body by body and link by link."""
    handles, free, ever = _Handles(), [], 0
    for parts in (350, 20, 127, 500, 128, 350):
        order = handles.give(parts)
        assert len(order) % 127 == 0
        given = []
        for _ in order:
            if not free:
                free, ever = [ever], ever + 1
            given.append(free.pop())
        made = {k: handle for k, handle in zip(order, given, strict=True) if k != NOBODY}
        assert made == {part: part for part in range(parts)}
        handles.all_removed()
        for first in reversed(range(0, len(given), 127)):
            free += given[first : first + 127]
