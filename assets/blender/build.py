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
    return finish(model, f"{category}_{index:02d}", category, source, ASSETS, RECORDS)


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
