"""Materials: every one is an Emission of its colour, so an EMIT bake gives the colour exactly.

Texture coordinates are the maker's own coordinates (the shift to the contract's origin happens
at export; a mesh's `rest` keeps them while it is moved), so `distance((x, y, z))` and `axis(2)`
may be used freely.
"""

from __future__ import annotations

import colorsys

import bpy
import numpy as np

Colour = "str | tuple[float, float, float]"


def srgb(colour) -> np.ndarray:
    """'#rrggbb' or a 0..1 triple as an sRGB array."""
    if isinstance(colour, str):
        text = colour.lstrip("#")
        colour = [int(text[i : i + 2], 16) / 255 for i in (0, 2, 4)]
    return np.array(colour[:3], float)


def linear(colour) -> tuple[float, ...]:
    c = srgb(colour)
    return (*np.where(c <= 0.04045, c / 12.92, ((c + 0.055) / 1.055) ** 2.4), 1.0)


def hsv(h: float, s: float, v: float) -> tuple[float, float, float]:
    return colorsys.hsv_to_rgb(h % 1, s, v)


def shade(colour, factor: float) -> tuple[float, float, float]:
    """Darker (< 1) or lighter (> 1) by a factor."""
    return tuple((srgb(colour) * factor).clip(0, 1))


def blend(a, b, t: float) -> tuple[float, float, float]:
    """Between two colours."""
    return tuple(srgb(a) * (1 - t) + srgb(b) * t)


