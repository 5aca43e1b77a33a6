"""The views of a data set one by one, as arrays: what a data loader feeds a network with."""

from __future__ import annotations

import operator
from collections.abc import Callable, Collection, Iterator, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from sdgen.dataset.tables import hazards_of
from sdgen.errors import UsageError, did_you_mean

if TYPE_CHECKING:
    from sdgen.dataset.item import SceneItem

#: What a frame may hold of its pixels.
PIXELS = ("rgb", "depth", "instance", "part")


class Frames(Sequence[Any]):
    """A map-style data set with an item a view, in the order of scenes and views.

    An item is a dict of ``scene`` (id), ``view``, ``room_type``, those of ``rgb`` (H, W, 3) uint8,
    ``depth`` (H, W) float32 metres, ``instance`` (H, W) uint16 and ``part`` (H, W) uint8 that were
    asked for, ``K`` (3, 3), ``world_from_camera`` (4, 4), and of the N objects the view shows
    ``object_ids`` (N,) int64, ``boxes`` (N, 4) float32 [x, y, w, h], ``categories`` and ``hazards``
    (N lists of hazard ids, empty for what is none). ``transform`` makes of it what a data loader
    shall have. Works with ``torch.utils.data.DataLoader`` and its workers; pickles and forks, for
    nothing is kept open. ``views`` counts those of each scene, ``sensors`` are what was built.
    """

    def __init__(
        self,
        scenes: Sequence[SceneItem],
        views: Sequence[int],
        sensors: Collection[str],
        pixels: Collection[str] = ("rgb", "instance"),
        transform: Callable[[dict[str, Any]], Any] | None = None,
    ) -> None:
        for name in pixels:
            if name not in PIXELS:
                raise UsageError(f"pixels: no {name!r}{did_you_mean(name, PIXELS)}")
            if ("instance" if name == "part" else name) not in sensors:
                raise UsageError(f"pixels: {name!r}: this data set was built without it")
        self.scenes = scenes
        self.pixels = tuple(pixels)
        self.transform = transform
        # (scene, view) as numbers, small whatever the number of scenes.
        self._index = np.array([(k, view) for k, n in enumerate(views) for view in range(n)])

    def __len__(self) -> int:
        return len(self._index)

    def __getitem__(self, index: int) -> Any:  # type: ignore[override]
        scene, view = self._index[operator.index(index)].tolist()
        frame = self._frame(scene, view)
        return frame if self.transform is None else self.transform(frame)

    def __iter__(self) -> Iterator[Any]:
        return (self[k] for k in range(len(self)))

    def _frame(self, scene: int, view: int) -> dict[str, Any]:
        item = self.scenes[scene]
        camera = item.cameras[view]
        things = {thing.id: thing for thing in item.scene.objects}
        hazards = hazards_of(item)
        shown = next((v.objects for v in item.visibility.views if v.view == view), ())
        frame: dict[str, Any] = {
            "scene": item.id,
            "view": view,
            "room_type": next(r.type for r in item.scene.home.rooms if r.id == camera.room_id),
        }
        for name in self.pixels:
            frame[name] = getattr(item, name)(view)
        return frame | {
            "K": np.asarray(camera.K, dtype=np.float64),
            "world_from_camera": np.asarray(camera.world_from_camera, dtype=np.float64),
            "object_ids": np.array([seen.object_id for seen in shown], dtype=np.int64),
            "boxes": np.array([seen.bbox for seen in shown], dtype=np.float32).reshape(-1, 4),
            "categories": [things[seen.object_id].category for seen in shown],
            "hazards": [hazards.get(seen.object_id, []) for seen in shown],
        }
