"""How still homes lie in MuJoCo: the largest movement of a loose thing, and of a joint.

    python benchmarks/mjcf_still.py [DATASET] [--homes 20] [--seconds 5]

Without a data set it builds one of as many homes, without pictures. Prints a line a home and the
worst of all.
"""

from __future__ import annotations

import argparse
import time
from pathlib import Path
from tempfile import TemporaryDirectory

import mujoco
import numpy as np
import sdgen
from sdgen.export import export

#: Movement is looked at so often, steps.
EVERY = 25


def main() -> None:
    """Measure and print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("dataset", nargs="?", type=Path)
    parser.add_argument("--homes", type=int, default=20)
    parser.add_argument("--seconds", type=float, default=5.0)
    args = parser.parse_args()
    with TemporaryDirectory() as name:
        folder = Path(name)
        library = sdgen.load_library()
        path = args.dataset or folder / "homes"
        if args.dataset is None:
            options = sdgen.BuildOptions(n=args.homes, seed=4060, views=0, sensors=())
            sdgen.build(options, path, sdgen.load_catalog(), library, workers=2)
        data = sdgen.Dataset(path)
        ids = [item.id for item in data][: args.homes]
        begin = time.perf_counter()
        export(data, "mjcf", folder / "mjcf", library=library)
        print(f"export: {(time.perf_counter() - begin) / len(data.entries):.2f} s a scene")
        worst = [measure(folder / "mjcf" / f"{one}.xml", one, args.seconds) for one in ids]
    print(
        f"{len(worst)} homes, {args.seconds:g} s, MuJoCo {mujoco.__version__}: "
        f"largest movement {max(moved for moved, _ in worst):.1f} mm, "
        f"largest change of a joint {max(turned for _, turned in worst):.4f} (rad or m)"
    )


def measure(path: Path, name: str, seconds: float) -> tuple[float, float]:
    """Largest movement of a loose body (mm) and change of a joint (rad, m) on the way."""
    model = mujoco.MjModel.from_xml_path(str(path))
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    free = model.jnt_type == mujoco.mjtJoint.mjJNT_FREE
    bodies, others = model.jnt_bodyid[free], model.jnt_qposadr[~free]
    begin, values = data.xpos[bodies].copy(), data.qpos[others].copy()
    moved, turned = np.zeros(len(bodies)), 0.0
    started = time.perf_counter()
    for step in range(round(seconds / model.opt.timestep)):
        mujoco.mj_step(model, data)
        if step % EVERY == 0:
            moved = np.maximum(moved, np.linalg.norm(data.xpos[bodies] - begin, axis=1))
            turned = max(turned, float(np.abs(data.qpos[others] - values).max(initial=0.0)))
    took = time.perf_counter() - started
    most = int(np.argmax(moved))
    warned = sum(int(warning.number) for warning in data.warning)
    print(
        f"{name}: {len(bodies)} loose things, most {1000 * moved[most]:.1f} mm "
        f"({model.body(bodies[most]).name}), joints {turned:.4f}, {warned} warnings, "
        f"{seconds / took:.2f} x real time",
        flush=True,
    )
    return 1000 * float(moved[most]), turned


if __name__ == "__main__":
    main()
