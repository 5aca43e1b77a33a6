"""What runs on the renderer for each corner and each pixel."""

GEOMETRY_VERTEX = """
#version 330
in vec3 at; in vec3 normal; in vec2 uv; in vec4 colour; in float number;
uniform mat4 clip_from_world;
uniform vec4 keep;                     // of points before a mirror this is positive
out vec3 facing; out vec2 spot; flat out vec4 tint; flat out vec4 id;
void main() {
    gl_Position = clip_from_world * vec4(at, 1.0);
    gl_ClipDistance[0] = dot(vec4(at, 1.0), keep);
    facing = normal; spot = uv;
    tint = vec4(colour.rgb * 2.0, colour.a);
    // 24 bits as three bytes: they come out of the picture as they went in.
    float k = number;
    id = vec4(mod(k, 256.0), mod(floor(k / 256.0), 256.0), floor(k / 65536.0), 255.0) / 255.0;
}
"""

#: Colours of what is opaque with whether it glows, and its normals. They are drawn finer than all
#: else and averaged: what is thinner than a pixel is a thin line then, and not dots and dashes.
ALBEDO_PIXEL = """
#version 330
uniform sampler2D worn;
uniform float finer;                   // by how many halvings the samples lie denser than pixels
in vec3 facing; in vec2 spot; flat in vec4 tint; flat in vec4 id;
layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 normal;
void main() {
    // A window's pane has a colour factor of 0: of it and of nothing no share is taken.
    float there = step(0.002, tint.r + tint.g + tint.b);
    vec3 colour = texture(worn, spot, -finer).rgb * tint.rgb;
    // What glows keeps its drawing, and does not turn white all over.
    if (tint.a > 0.5) colour /= max(1.0, max(colour.r, max(colour.g, colour.b)));
    albedo = vec4(min(colour, 1.0), tint.a);
    normal = vec4((normalize(facing) * 0.5 + 0.5) * there, there);
}
"""

#: All but colours of what is opaque.
SOLID_PIXEL = """
#version 330
in vec3 facing; in vec2 spot; flat in vec4 tint; flat in vec4 id;
layout(location = 0) out vec4 whose;
layout(location = 1) out vec4 normal;
layout(location = 2) out float depth;
void main() {
    whose = id;
    normal = vec4(normalize(facing), 1.0);
    depth = 1.0 / gl_FragCoord.w;
}
"""

#: All of what is seen through.
VEIL_PIXEL = """
#version 330
uniform sampler2D worn;
in vec3 facing; in vec2 spot; flat in vec4 tint; flat in vec4 id;
layout(location = 0) out vec4 whose;
layout(location = 1) out vec4 normal;
layout(location = 2) out float depth;
layout(location = 3) out vec4 colour;
void main() {
    whose = id;
    normal = vec4(normalize(facing), 1.0);
    depth = 1.0 / gl_FragCoord.w;
    colour = vec4(min(texture(worn, spot).rgb * tint.rgb, 1.0), tint.a);
}
"""

#: One triangle over the whole picture.
FULL_VERTEX = """
#version 330
in vec2 at;
out vec2 uv;
void main() { uv = at * 0.5 + 0.5; gl_Position = vec4(at, 0.0, 1.0); }
"""
