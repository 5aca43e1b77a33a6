"""What VirtualHome's classes are called here. Only what differs: class ``bed`` is our ``bed``."""

from __future__ import annotations

from collections.abc import Mapping

#: Class name -> our category. Classes that are a part of something (a faucet, a tray, a hanger), or
#: that we have nothing for (a radio, a guitar), are left to be told.
CATEGORIES: Mapping[str, str] = {
    # furniture
    "ceilinglamp": "ceiling_lamp",
    "closet": "wardrobe",
    "clock": "wall_clock",
    "coffeetable": "coffee_table",
    "curtains": "curtain",
    "bathroomcabinet": "bathroom_cabinet",
    "bathroomcounter": "washbasin",
    "garbagecan": "trash_bin",
    "kitchencabinets": "wall_cabinet",
    "kitchencounter": "kitchen_counter",
    "kitchentable": "kitchen_table",
    "knifeblock": "knife_block",
    "lightswitch": "light_switch",
    "orchid": "plant_pot",
    "powersocket": "power_socket",
    "stovefan": "range_hood",
    "tablelamp": "table_lamp",
    "towelrack": "towel_rail",
    "tvstand": "tv_stand",
    "wallpictureframe": "picture_frame",
    "wallshelf": "wall_shelf",
    "washingmachine": "washing_machine",
    # things
    "bananas": "banana",
    "bellpepper": "bell_pepper",
    "bottlewater": "water_bottle",
    "box": "cardboard_box",
    "breadslice": "bread",
    "candybar": "chocolate_bar",
    "cellphone": "phone",
    "cereal": "cereal_box",
    "chips": "chips_bag",
    "clothespile": "clothes_pile",
    "coffeemaker": "coffee_maker",
    "condimentbottle": "ketchup_bottle",
    "condimentshaker": "salt_shaker",
    "cookingpot": "pot",
    "cpuscreen": "monitor",
    "cutleryfork": "fork",
    "cutleryknife": "knife",
    "dishbowl": "bowl",
    "dishwashingliquid": "dish_soap",
    "facecream": "face_cream",
    "fryingpan": "frying_pan",
    "hairproduct": "shampoo_bottle",
    "juice": "juice_carton",
    "longboard": "skateboard",
    "milk": "milk_carton",
    "mincedmeat": "raw_meat",
    "mouse": "computer_mouse",
    "painkillers": "pill_box",
    "perfume": "perfume_bottle",
    "photoframe": "photo_frame",
    "pillow": "cushion",
    "poundcake": "cake",
    "pudding": "pudding_cup",
    "remotecontrol": "remote_control",
    "salmon": "fish_fillet",
    "sportsball": "toy_ball",
    "toiletpaper": "toilet_paper",
    "toothbrush": "toothbrush_cup",
    "towelrolled": "towel",
    "washingsponge": "sponge",
    "waterglass": "drinking_glass",
    "wine": "wine_bottle",
    "wineglass": "wine_glass",
}
#: Classes of rooms -> our type of room.
ROOMS: Mapping[str, str] = {
    "livingroom": "living_room",
    "bathroom": "bathroom",
    "bedroom": "bedroom",
    "kitchen": "kitchen",
    "home_office": "office",
    "homeoffice": "office",
    "dining_room": "dining_room",
    "diningroom": "dining_room",
    "kids_bedroom": "child_room",
    "entrance_hall": "hall",
}
#: States that VirtualHome has; of ours it knows no others.
STATES = ("CLEAN", "CLOSED", "DIRTY", "OFF", "ON", "OPEN", "PLUGGED_IN", "PLUGGED_OUT")
#: Properties that VirtualHome has.
PROPERTIES = (
    *("BODY_PART", "CAN_OPEN", "CLOTHES", "CONTAINERS", "COVER_OBJECT", "CREAM", "CUTTABLE"),
    *("DRINKABLE", "EATABLE", "GRABBABLE", "HANGABLE", "HAS_PAPER", "HAS_PLUG", "HAS_SWITCH"),
    *("LIEABLE", "LOOKABLE", "MOVABLE", "PERSON", "POURABLE", "READABLE", "RECIPIENT"),
    *("SITTABLE", "SURFACES"),
)


def virtualhome_class(category: str) -> str:
    """VirtualHome's class for a category or room type of ours: its word, else ours without
    underscores, as it spells its own."""
    return _CLASSES.get(category, category.replace("_", ""))


_CLASSES = {ours: theirs for theirs, ours in reversed([*CATEGORIES.items(), *ROOMS.items()])}
