"""Stable resting poses of a model, from the convex hull of its collision pieces.

Goldberg et al., "Part Pose Statistics: Estimators and Experiments" (IEEE T-RA 15(5), 1999), as
trimesh computes them.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from sdgen.geometry import Array, vec3
from sdgen.library.records import RestingPose

#: Poses less likely than this are left out: in every twelfth shipped model they have 7 % of the
#: chance together. No more than a box has are kept; long round things have up to 16 as likely.
_LEAST_SHARE, _MOST = 0.04, 6
#: Faces of the hull closer than this count as one foot: steps of a rounded edge. Its size matters
#: little: from 4 to 12 degrees about 3 of 149 shipped models get more or fewer poses.
_SAME_RAD = np.radians(8)


def resting_poses(pieces: Sequence[Array], centre_of_mass_m: Array) -> tuple[RestingPose, ...]:
    """Ways the model can lie on a level floor, likeliest first.

    ``pieces`` are convex point sets (N, 3) in the object's frame. ``share`` is the chance of
    coming to rest so when dropped at random.
    """
    import trimesh

    hull = trimesh.convex.convex_hull(np.concatenate(list(pieces)))
    transforms, shares = trimesh.poses.compute_stable_poses(
        hull, center_mass=centre_of_mass_m, sigma=0.0, n_samples=1, threshold=0.0
    )
    merged: list[tuple[Array, float]] = []
    for transform, share in zip(transforms, shares, strict=True):
        up = np.asarray(transform[2, :3], dtype=np.float64)  # what ends up pointing upwards
        for k, (other, sum_) in enumerate(merged):
            if np.arccos(np.clip(up @ other, -1, 1)) < _SAME_RAD:
                merged[k] = (other, sum_ + float(share))
                break
        else:
            merged.append((up, float(share)))
    ranked = sorted(merged, key=lambda m: (-round(m[1], 3), *np.round(m[0], 3).tolist()))
    # Round things have countless ways, none of them likely: the likeliest stands for them.
    likely = [pose for pose in ranked[:_MOST] if pose[1] >= _LEAST_SHARE] or ranked[:1]
    return tuple(
        RestingPose(up=vec3(np.round(up, 3) + 0.0), share=max(round(share, 3), 0.001))
        for up, share in likely
    )
