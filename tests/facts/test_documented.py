"""The tables of thresholds in the documents are those of the code."""

import inspect
import math
import re
import sys

import pytest
from sdgen.catalog.terms import above, count, distance, edge, height, overhang
from sdgen.facts import thresholds as t
from sdgen.facts.brinks import STEP_M
from sdgen.resources import data_path
from sdgen.vocabulary import (
    CHILD_REACH_M,
    HEADING_MARGIN_DEG,
    RELATIONS,
    TAGS,
    ZONE_SHARE,
    ZONE_SHARE_MARGIN,
)

OUTPUT = data_path("hazard_catalog").parent / "output" / "README.md"
PAGES = (data_path("hazard_catalog", "README.md"), OUTPUT)
RELATIONS_PAGE = OUTPUT.parent.parent / "docs" / "relations.md"
DEGREES = t.Threshold(*(math.degrees(value) for value in t.FACING_RAD))

#: Relation or term, what is measured, which side of the limit holds, the threshold.
ROWS = (
    ("ON", "gap between its lowest point and the surface, m", "at most", t.ON_GAP_M),
    ("ON", "share of its footprint over the surface", "more than", t.ON_SHARE),
    ("ON", "m below the highest surface that carries it", "at most", t.ON_LEVEL_M),
    ("ON, UNDER", "m from the surface's lowest corner to its highest", "at most", t.TILTED_M),
    ("INSIDE", "how deep its centre lies in the hollow's box, m", "at least", t.INSIDE_M),
    ("CLOSE", "gap between the boxes, in one room, m", "less than", t.CLOSE_M),
    ("FACING", "angle between its front and the other's centre, degrees", "less than", DEGREES),
    ("FACING", "gap between the boxes, where the other is sat at, m", "less than", t.SAT_AT_M),
    ("UNDER", "share of its footprint below the other's", "more than", t.UNDER_SHARE),
    ("UNDER", "m from its top to the other's highest surface", "at least", t.UNDER_M),
    ("BLOCKS", "share of its footprint in a doorway's zones", "at least", t.ZONE_SHARE),
    ("BLOCKS", "its own height, m", "more than", t.BLOCKING_HEIGHT_M),
    ("NEAR_HEAT", "gap from its footprint to the heat zone, m", "less than", t.NEAR_HEAT_M),
    ("NEAR_WATER", "gap from its footprint to the water zone, m", "less than", t.NEAR_WATER_M),
    ("zones", "overlap of its heights with the zone's, m", "at least", t.ZONE_LEVEL_M),
    ("reach", "gap from above to what is climbed on, m", "at most", t.CLIMB_NEAR_M),
    ("overhang, edge", "m from its lowest point down to what catches it", "at most", t.CAUGHT_M),
    ("overhang, edge", "width of a gap that is no edge, m", "at most", t.CLOSED_GAP_M),
    ("room", "m by which the next room's outline is farther", "at least", t.ROOM_M),
    ("room", "m from the nearest outline, or it is outdoors", "at most", t.OUTDOORS_M),
)
#: Terms and tags with a limit of their own or of the hazard's.
SENTENCES = (
    f"`height` is undecided within {height.MARGIN_M:g} m, `distance` within "
    f"{distance.MARGIN_M:g} m, `zone` (at least {ZONE_SHARE:g} of the footprint) within "
    f"{ZONE_SHARE_MARGIN:g} of it, `overhang` within {overhang.MARGIN_M:g} m, `edge` within "
    f"{edge.MARGIN_M:g} m, `above` within {above.MARGIN_M:g} m, the `within_m` of `count` within "
    f"{count.MARGIN_M:g} m, `facing` and `facing_away` within {HEADING_MARGIN_DEG:g} degrees",
    f"`IN_REACH_OF_CHILD`: loose, at most {CHILD_REACH_M:g} m above where a child gets to stand "
    "and not `INSIDE` something that",
    f"`NEAR_EDGE`: its centre less than {t.NEAR_EDGE_M:g} m from the edge",
    f"`IN_DOORWAY`, `IN_WALKWAY`: at least {ZONE_SHARE:g} of its footprint",
)


def line(name, measured, side, limit):
    """A row of the table."""
    return f"| {name} | {measured} | {side} {limit.limit:g} | {limit.below:g} to {limit.above:g} |"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.parent.name)
def test_the_table_has_every_threshold(page):
    text = page.read_text(encoding="utf-8")
    assert [row for row in ROWS if line(*row) not in text.splitlines()] == []
    table = [row for row in text.splitlines() if row.count("|") == 5 and " to " in row[-25:]]
    assert len(table) == len(ROWS), "a row that no threshold has"
    flat = " ".join(text.split())
    assert [words for words in SENTENCES if words not in flat] == []


def test_the_page_of_relations_has_every_threshold_with_its_source():
    text = RELATIONS_PAGE.read_text(encoding="utf-8")
    table = [row for row in text.splitlines() if row.count("|") == 6 and " to " in row]
    assert len(table) == len(ROWS), "a row that no threshold has"
    for row in ROWS:
        (found,) = (told for told in table if told.startswith(line(*row)))
        assert len(found.removeprefix(line(*row)).strip(" |")) > 10, "a source"
    flat = " ".join(text.split())
    assert all(f"| `{name}` |" in flat for name in RELATIONS)
    assert f"`IN_REACH_OF_CHILD` | loose, at most {CHILD_REACH_M:g} m up" in flat
    assert f"`NEAR_EDGE` | its centre is less than {t.NEAR_EDGE_M:g} m" in flat
    assert f"`IN_DOORWAY`, `IN_WALKWAY` | at least {ZONE_SHARE:g} of its footprint" in flat
    assert f"less than {t.BEARING_LEAST_M:g} m away" in flat
    assert f"more than {t.CAUGHT_M.limit:g} m above the floor" in flat
    assert f"at most {t.CAUGHT_M.limit:g} m lower" in flat
    assert f"parts of it that are narrower than {t.CLOSED_GAP_M.limit:g} m" in flat
    assert f"drawn in by {t.CLOSED_GAP_M.limit / 2:g} m" in flat
    assert f"every {1000 * STEP_M:g} mm" in flat


def test_the_page_of_relations_names_what_every_term_measures():
    """What a term puts into the evidence, as its source has it."""
    text = RELATIONS_PAGE.read_text(encoding="utf-8")
    for term in (
        "overhang",
        "edge",
        "above",
        "distance",
        "facing",
        "facing_away",
        "count",
        "holds",
    ):
        module = sys.modules[f"sdgen.catalog.terms.{term}"]
        names = re.findall(
            r'"([a-z_]+(?:_m|_id|_deg|_name))": |"(count|held)": ', inspect.getsource(module)
        )
        names += re.findall(r'_name: ClassVar\[str\] = "(\w+)"()', inspect.getsource(module))
        assert names
        for pair in names:
            assert f"`{''.join(pair)}`" in text, (term, pair)


def test_every_relation_tag_and_threshold_is_there():
    named = {name for names, *_ in ROWS for name in names.split(", ")} | {"BETWEEN"}
    assert set(RELATIONS) <= named
    assert all(any(f"`{tag}`" in words for words in SENTENCES) for tag in TAGS)
    known = {id(row[3]) for row in ROWS if row[3] is not DEGREES} | {id(t.FACING_RAD)}
    mine = {name: v for name, v in vars(t).items() if isinstance(v, t.Threshold)}
    assert [name for name, value in mine.items() if id(value) not in known] == []
