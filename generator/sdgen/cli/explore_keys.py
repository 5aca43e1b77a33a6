"""Walking by keys in a terminal."""

from __future__ import annotations

import shutil
from collections.abc import Callable
from typing import TYPE_CHECKING

import click
import numpy as np

from sdgen.errors import UsageError

if TYPE_CHECKING:
    from sdgen.agent.episode import Episode, Result
    from sdgen.agent.eyes import Look

#: A half block shows two pixels, one above the other.
_HALF = "\u2580"
#: Columns of the picture, and things that are named below it.
_COLUMNS, _NAMED = 80, 8
#: Lines of text below the picture.
_LINES = 6

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
        try:
            result = _done(episode, plain, aimed)
        except (KeyboardInterrupt, EOFError, click.Abort):
            result = episode.stop()  # what was walked is kept
        except UsageError as error:
            click.echo(str(error))
            continue
        if result is None:
            click.echo(HELP)
            continue
        for look in result.looks:
            _show(episode, look)
        if result.refused is not None:
            click.echo(f"refused: {result.refused}")
        if result.collided:
            click.echo("something is in the way")


def _done(
    episode: Episode,
    plain: dict[str, Callable[[], Result]],
    aimed: dict[str, Callable[[int], Result]],
) -> Result | None:
    """What came of the next key; None for one that means nothing, or that was taken back."""
    key = click.getchar()
    if key in plain:
        return plain[key]()
    if key not in aimed and key != "r":
        return None
    target = _asked(episode)
    if target is None:
        return None
    return _report(episode, target) if key == "r" else aimed[key](target)


def _asked(episode: Episode) -> int | None:
    """The id of a room or object, by its name too; None where only Enter is pressed."""
    from sdgen.agent.script import meant

    word = click.prompt("id or name (Enter: none)", default="", show_default=False).strip()
    if not word:
        return None
    return meant(episode, int(word) if word.isascii() and word.isdigit() else word)


def _report(episode: Episode, key: int) -> Result:
    from sdgen.agent.moves import LABELS, NOTIFY

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


def blocks(look: Look) -> str:
    """A picture as lines of coloured half blocks, as large as the terminal takes."""
    height, width = look.rgb.shape[:2]
    wide, high = shutil.get_terminal_size()
    columns = max(2, min(_COLUMNS, wide, (high - _LINES) * 2 * width // height))
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
