"""Build models: `blender --background --factory-startup --python build.py -- [--all] WORD...`

A word is a model's id (mug_01), a category (mug) or a family (crockery). Writes textures under
assets/, meshes and records into build/assets/; run assemble.py afterwards. With SDGEN_DRAFT=1 in
the environment the occlusion is coarse and quick.
"""

from __future__ import annotations

import importlib
import sys
import time
import traceback
import zlib
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))

from toolkit.finish import finish  # noqa: E402
from toolkit.model import Maker  # noqa: E402
from toolkit.uv_bake import reset_blender  # noqa: E402

ASSETS = HERE.parent
RECORDS = ASSETS.parent / "build" / "assets"


#: Pixels a side of the textures of what is large in pictures of rooms and has seams, grooves or
#: rims that would fall apart into dots; these are baked with clear joints, too.
FINE = {
    256: (
        "bathroom_cabinet",
        *(f"double_door_{k:02d}" for k in (3, 5, 6, 9, 10)),
        "door_03",
        *(f"freezer_{k:02d}" for k in (2, 5, 8)),
    ),
    512: (
        "armchair_07",
        "bookshelf_08",
        "bed_08",
        "child_bed",
        *(f"door_{k:02d}" for k in (1, 2, *range(4, 11))),
        *(f"double_door_{k:02d}" for k in (1, 2, 4, 7, 8)),
        "dresser_02",
        *(f"fridge_{k:02d}" for k in (2, 5, 6, 11)),
        "front_door",
        "passage",
        *(f"picture_frame_{k:02d}" for k in (3, 7)),
        "sofa_08",
        *(f"utility_cupboard_{k:02d}" for k in (6, 7)),
        *(f"wardrobe_{k:02d}" for k in (1, 2, 3, 4, 5, 7, 8)),
        "wide_passage",
    ),
    1024: ("sofa_04", "sofa_09"),
}


def families() -> dict[str, dict[str, Maker]]:
    """Family name -> its categories; a family that cannot be imported is reported and skipped."""
    found = {}
    for path in sorted((HERE / "makers").glob("[a-z]*.py")):
        try:
            found[path.stem] = getattr(importlib.import_module(f"makers.{path.stem}"), "MODELS", {})
        except Exception:
            print(f"FAILED to import makers/{path.name}")
            traceback.print_exc()
    return found


def build_one(family: str, category: str, maker: Maker, index: int) -> str:
    reset_blender()
    rng = np.random.default_rng([zlib.crc32(category.encode()), index])
    parameters = maker.sample(rng)
    if index <= len(maker.presets):
        parameters |= maker.presets[index - 1]
    model = maker.make(**parameters)
    source = f"blender:{family}.{maker.make.__name__}"
    asset_id = f"{category}_{index:02d}"
    for pixels, words in FINE.items():
        if category in words or asset_id in words:
            model.texture_size, model.clear_joints = pixels, True
    return finish(model, asset_id, category, source, ASSETS, RECORDS)


def main(words: list[str]) -> int:
    for folder in (RECORDS / "meshes", ASSETS / "textures"):
        folder.mkdir(parents=True, exist_ok=True)
    failures = matched = 0
    for family, models in families().items():
        for category, maker in models.items():
            for index in range(1, maker.count + 1):
                names = {family, category, f"{category}_{index:02d}"}
                if index in maker.gone or ("--all" not in words and not names & set(words)):
                    continue
                matched += 1
                start = time.monotonic()
                try:
                    line = build_one(family, category, maker, index)
                    print(f"BUILT {line} ({time.monotonic() - start:.1f} s)", flush=True)
                except Exception:
                    failures += 1
                    print(f"FAILED {category}_{index:02d}")
                    traceback.print_exc()
    print(f"{matched - failures} built, {failures} failed")
    return 1 if failures or not matched else 0


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1 :] if "--" in sys.argv else []
    sys.exit(main(arguments))