class Material:
    """A node graph under construction; the methods return sockets to plug into one another.

    occlusion: how strongly baked ambient occlusion darkens it (0: glowing things).
    """

    def __init__(self, colour=None, occlusion: float = 1.0, name: str = "material"):
        self.block = bpy.data.materials.new(name)
        self.block.use_nodes = True
        self.tree = self.block.node_tree
        self.tree.nodes.clear()
        self.block["occlusion"] = float(occlusion)
        output = self._node("ShaderNodeOutputMaterial")
        self._emission = self._node("ShaderNodeEmission")
        self.tree.links.new(self._emission.outputs[0], output.inputs[0])
        if colour is not None:
            self.colour(colour)

    def _node(self, kind: str, **settings):
        node = self.tree.nodes.new(kind)
        for key, value in settings.items():
            setattr(node, key, value)
        return node

    def _put(self, socket, value) -> None:
        if value is None:
            return
        if hasattr(value, "is_linked"):
            self.tree.links.new(value, socket)
        elif socket.type == "RGBA":
            socket.default_value = linear(value)
        elif socket.type == "VECTOR":
            socket.default_value = tuple(value)
        else:
            socket.default_value = value

    def colour(self, value) -> Material:
        """Set the final colour: a socket or a plain colour."""
        self._put(self._emission.inputs["Color"], value)
        return self

    # ---- coordinates
    def _rest(self):
        """Where the point was made (a shard that fell keeps the pattern of the whole)."""
        return self._node("ShaderNodeAttribute", attribute_name="rest").outputs["Vector"]

    def coordinates(self, offset=(0, 0, 0), stretch=(1, 1, 1)):
        mapping = self._node("ShaderNodeMapping")
        self.tree.links.new(self._rest(), mapping.inputs[0])
        mapping.inputs["Location"].default_value = offset
        mapping.inputs["Scale"].default_value = stretch
        return mapping.outputs[0]

    def axis(self, i: int):
        """Maker's coordinate x, y or z (0, 1, 2), in metres."""
        return self._component(self._rest(), i)

    def normal(self, i: int):
        """Component of the surface normal."""
        return self._component(self._node("ShaderNodeNewGeometry").outputs["Normal"], i)

    def _component(self, vector, i: int):
        node = self._node("ShaderNodeSeparateXYZ")
        self.tree.links.new(vector, node.inputs[0])
        return node.outputs[i]

    def distance(self, point, stretch=(1, 1, 1)):
        """Distance from a point of the model, in metres."""
        source = self._rest()
        for operation, value in (("SUBTRACT", point), ("MULTIPLY", stretch)):
            node = self._node("ShaderNodeVectorMath", operation=operation)
            self.tree.links.new(source, node.inputs[0])
            node.inputs[1].default_value = value
            source = node.outputs[0]
        node = self._node("ShaderNodeVectorMath", operation="LENGTH")
        self.tree.links.new(source, node.inputs[0])
        return node.outputs["Value"]

    def drawn(self, i: int):
        """Component u or v (0, 1) of the label UV: of a mesh that is given one in metres, as it
        would lie unrolled."""
        node = self._node("ShaderNodeUVMap", uv_map="label")
        return self._component(node.outputs[0], i)

    # ---- patterns
    def noise(
        self, scale, detail=3.0, roughness=0.55, distortion=0.0, offset=(0, 0, 0), stretch=(1, 1, 1)
    ):
        node = self._node("ShaderNodeTexNoise")
        self.tree.links.new(self.coordinates(offset, stretch), node.inputs["Vector"])
        values = {
            "Scale": scale,
            "Detail": detail,
            "Roughness": roughness,
            "Distortion": distortion,
        }
        for key, value in values.items():
            node.inputs[key].default_value = value
        return node.outputs["Fac"]

    def voronoi(
        self,
        scale,
        offset=(0, 0, 0),
        stretch=(1, 1, 1),
        output="Distance",
        feature="F1",
        randomness=1.0,
    ):
        node = self._node("ShaderNodeTexVoronoi", feature=feature)
        self.tree.links.new(self.coordinates(offset, stretch), node.inputs["Vector"])
        node.inputs["Scale"].default_value = scale
        node.inputs["Randomness"].default_value = randomness
        return node.outputs[output]

    def image(self, picture, base=None):
        """A Pillow image on the label UV; a transparent one is laid over `base`."""
        mapping = self._node("ShaderNodeUVMap", uv_map="label")
        node = self._node("ShaderNodeTexImage", image=_to_blender(picture), extension="EXTEND")
        self.tree.links.new(mapping.outputs[0], node.inputs[0])
        if base is None:
            return node.outputs["Color"]
        return self.mix(node.outputs["Alpha"], base, node.outputs["Color"])

    # ---- combining
    def ramp(self, factor, stops, interpolation: str = "LINEAR"):
        """stops: (position 0..1, colour or grey number), ascending."""
        node = self._node("ShaderNodeValToRGB")
        ramp = node.color_ramp
        ramp.interpolation = interpolation

        def rgba(c):
            return (c, c, c, 1) if isinstance(c, (int, float)) else linear(c)

        for element, (position, colour) in (
            (ramp.elements[0], stops[0]),
            (ramp.elements[1], stops[-1]),
        ):
            element.position, element.color = position, rgba(colour)
        for position, colour in stops[1:-1]:
            ramp.elements.new(position).color = rgba(colour)
        self._put(node.inputs[0], factor)
        return node.outputs[0]

    def mix(self, factor, a, b, mode: str = "MIX"):
        node = self._node("ShaderNodeMixRGB", blend_type=mode)
        for socket, value in zip(node.inputs, (factor, a, b), strict=False):
            self._put(socket, value)
        return node.outputs[0]

    def math(self, operation: str, a, b=None, clamp: bool = False):
        node = self._node("ShaderNodeMath", operation=operation, use_clamp=clamp)
        self._put(node.inputs[0], a)
        self._put(node.inputs[1], b)
        return node.outputs[0]

    def remap(self, value, low, high, out_low=0.0, out_high=1.0):
        """Clamped linear map of [low, high] to [out_low, out_high]."""
        node = self._node("ShaderNodeMapRange")
        self._put(node.inputs[0], value)
        for i, x in enumerate((low, high, out_low, out_high)):
            node.inputs[i + 1].default_value = x
        return node.outputs[0]

    def mottle(self, colour, amount=0.06, scale=60.0, offset=(0, 0, 0), detail=4.0):
        """A plain colour with soft, irregular variation."""
        c = srgb(colour)
        factor = self.remap(self.noise(scale, detail, offset=offset), 0.3, 0.7)
        return self.mix(
            factor, shade(c, 1 - amount), tuple((c * (1 + amount) + amount * 0.15).clip(0, 1))
        )

    def edge_highlight(self, colour, radius: float, strength: float = 0.35, tint="ffffff"):
        """Lighten convex edges (wear, moulded plastic)."""
        rounded, geometry = (
            self._node("ShaderNodeBevel", samples=4),
            self._node("ShaderNodeNewGeometry"),
        )
        rounded.inputs["Radius"].default_value = radius
        dot = self._node("ShaderNodeVectorMath", operation="DOT_PRODUCT")
        self.tree.links.new(rounded.outputs[0], dot.inputs[0])
        self.tree.links.new(geometry.outputs["Normal"], dot.inputs[1])
        away = self.math("SUBTRACT", 1.0, dot.outputs["Value"], clamp=True)
        return self.mix(self.math("MULTIPLY", away, strength * 4, clamp=True), colour, tint)


