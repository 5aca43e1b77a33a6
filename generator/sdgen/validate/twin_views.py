"""The masks of a twin against its scene's: they differ only where something that was changed is, or
was, to be seen.

Colours are not compared: what was changed casts other shadows.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from sdgen.dataset.item import SceneItem
from sdgen.dataset.scene_folder import view_folder
from sdgen.errors import InputError
from sdgen.scene import Scene
from sdgen.validate.problems import Problem


def check_twin_views(item: SceneItem, base: SceneItem) -> Iterator[Problem]:
    """Every pixel whose id or depth differs shows, in one of the two, an object that is not the
    same in both."""
    if item.entry.views != base.entry.views:
        return  # told of where the manifest is checked
    changed = changed_ids(item.scene, base.scene)
    for k in range(item.entry.views):
        if not all(one.has(k, "instance.png") for one in (item, base)):
            continue
        try:
            now, then = item.instance(k), base.instance(k)
            deep = all(one.has(k, "depth.png") for one in (item, base))
            depths = (item.depth_mm(k), base.depth_mm(k)) if deep else None
        except InputError:
            continue  # told of where the views of each are checked
        if now.shape != then.shape:
            continue
        same = ~np.isin(now, changed) & ~np.isin(then, changed)
        where = f"{view_folder(k)}/instance.png"
        wrong = same & (now != then)
        if wrong.any():
            y, x = np.argwhere(wrong)[0].tolist()
            text = (
                f"{int(wrong.sum())} pixels differ from those of {base.id} and show nothing that "
                f"was changed: {now[y, x]} for {then[y, x]} at {x}, {y}"
            )
            yield Problem("view", f"{item.where(where)}: {text}")
        elif depths is not None and (off := same & (depths[0] != depths[1])).any():
            y, x = np.argwhere(off)[0].tolist()
            text = (
                f"{int(off.sum())} pixels of what is as in {base.id} are not as deep: at {x}, {y}"
            )
            yield Problem("view", f"{item.where(f'{view_folder(k)}/depth.png')}: {text}")


def changed_ids(one: Scene, other: Scene) -> list[int]:
    """Ids of the objects that are in one of two scenes only, or not the same in both."""
    first, second = ({thing.id: thing for thing in scene.objects} for scene in (one, other))
    return sorted(k for k in first.keys() | second.keys() if first.get(k) != second.get(k))
