"""What a build was asked for. Content options decide labels; render options only pictures."""

from __future__ import annotations

from typing import Literal

from pydantic import Field

from sdgen.errors import UsageError
from sdgen.looks import CameraLook
from sdgen.scene import Record

#: About where home robots that reach table tops (Stretch, TIAGo) carry their head camera.
EYE_HEIGHT_M = 1.2

Sensor = Literal["rgb", "depth", "instance"]

#: Scenes of one data set: their ids have six digits, and what is listed a scene stays small.
MAX_SCENES = 1_000_000
#: Views of one scene: their folders have two digits.
MAX_VIEWS = 99
#: Views of a scene whose rooms have a turn each, about: of six to seven rooms.
_TURNS_ABOUT = 40
#: What others read a seed as: a whole number of 64 bits with a sign.
MAX_SEED = 2**63 - 1


class BuildOptions(Record):
    """Options of ``sdgen build`` that a data set remembers."""

    n: int = Field(default=10, ge=0, le=MAX_SCENES)
    seed: int = Field(default=0, ge=0, le=MAX_SEED)
    homes: Literal["base", "procedural", "mixed", "imported"] = "mixed"
    hazards_min: int = Field(default=0, ge=0)
    hazards_max: int = Field(default=5, ge=0)
    draw: Literal["balanced", "iid"] = "balanced"
    extensions: tuple[str, ...] = ()
    views: int = Field(default=8, ge=0, le=MAX_VIEWS)
    #: ``panorama``: a turn of views in each room, whatever ``views`` says.
    views_mode: Literal["chosen", "panorama"] = "chosen"
    #: Stitch each turn to an equirectangular picture, too.
    equirect: bool = False
    width: int = Field(default=640, ge=16, le=4096)
    height: int = Field(default=480, ge=16, le=4096)
    sensors: tuple[Sensor, ...] = ("rgb", "depth", "instance")
    rgb: Literal["png", "jpg"] = "png"
    supersample: Literal[1, 2] = 1
    look: CameraLook = CameraLook()
    #: ``auto`` or a name in ``sdgen.render.RENDERERS``, which ``choose_renderer`` checks.
    renderer: str = "auto"
    eye_height_m: float = Field(default=EYE_HEIGHT_M, gt=0.1, le=2.2)
    twins: bool = False
    toggles: bool = False
    observability: bool = False
    #: Small things of the folders of ``--assets`` alone, as far as these have them.
    assets_only: bool = False
    #: Ids of the hazards that are drawn, sorted; empty: all. The others are proved absent.
    only: tuple[str, ...] = ()

    @property
    def most_folders(self) -> int:
        """Folders that a scene has at most, its twins' with its own: each is drawn and written."""
        return 1 + self.twins + (self.hazards_max if self.toggles else 0)

    @property
    def draws(self) -> bool:
        """True when these options ask for any picture, so that a renderer is needed."""
        return bool(self.sensors) and self.views_about > 0

    @property
    def views_about(self) -> int:
        """Views of a scene: as many as asked for, or about so many where rooms have turns."""
        return self.views if self.views_mode == "chosen" else _TURNS_ABOUT

    @property
    def stitches(self) -> bool:
        """True when panoramas are written: there are turns, and something to stitch of them."""
        wished = self.equirect and self.views_mode == "panorama"
        return wished and not {"rgb", "instance"}.isdisjoint(self.sensors)


def command_of(options: BuildOptions) -> str:
    """The command line that asks for these options, but for those that are the usual ones."""
    said, usual = _flags(options), _flags(BuildOptions())
    words = [f"{name} {value}" for name, value in said.items() if value != usual[name]]
    words += [f"--{name}" for name, wished in _switches(options) if wished]
    return " ".join(["sdgen build", f"--n {options.n} --seed {options.seed}", *words])


def _flags(options: BuildOptions) -> dict[str, str]:
    return {
        "--hazards": f"{options.hazards_min}-{options.hazards_max}",
        "--homes": options.homes,
        "--only": ",".join(options.only),
        "--extensions": ",".join(options.extensions),
        "--draw": options.draw,
        "--views": str(options.views),
        "--views-mode": options.views_mode,
        "--size": f"{options.width}x{options.height}",
        "--sensors": ",".join(options.sensors) or "none",
        "--eye-height": f"{options.eye_height_m:g}",
        "--rgb": options.rgb,
        "--supersample": str(options.supersample),
        "--look": str(options.look),
        "--renderer": options.renderer,
    }


def _switches(options: BuildOptions) -> tuple[tuple[str, bool], ...]:
    return (
        ("twins", options.twins),
        ("toggles", options.toggles),
        ("equirect", options.equirect),
        ("observability", options.observability),
        ("assets-only", options.assets_only),
    )


def check_index_range(first: int, end: int, n: int) -> None:
    """UsageError when ``first`` to ``end`` - 1 are not scenes of a data set of ``n``."""
    if not 0 <= first <= end:
        raise UsageError(f"--range {first}:{end} holds no scene")
    if end > n:
        raise UsageError(f"--range {first}:{end} goes past --n {n}")
