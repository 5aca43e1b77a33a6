"""Asset records, their meshes and where they come from."""

from sdgen.library.library import Library, load_library
from sdgen.library.meshes import Hull, MeshData
from sdgen.library.records import Asset, AssetInfo, Surface

__all__ = ["Asset", "AssetInfo", "Hull", "Library", "MeshData", "Surface", "load_library"]
