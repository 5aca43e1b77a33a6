"""What runs on the renderer for each corner and each pixel."""

GEOMETRY_VERTEX = """
#version 330
in vec3 at; in vec3 normal; in vec2 uv; in vec4 colour; in vec2 tag;
uniform mat4 clip_from_world;
out vec3 facing; out vec2 spot; flat out vec3 tint; flat out float glow; flat out float layer;
flat out vec4 id;
void main() {
    gl_Position = clip_from_world * vec4(at, 1.0);
    facing = normal; spot = uv; layer = tag.x;
    tint = colour.rgb * 2.0; glow = colour.a;
    // 24 bits as three bytes: they come out of the picture as they went in.
    float k = tag.y;
    id = vec4(mod(k, 256.0), mod(floor(k / 256.0), 256.0), floor(k / 65536.0), 255.0) / 255.0;
}
"""

GEOMETRY_PIXEL = """
#version 330
uniform sampler2DArray textures;
in vec3 facing; in vec2 spot; flat in vec3 tint; flat in float glow; flat in float layer;
flat in vec4 id;
layout(location = 0) out vec4 albedo;
layout(location = 1) out vec4 whose;
layout(location = 2) out vec4 normal;
layout(location = 3) out float depth;
void main() {
    albedo = vec4(min(texture(textures, vec3(spot, layer)).rgb * tint, 1.0), glow);
    whose = id;
    normal = vec4(normalize(facing), 1.0);
    depth = 1.0 / gl_FragCoord.w;
}
"""

#: One triangle over the whole picture.
FULL_VERTEX = """
#version 330
in vec2 at;
out vec2 uv;
void main() { uv = at * 0.5 + 0.5; gl_Position = vec4(at, 0.0, 1.0); }
"""
