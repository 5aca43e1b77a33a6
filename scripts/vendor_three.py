"""Makes the gallery's three.js anew: one classic script of what its 3-D view uses, and the licence.

    python scripts/vendor_three.py

Pages opened from disk can load neither modules nor other files, so three's core, its GLTF loader
and its orbit controls are bundled into one script that defines ``THREE`` (MIT licence). Needs npm
and its registry; versions are pinned, so that the bytes come out the same.
"""

from __future__ import annotations

import shutil
import subprocess
import tempfile
from pathlib import Path

THREE, ESBUILD = "0.187.0", "0.28.2"
VENDOR = Path(__file__).resolve().parent.parent / "generator" / "sdgen" / "gallery" / "vendor"
#: All that static/space*.js name.
USED = """BackSide Box3 BoxGeometry BufferAttribute BufferGeometry Color DirectionalLight DoubleSide
EdgesGeometry Group HemisphereLight Line LineBasicMaterial LineDashedMaterial LineSegments Mesh
MeshBasicMaterial MeshLambertMaterial PerspectiveCamera Plane Raycaster RepeatWrapping
SRGBColorSpace Scene ShaderMaterial Shape ShapeGeometry TextureLoader Vector2 Vector3
WebGLRenderer REVISION"""
ENTRY = f"""export {{ {", ".join(USED.split())} }} from "three";
export {{ GLTFLoader }} from "three/addons/loaders/GLTFLoader.js";
export {{ OrbitControls }} from "three/addons/controls/OrbitControls.js";
"""


def main() -> None:
    """Write ``three.min.js`` and ``three.LICENSE.txt``."""
    with tempfile.TemporaryDirectory() as folder:
        there = Path(folder)
        (there / "package.json").write_text('{"private": true}\n', encoding="utf-8")
        (there / "entry.js").write_text(ENTRY, encoding="utf-8")
        packages = [f"three@{THREE}", f"esbuild@{ESBUILD}"]
        subprocess.run(["npm", "install", "--silent", *packages], cwd=there, check=True)
        bundle = ["npx", "esbuild", "entry.js", "--bundle", "--minify", "--format=iife"]
        bundle += ["--global-name=THREE", "--target=es2020", f"--outfile={VENDOR}/three.min.js"]
        banner = f"/* three.js {THREE}, MIT licence: see three.LICENSE.txt */"
        subprocess.run([*bundle, f"--banner:js={banner}"], cwd=there, check=True)
        shutil.copy(there / "node_modules/three/LICENSE", VENDOR / "three.LICENSE.txt")


if __name__ == "__main__":
    main()