def _to_blender(picture):
    picture = picture.convert("RGBA")
    pixels = np.asarray(picture, np.float32) / 255.0
    image = bpy.data.images.new("label", picture.width, picture.height, alpha=True)
    image.alpha_mode = "STRAIGHT"
    image.pixels.foreach_set(np.ascontiguousarray(pixels[::-1]).ravel())
    image.update()
    image.pack()
    return image


# ---- ready-made materials
def plain(colour, amount=0.05, scale=60.0, offset=(0, 0, 0), occlusion=1.0) -> Material:
    """Painted, ceramic or plastic: one colour, softly mottled (amount 0: exactly one colour)."""
    m = Material(occlusion=occlusion)
    return m.colour(m.mottle(colour, amount, scale, offset) if amount else colour)


def glowing(colour) -> Material:
    """For flames, lamps and displays; give the part rgba above 1 to make it shine."""
    return Material(colour, occlusion=0.0)


def label(picture, base=None, occlusion=1.0) -> Material:
    """A Pillow image on the label UV (over `base`, a colour, where it is transparent)."""
    m = Material(occlusion=occlusion)
    return m.colour(m.image(picture, base))


def metal(
    colour="b8bcc0", dark="6f757b", brush=(1, 1, 12), scale=90.0, offset=(0, 0, 0), occlusion=0.8
) -> Material:
    """Reflections painted in: a ramp over the normal (as a matcap) and brushed streaks."""
    m = Material(occlusion=occlusion)
    t = m.math("ADD", m.math("MULTIPLY", m.normal(2), 0.35), m.math("MULTIPLY", m.normal(0), 0.25))
    stops = [
        (0, dark),
        (0.35, colour),
        (0.5, shade(colour, 1.18)),
        (0.62, colour),
        (0.8, shade(colour, 1.12)),
        (1, colour),
    ]
    base = m.ramp(m.remap(t, -0.6, 0.6), stops)
    streaks = m.remap(m.noise(scale, 2, offset=offset, stretch=brush), 0.3, 0.7, 0, 0.22)
    return m.colour(m.mix(streaks, base, dark))


def wood(
    light="b98552", dark="7d5230", grain_axis=0, scale=9.0, offset=(0, 0, 0), contrast=1.0
) -> Material:
    """Wood with its grain along an axis."""
    m = Material()
    stretch = [7.0, 7.0, 7.0]
    stretch[grain_axis] = 0.6
    rings = m.noise(scale, 4, distortion=1.2, offset=offset, stretch=stretch)
    fine = m.noise(
        scale * 8,
        3,
        offset=offset,
        stretch=[s * 1.5 if i != grain_axis else 0.4 for i, s in enumerate(stretch)],
    )
    mid = blend(light, dark, 0.45)
    base = m.ramp(
        rings, [(0.28, blend(light, dark, contrast)), (0.45, mid), (0.6, light), (0.75, mid)]
    )
    return m.colour(m.mix(m.remap(fine, 0.4, 0.65, 0, 0.35), base, dark))
