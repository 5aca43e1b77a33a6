"""Give a texture a state: `blender --background --factory-startup --python retexture.py -- ARGS`
or `python retexture.py -- ARGS` where bpy is installed. `sdgen assets retexture` does both.

ARGS: JOB.npz RESULT.npz LOOK KIND SEED. JOB holds `vertices` (N, 3) in metres, Z up, `normals`
(N, 3), `uvs` (N, 2) with v upwards, `faces` (M, 3) and `texture` (H, W, 3), sRGB of 8 bits, first
row on top. RESULT gets `texture`, the same size, and `covered` (H, W): the texels of the mesh.
Needs nothing but Blender (3.4 or later) and NumPy: its own, else that of $SDGEN_SITE_PACKAGES.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

sys.dont_write_bytecode = True  # it may lie in somebody's site-packages
sys.path.insert(0, str(Path(__file__).resolve().parent))

import bpy  # noqa: E402

try:
    import numpy as np
except ModuleNotFoundError:  # Debian's Blender comes without
    sys.path.append(os.environ.get("SDGEN_SITE_PACKAGES", ""))
    try:
        import numpy as np
    except ImportError as error:
        why = str(error).strip().split("\n")[0]
        raise SystemExit(f"this Blender has no NumPy: install python3-numpy ({why})") from None

OLDEST = (3, 4, 0)
SAMPLES = 4  # each at another place of the texel: drawn edges are smooth
SPOTS, FEWEST_SPOTS = 12, 4
SIZES_M = (0.006, 0.2)
MAX_CELLS = 64  # tiles of the texture that one triangle may cross


def linear(srgb: np.ndarray) -> np.ndarray:
    return np.where(srgb <= 0.04045, srgb / 12.92, ((srgb + 0.055) / 1.055) ** 2.4)


def to_srgb(x: np.ndarray) -> np.ndarray:
    x = np.clip(x, 0, 1)
    return np.where(x <= 0.0031308, x * 12.92, 1.055 * x ** (1 / 2.4) - 0.055)


def areas(vertices: np.ndarray, faces: np.ndarray) -> np.ndarray:
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    return np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2


def spot_size(vertices: np.ndarray, faces: np.ndarray) -> float:
    """The radius of a round thing; less for what is long or flat, metres."""
    ball = np.sqrt(areas(vertices, faces).sum() / (4 * np.pi))
    thin = np.sort(np.ptp(vertices, axis=0))[:2].mean() / 2
    return float(np.clip(np.sqrt(ball * max(thin, ball * 0.2)), *SIZES_M))


def spots_of(vertices, faces, size: float, rng: np.random.Generator) -> np.ndarray:
    """Points of the skin, far from one another; those that look up are the likelier."""
    weight = areas(vertices, faces)
    count = int(np.clip(1.3 * weight.sum() / (4 * np.pi * size * size) * 5, FEWEST_SPOTS, SPOTS))
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    normal = np.cross(b - a, c - a)
    normal /= np.maximum(np.linalg.norm(normal, axis=1, keepdims=True), 1e-12)
    weight = weight * np.interp(normal[:, 2], [-0.7, -0.2, 0.3, 1], [0.01, 0.5, 0.7, 1])
    pick = rng.choice(len(faces), 60 * count, p=weight / weight.sum())
    u, v = rng.uniform(0, 1, (2, len(pick), 1))
    u, v = np.where(u + v > 1, 1 - u, u), np.where(u + v > 1, 1 - v, v)
    points = a[pick] + u * (b[pick] - a[pick]) + v * (c[pick] - a[pick])
    chosen = [points[0]]
    near = np.linalg.norm(points - chosen[0], axis=1)
    for _ in range(count - 1):
        chosen.append(points[near.argmax()])
        near = np.minimum(near, np.linalg.norm(points - chosen[-1], axis=1))
    return np.array(chosen)


def bottom_of(vertices, faces) -> np.ndarray:
    """The point that looks up nearest to the middle: the bottom of a bowl, the middle of a lid."""
    a, b, c = (vertices[faces[:, k]] for k in range(3))
    middle = (a + b + c) / 3
    off = np.linalg.norm((middle - (vertices.min(0) + vertices.max(0)) / 2)[:, :2], axis=1)
    normal = np.cross(b - a, c - a)
    looks_up = normal[:, 2] > 0.7 * np.linalg.norm(normal, axis=1)
    return middle[np.where(looks_up, off, off + 100).argmin()]


def unrolled(faces: np.ndarray, uvs: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Faces (K, 3) and their UVs (K, 3, 2), so that all of a repeating texture lies in 0..1.

    A triangle comes once for each tile that it reaches into.
    """
    uv = uvs[faces]
    low = np.floor(uv.min(1) + 1e-6).astype(int)
    tiles = np.maximum(np.ceil(uv.max(1) - 1e-6).astype(int) - low, 1)
    tiles = np.where(tiles.prod(1, keepdims=True) > MAX_CELLS, 1, tiles)
    which, shift = [], []
    for i in range(int(tiles[:, 0].max())):
        for j in range(int(tiles[:, 1].max())):
            some = np.flatnonzero((tiles[:, 0] > i) & (tiles[:, 1] > j))
            which.append(some)
            shift.append(low[some] + [i, j])
    index = np.concatenate(which)
    return faces[index], uv[index] - np.concatenate(shift)[:, None, :]


