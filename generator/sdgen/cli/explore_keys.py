"""Walking by keys in a terminal."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

import click
import numpy as np

if TYPE_CHECKING:
    from sdgen.agent.episode import Episode, Result
    from sdgen.agent.eyes import Look

#: A half block shows two pixels, one above the other.
_HALF = "\u2580"
#: Columns of the picture, and things that are named below it.
_COLUMNS, _NAMED = 80, 8

HELP = (
    "w forward   a/d turn left/right   q/e look up/down   s scan   g go to   o open   c close   "
    "r report   x stop"
)


def by_keys(episode: Episode) -> None:
    """Walk until it is over or ``x`` is pressed."""
    plain: dict[str, Callable[[], Result]] = {
        "w": episode.forward,
        "a": episode.turn,
        "d": lambda: episode.turn(-1),
        "q": episode.tilt,
        "e": lambda: episode.tilt(-1),
        "s": episode.scan,
        "x": episode.stop,
    }
    aimed: dict[str, Callable[[int], Result]] = {
        "g": episode.go_to,
        "o": episode.open,
        "c": episode.close,
    }
    _show(episode, episode.look())
    while not episode.over:
        key = click.getchar()
        if key in plain:
            result = plain[key]()
        elif key in aimed:
            result = aimed[key](click.prompt("id", type=int))
        elif key == "r":
            result = _report(episode)
        else:
            click.echo(HELP)
            continue
        if result.looks:
            _show(episode, result.looks[-1])
        if result.refused is not None:
            click.echo(f"refused: {result.refused}")
        if result.collided:
            click.echo("something is in the way")


def _report(episode: Episode) -> Result:
    from sdgen.agent.moves import LABELS, NOTIFY

    key = click.prompt("id", type=int)
    label = click.prompt("label", type=click.Choice(LABELS))
    notify = click.prompt("notify", type=click.Choice(NOTIFY), default="now")
    return episode.report(key, label, notify)


def _show(episode: Episode, look: Look) -> None:
    """The picture in colours, where one is, and what is before one with its id."""
    click.clear()
    click.echo(blocks(look))
    rooms = {room.id: room.type for room in episode.stage.scene.home.rooms}
    room = rooms[episode.room_id].replace("_", " ")
    click.echo(f"step {episode.steps}, {episode.path_m:.1f} m, in room {episode.room_id}: {room}")
    click.echo("before you: " + (", ".join(_named(episode, look)) or "walls"))
    click.echo(HELP)


def blocks(look: Look, columns: int = _COLUMNS) -> str:
    """A picture as lines of coloured half blocks."""
    height, width = look.rgb.shape[:2]
    rows = max(2, round(columns * height / width) // 2 * 2)
    across = (np.arange(columns) + 0.5) * width / columns
    down = (np.arange(rows) + 0.5) * height / rows
    small = look.rgb[down.astype(int)][:, across.astype(int)]
    lines = []
    for k in range(0, rows, 2):
        cells = [
            f"\x1b[38;2;{a[0]};{a[1]};{a[2]}m\x1b[48;2;{b[0]};{b[1]};{b[2]}m{_HALF}"
            for a, b in zip(small[k].tolist(), small[k + 1].tolist(), strict=True)
        ]
        lines.append("".join(cells) + "\x1b[0m")
    return "\n".join(lines)


def _named(episode: Episode, look: Look) -> list[str]:
    ids, counts = np.unique(look.instance, return_counts=True)
    things = episode.house.bodies
    found = sorted(
        ((count, key) for key, count in zip(ids.tolist(), counts.tolist(), strict=True)),
        reverse=True,
    )
    shown = [(key, things[key].item) for _, key in found if key in things]
    return [f"{item.category.replace('_', ' ')} {key}" for key, item in shown[:_NAMED]]
