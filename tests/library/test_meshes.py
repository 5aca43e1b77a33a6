"""Collision pieces and what is drawn."""

import json

import numpy as np
from sdgen.library import Library
from sdgen.library.meshes import HULL_SLACK_M

from tests.fakes import write_library


def test_pieces_end_where_the_parts_that_move_with_theirs_end(tmp_path):
    """A box around a tilted back sticks out of the model; a piece for another part's shape not."""
    folder = write_library(tmp_path / "assets")
    library = Library([folder])
    asset = library.assets["cabinet_01"]
    path = folder / asset.hulls
    data = json.loads(path.read_text())
    pieces = {piece["part"]: piece["vertices_m"] for piece in data["pieces"]}
    for corner in pieces["back"]:
        corner[0] -= 0.05 * (corner[0] < -0.28)  # 5 cm beyond the back of the cabinet
        corner[2] += 0.05 * (corner[2] > 0.7)  # and above it, where nothing is drawn
    for corner in pieces["floor"]:
        corner[2] += 0.5 * (corner[2] > 0.02)  # beyond its own part, within the back's
    path.write_text(json.dumps(data))
    hulls = {hull.part: hull.vertices_m for hull in Library([folder]).hulls("cabinet_01")}
    assert np.allclose(hulls["back"].min(axis=0)[0], -0.3 - HULL_SLACK_M)
    assert np.allclose(hulls["back"].max(axis=0)[2], 0.8 + HULL_SLACK_M)
    assert np.allclose(hulls["floor"].max(axis=0)[2], 0.54)
    assert np.allclose(hulls["door"], pieces["door"])
