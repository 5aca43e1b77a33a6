"""The real scans that some machines have beside the checkout, and what a reader calls each."""

from __future__ import annotations

import csv
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

import pytest

#: Not part of the project: see its own README for where they come from.
SCANS = Path(__file__).resolve().parents[3] / "shared" / "scans"

#: Our table for each folder of the scans.
SOURCE: Mapping[str, str] = {
    "ycb": "ycb",
    "ycb_png": "ycb",
    "replica_cad": "replicacad",
    "google_scanned_objects": "gso",
    "gso_aloha_sim": "gso",
    "mujoco_scanned_objects": "gso",
    "aws-robomaker-small-house-world": "folder",
    "gazebo_models": "folder",
    "polyhaven_glTF": "folder",
    "bigym_props": "folder",
}

#: By the class that the scans' index suggests, what a reader of it would accept from us.
#: None: no category of ours, so that saying none is right, too.
ACCEPTED: Mapping[str, tuple[str | None, ...]] = {
    "armchair": ("armchair",),
    "apple": ("apple",),
    "bag": ("handbag", "backpack"),
    "ball": ("toy_ball",),
    "banana": ("banana",),
    "beanbag": (None,),
    "beer_bottle": ("beer_bottle",),
    "bleach": ("bleach_bottle",),
    "book": ("book",),
    "bowl": ("bowl",),
    "cereal_box": ("cereal_box",),
    "chair": ("chair",),
    "clothes_on_hanger": (None,),
    "coffee_table": ("coffee_table",),
    "condiment_bottle": ("ketchup_bottle",),
    "cup": ("mug", "drinking_glass"),
    "cushion": ("cushion",),
    "detergent": ("laundry_detergent", "dish_soap"),
    "dice": ("dice",),
    "dining_table": ("dining_table", "kitchen_table"),
    "door": ("door", "front_door"),
    "door_mat": ("doormat",),
    "dumbbell": ("dumbbell", None),  # a barbell, 1.4 m long
    "food_box": ("cereal_box",),
    "fridge": ("fridge",),
    "fridge_articulated": ("fridge",),
    "glass_cleaner_spray": ("spray_cleaner",),
    "hammer": ("hammer",),
    "ketchup_bottle": ("ketchup_bottle",),
    "kitchen_counter": ("kitchen_counter",),
    "kitchen_table": ("kitchen_table",),
    "knife": ("knife",),
    "knife_block": ("knife_block", "knife_stand"),
    "lamp": ("table_lamp", "desk_lamp"),
    "lego_brick": ("toy_brick",),
    "lidded_canister": (None,),
    "marble": ("marbles",),
    "medicine_bottle": ("medicine_bottle", "vitamin_jar"),
    "monitor": ("monitor",),
    "mug": ("mug",),
    "mustard_bottle": ("ketchup_bottle",),
    "nightstand": ("nightstand",),
    "pan": ("frying_pan", "pot"),
    "picture": ("picture_frame",),
    "plant": ("plant_pot",),
    "plate": ("plate",),
    "rack": ("shoe_rack",),
    "remote_control": ("remote_control",),
    "round_box": ("storage_bin",),
    "rug": ("rug",),
    "saucepan": ("pot",),
    "scissors": ("scissors",),
    "screwdriver": ("screwdriver",),
    "shelf": ("bookshelf",),
    "shoe": ("shoe",),
    "shoe_pair": ("shoe",),
    "side_table": ("side_table",),
    "snack_bag": ("chips_bag",),
    "soap_or_oil_bottle": (None, "olive_oil_bottle", "soap_dispenser", "dish_soap"),
    "soda_can": ("soda_can",),
    "sofa": ("sofa",),
    "sponge_dish": (None,),
    "stand_mixer": (None,),
    "stool": ("stool",),
    "stove_top": (None,),  # a hob without its oven
    "table": ("dining_table", "kitchen_table", "desk"),
    "tablet": (None,),
    "toy_block": ("toy_brick",),
    "trash_bin": ("trash_bin",),
    "tumbler": ("drinking_glass",),
    "tv": ("tv",),
    "tv_stand": ("tv_stand",),
    "umbrella": ("umbrella",),
    "wooden_crate": ("storage_bin",),
}


@dataclass(frozen=True)
class Scan:
    """One model of the index: extents in metres, Z up."""

    source: str
    name: str
    suggested: str
    extents_m: tuple[float, float, float]


def scans() -> list[Scan]:
    """All models of the index; skips the test that asks where there are none."""
    index = SCANS / "INDEX.csv"
    if not index.is_file():
        pytest.skip("the real scans (shared/scans beside the checkout) are not here")
    with index.open(encoding="utf-8", newline="") as file:
        return [_scan(row) for row in csv.DictReader(file)]


def _scan(row: Mapping[str, str]) -> Scan:
    deep, wide, high = map(float, row["extents_m"].split())
    if row["up_axis"] == "Y":
        wide, high = high, wide
    return Scan(SOURCE[row["source"]], row["model"], row["suggested_class"], (deep, wide, high))