def build(vertices, normals, faces, uv):
    """One Blender object with what materials ask for: `rest`, `facing` and the UVs `bake`."""
    data = bpy.data.meshes.new("model")
    data.from_pydata(vertices.tolist(), [], faces.tolist())
    data.update()
    if len(data.polygons) != len(faces):
        raise RuntimeError("Blender dropped faces")
    layer = data.uv_layers.new(name="bake")
    layer.data.foreach_set("uv", np.ascontiguousarray(uv, np.float32).ravel())
    layer.active_render = True
    data.uv_layers.active = layer
    for name, values in (("rest", vertices), ("facing", normals)):
        attribute = data.attributes.new(name, "FLOAT_VECTOR", "POINT")
        attribute.data.foreach_set("vector", np.ascontiguousarray(values, np.float32).ravel())
    obj = bpy.data.objects.new("model", data)
    bpy.context.collection.objects.link(obj)
    bpy.context.view_layer.objects.active = obj
    obj.select_set(True)
    return obj


def picture(name: str, width: int, height: int, pixels: np.ndarray | None = None):
    """A float image that nobody converts the colours of; `pixels` (H, W, 3), first row on top."""
    image = bpy.data.images.new(name, width, height, alpha=True, float_buffer=True)
    image.colorspace_settings.name = "Non-Color"
    if pixels is not None:
        full = np.ones((height, width, 4), np.float32)
        full[..., :3] = pixels[::-1]
        image.pixels.foreach_set(full.ravel())
        image.update()
    return image


def bake(obj, material, width: int, height: int, seed: int, samples: int) -> np.ndarray:
    """What the material emits, on the UVs: (H, W, 3), linear, first row on top."""
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    scene.cycles.device = "CPU"
    scene.cycles.samples = samples
    scene.cycles.use_denoising = False  # Debian's build has none, and bakes black when asked
    scene.cycles.use_adaptive_sampling = False
    scene.cycles.seed = seed % 2**31
    image = picture("bake", width, height)
    nodes = material.block.node_tree.nodes
    target = nodes.new("ShaderNodeTexImage")
    target.image, nodes.active = image, target
    obj.data.materials.clear()
    obj.data.materials.append(material.block)
    bpy.ops.object.bake(type="EMIT", margin=0, use_clear=True)
    pixels = np.empty(width * height * 4, np.float32)
    image.pixels.foreach_get(pixels)
    bpy.data.images.remove(image)
    return pixels.reshape(height, width, 4)[::-1, :, :3]


def main(job: str, result: str, look: str, kind: str, seed: int) -> None:
    if bpy.app.version < OLDEST:
        raise SystemExit(f"Blender {bpy.app.version_string} is too old: 3.4 or later is needed")
    bpy.ops.wm.read_factory_settings(use_empty=True)
    # not before: its modules import bpy's own
    from toolkit.materials import Material
    from wear import LOOKS, Surface

    given = np.load(job)
    vertices, faces, texture = given["vertices"], given["faces"], given["texture"] / 255.0
    height, width = texture.shape[:2]
    rng = np.random.default_rng(seed)
    size = spot_size(vertices, faces)
    spots = spots_of(vertices, faces, size, rng)
    obj = build(vertices, given["normals"], *unrolled(faces, given["uvs"]))

    covered = bake(obj, Material("ffffff"), width, height, seed, 1)[..., 0] > 0.5
    if not covered.any():  # its UVs are no surface
        np.savez(result, texture=given["texture"], covered=covered)
        return
    m = Material()
    node = m._node("ShaderNodeTexImage", interpolation="Closest")
    node.image = picture("texture", width, height, linear(texture))
    surface = Surface(
        m=m,
        colour=node.outputs["Color"],
        kind=kind,
        size=size,
        spots=spots,
        bottom=bottom_of(vertices, faces),
        light=float(texture[covered].mean()),
        rng=rng,
    )
    m.colour(LOOKS[look](surface))
    baked = to_srgb(bake(obj, m, width, height, seed, SAMPLES))
    np.savez(result, texture=(baked * 255 + 0.5).astype(np.uint8), covered=covered)
    print(f"baked {width}x{height} with Blender {bpy.app.version_string}")


if __name__ == "__main__":
    arguments = sys.argv[sys.argv.index("--") + 1 :]
    main(*arguments[:4], int(arguments[4]))
