"""How much light each pixel gets: from the cells of its room, from the sun, less what is near."""

#: Where a pixel is, from its depth.
_PLACE = """
#version 330
uniform sampler2D normal_map, depth_map;
uniform mat4 world_from_camera; uniform vec4 lens; uniform vec3 eye;
in vec2 uv;
ivec2 here() { return ivec2(gl_FragCoord.xy); }
// lens: x and y of the ray through the picture's corner (0, 0), and how far they go across it.
vec3 place(vec2 at, float z) {
    return (world_from_camera * vec4((lens.xy + at * lens.zw) * z, z, 1.0)).xyz;
}
"""

#: Ambient occlusion on the screen (after Mittring 2007), a turn of its directions by pixel.
SHADE = (
    _PLACE
    + """
uniform mat4 clip_from_world;
uniform ivec2 size;                    // of the picture
out vec2 shade;
const float REACH = 0.32; const int RAYS = 8;
void main() {
    ivec2 own = ivec2(uv * vec2(size));
    float z = texelFetch(depth_map, own, 0).r;
    shade = vec2(1.0, z);
    if (z == 0.0) return;
    vec3 p = place((vec2(own) + 0.5) / vec2(size), z), n = texelFetch(normal_map, own, 0).xyz;
    if (dot(n, eye - p) < 0.0) n = -n;
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    float turn = float((cell.x * 5 + cell.y * 7 + cell.x * cell.y * 3) & 15) / 16.0;
    vec3 t = normalize(cross(n, abs(n.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0)));
    vec3 b = cross(n, t);
    // How clip space changes along each of the three: one product of a matrix instead of many.
    vec4 from = clip_from_world * vec4(p + n * 0.01, 1.0);
    vec4 by_t = clip_from_world * vec4(t, 0.0), by_b = clip_from_world * vec4(b, 0.0);
    vec4 by_n = clip_from_world * vec4(n, 0.0);
    float hidden = 0.0;
    for (int k = 0; k < RAYS; k++) {
        float f = (float(k) + 0.5) / float(RAYS);
        float angle = 6.2831853 * turn + float(k) * 2.3999632;
        float far = REACH * (0.15 + 0.85 * fract(float(k) * 0.618034 + turn));
        float flat_ = far * sqrt(f), up = far * sqrt(1.0 - f);
        vec4 c = from + by_t * (cos(angle) * flat_) + by_b * (sin(angle) * flat_) + by_n * up;
        ivec2 at = ivec2((c.xy / c.w * 0.5 + 0.5) * vec2(size));
        // Beyond the picture's edge what is at the edge is taken for what is there.
        float before = c.w - texelFetch(depth_map, clamp(at, ivec2(0), size - 1), 0).r;
        // The further before, the less: what stands off from a wall throws no halo on it.
        hidden += step(0.008, before) * clamp(1.35 - before / 0.3, 0.0, 1.0);
    }
    shade.x = 1.0 - 0.85 * hidden / float(RAYS);
}
"""
)

#: A mean of shade over turns of its directions, of what is as deep.
BLUR = """
#version 330
uniform sampler2D shade_map;
uniform ivec2 last;
out vec2 shade;
void main() {
    ivec2 own = ivec2(gl_FragCoord.xy);
    float z = texelFetch(shade_map, own, 0).g, sum = 0.0, weight = 1e-6;
    for (int i = -2; i < 2; i++) for (int j = -2; j < 2; j++) {
        vec2 near = texelFetch(shade_map, clamp(own + ivec2(i, j), ivec2(0), last), 0).rg;
        float alike = max(0.0, 1.0 - 20.0 * abs(near.g - z) / max(z, 0.01));
        sum += near.r * alike; weight += alike;
    }
    shade = vec2(sum / weight, z);
}
"""

#: Light from the cells of rooms, and what a camera makes of it.
_CELLS = (
    _PLACE
    + """
uniform sampler2D room_map, rooms;
uniform sampler3D sides;               // of all grids side by side, for +x, -x, +y, -y, +z, -z
uniform vec4 plan;                     // of the room map: corner, cells a metre
uniform vec3 cells;                    // of all grids and sides together
uniform float side;                    // how many cells each of the six takes
uniform vec3 exposure;
const float PI = 3.14159265;
vec3 exposed;                          // by how much the light found last is multiplied
// Light on a surface at p that faces n, from the cells of the room that p is in.
vec3 around(vec3 p, vec3 n) {
    vec3 q = p + 0.14 * n;
    float room = texture(room_map, (q.xy - plan.xy) * plan.zw).r * 255.0;
    if (room < 0.5) room = texture(room_map, (p.xy - plan.xy) * plan.zw).r * 255.0;
    int k = max(int(room + 0.5) - 1, 0);
    vec4 corner = texelFetch(rooms, ivec2(0, k), 0), count = texelFetch(rooms, ivec2(2, k), 0);
    vec3 at = (q - corner.xyz) / texelFetch(rooms, ivec2(1, k), 0).xyz;
    at = clamp(at, vec3(0.5), count.xyz - 0.5);
    at = (at + vec3(count.w, 0.0, 0.0)) / cells;
    exposed = room < 0.5 ? exposure : texelFetch(rooms, ivec2(3, k), 0).rgb;
    vec3 share = n * n, up = (vec3(0.0, 2.0, 4.0) + vec3(lessThan(n, vec3(0.0)))) * side / cells.z;
    vec3 found = share.x * texture(sides, at + vec3(0.0, 0.0, up.x)).rgb
        + share.y * texture(sides, at + vec3(0.0, 0.0, up.y)).rgb
        + share.z * texture(sides, at + vec3(0.0, 0.0, up.z)).rgb;
    return room < 0.5 ? vec3(1.0) : found;
}
// sRGB, near enough (Chapman 2012), without a power.
vec3 linear(vec3 c) { return c * (c * (c * 0.305306 + 0.682171) + 0.012523); }
vec3 shown(vec3 x) {
    vec3 a = sqrt(x), b = sqrt(a);
    return clamp(0.662003 * a + 0.684122 * b - 0.323584 * sqrt(b) - 0.022541 * x, 0.0, 1.0);
}
// Narkowicz 2015, "ACES filmic tone mapping curve".
vec3 filmic(vec3 x) {
    return shown(clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0));
}
// Much light counts for less, by its root in the end: no wall by a lamp burns out, no patch of sun.
// And little counts for more, as much as a camera that is set for indoors lifts its shadows.
vec3 toned(vec3 colour, vec3 light) {
    light *= exposed / PI;
    float bright = dot(light, vec3(0.2126, 0.7152, 0.0722)) / 0.7;
    float lift = 1.0 + 0.4 / (1.0 + 9.0 * bright * bright);
    return filmic(colour * light * lift * inversesqrt(sqrt(1.0 + bright * bright)));
}
"""
)

#: Mesa on a CPU computes both ways of every question: what need not be done is left out instead.
_SUNNY = """
uniform sampler2D sun_map;
uniform vec3 sun_right, sun_up, sun_along, sun_corner, sun, sun_light;
uniform float sun_step, sun_highest;
vec3 sunny(vec3 p, vec3 n) {
    vec3 q = p + 0.01 * n;
    vec2 at = (vec2(dot(q, sun_right), dot(q, sun_up)) - sun_corner.xy) / sun_step;
    float slant = dot(n, sun), depth = dot(q, sun_along) - 0.02, sum = 0.0;
    // How the depth of the surface itself changes from cell to cell (receiver plane depth bias,
    // Isidoro 2006): without it a surface shades itself, or light comes in at corners. Towards the
    // sun it is less than a wall is thick, or what the sun grazes is lit through that.
    vec2 rise = vec2(dot(n, sun_right), dot(n, sun_up)) / max(slant, 0.1) * sun_step;
    vec2 low = floor(at - 0.5);
    float core = 0.0;
    for (int i = -1; i < 3; i++) for (int j = -1; j < 3; j++) {
        ivec2 cell = ivec2(low) + ivec2(i, j);
        vec2 off = vec2(cell) + 0.5 - at;
        float lit = step(depth + max(dot(off, rise), -0.03), texelFetch(sun_map, cell, 0).r);
        vec2 near = max(1.0 - abs(off), 0.0), far = 2.0 - abs(off);
        sum += lit * far.x * far.y; core += lit * near.x * near.y;
    }
    // Where walls meet, cells far off see past them: no light where there is none near by.
    sum *= clamp(2.0 * core, 0.0, 1.0);
    return sun_light * max(slant, 0.0) * sum / 16.0 * step(p.z, sun_highest);
}
"""
_SUNLESS = """
vec3 sunny(vec3 p, vec3 n) { return vec3(0.0); }
"""

#: What a sample of a pixel shows: what is drawn there, by its light, and the world beyond.
_LIT = """
uniform sampler2D albedo_map, shade_map, world_map, floor_map;
uniform vec4 floor_plan;               // of the floor map: corner of its first point, size
uniform ivec2 coarse;                  // size of the shade map
uniform ivec2 apart;                   // how far apart a pixel's four samples are in the buffers
uniform bool outdoors;
float shaded(vec2 at, float z) {
    float sum = 0.0, weight = 0.0;
    ivec2 first = ivec2(at * vec2(coarse) - 0.5), last = coarse - 1;
    for (int i = 0; i < 2; i++) for (int j = 0; j < 2; j++) {
        vec2 near = texelFetch(shade_map, clamp(first + ivec2(i, j), ivec2(0), last), 0).rg;
        float alike = max(0.0, 1.0 - 20.0 * abs(near.g - z) / z) + 1e-4;
        sum += near.r * alike; weight += alike;
    }
    return sum / weight;
}
// own: colour and glow, facing: the normal by half and how much is drawn, at p.
vec3 lit(vec4 own, vec4 facing, vec3 p, float shade, vec4 world) {
    float there = max(facing.a, 0.01);
    own /= there;
    vec3 n = normalize(facing.xyz / there - 0.5 + 1e-5);
    if (dot(n, eye - p) < 0.0) n = -n;
    // On floors and rugs there is the shade of what stands there.
    vec2 spot = (p.xy - floor_plan.xy) / floor_plan.zw + 0.5 / vec2(textureSize(floor_map, 0));
    float low = step(p.z, 0.05) * clamp(2.0 * n.z - 1.0, 0.0, 1.0);
    shade *= mix(1.0, texture(floor_map, spot).r, low);
    // What shines on its face (Schlick 1994), as if all came from where it faces: paint, wood and
    // black fronts are not wholly dull.
    float edge = 1.0 - clamp(dot(n, normalize(eye - p)), 0.0, 1.0);
    // Not in gaps: their sides face each other.
    float sheen = (0.03 + 0.22 * pow(edge, 5.0)) * shade * shade;
    vec3 found = toned(mix(linear(own.rgb), vec3(1.0), sheen), around(p, n) * shade + sunny(p, n));
    // What gives light is as bright as its texture by day and by night, and less at its rim.
    vec3 given = own.rgb * (1.0 - 0.3 * edge);
    found = mix(found, max(found, given), own.a);
    if (outdoors) found = mix(found, world.rgb, world.a * (1.0 - facing.a));
    return found;
}
"""

_LIGHT = """
uniform sampler2D fine_depth_map;
uniform vec2 range;                    // nearest and farthest of the camera
out vec4 colour;                       // and whether its samples differ
float deep_at(int x, int y) {
    return texelFetch(fine_depth_map, here() + ivec2(x, y) * apart, 0).r;
}
void main() {
    float z = max(texelFetch(depth_map, here(), 0).r, 0.001);
    // Means of what there is: where one looks outdoors there is nothing.
    vec4 own = vec4(0.0), facing = vec4(0.0), least = vec4(1.0), most = vec4(0.0);
    vec4 pale = vec4(1.0), deep = vec4(0.0);
    for (int k = 0; k < 4; k++) {
        ivec2 at = here() + ivec2(k & 1, k >> 1) * apart;
        vec4 a = texelFetch(albedo_map, at, 0), b = texelFetch(normal_map, at, 0);
        own += 0.25 * a; facing += 0.25 * b;
        pale = min(pale, a); deep = max(deep, a); least = min(least, b); most = max(most, b);
    }
    // Depth as OpenGL has it is even on a plane: opposite samples make twice what is between.
    float between = range.y / (range.y - range.x) * (1.0 - range.x / z);
    vec2 pairs = vec2(deep_at(0, 0) + deep_at(0, 1), deep_at(1, 0) + deep_at(1, 1));
    vec2 bent = abs(pairs - 2.0 * between) * z / range.x;
    vec4 unlike = max(2.0 * (most - least), deep - pale);
    float edge = max(max(max(unlike.x, unlike.y), max(unlike.z, unlike.w)),
                     100.0 * max(bent.x, bent.y));
    vec3 p = place(uv, z);
    vec3 found = lit(own, facing, p, shaded(uv, z), texelFetch(world_map, here(), 0));
    colour = vec4(found, step(0.3, edge));
}
"""
LIGHT = _CELLS + _SUNNY + _LIT + _LIGHT
LIGHT_SUNLESS = _CELLS + _SUNLESS + _LIT + _LIGHT

#: The same for pixels in which there is more than one thing, and those alone: each of the four
#: samples by its own light. One light for their mean made dots and dashes of what is thin.
_EDGE = """
uniform sampler2D fine_depth_map, spots;
uniform vec2 range, samples[4];        // where in their pixel the samples lie
uniform ivec2 size;
uniform mat4 clip_from_world;
out vec4 colour;
// Shade of gaps that are too thin for the shade map: how much of what is close by is before p.
float close(vec3 p, vec3 n, float turn) {
    if (dot(n, eye - p) < 0.0) n = -n;
    vec3 t = normalize(cross(n, abs(n.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0)));
    vec3 b = cross(n, t);
    float hidden = 0.0;
    for (int k = 0; k < 4; k++) {
        float angle = 1.5707963 * (float(k) + turn), far = 0.012 + 0.012 * float(k & 1);
        vec4 c = clip_from_world
            * vec4(p + far * (n + 0.9 * (cos(angle) * t + sin(angle) * b)), 1.0);
        ivec2 at = clamp(ivec2((c.xy / c.w * 0.5 + 0.5) * vec2(size)), ivec2(0), size - 1);
        float before = c.w - texelFetch(depth_map, at, 0).r;
        hidden += smoothstep(0.008, 0.02, before) * (1.0 - smoothstep(0.06, 0.2, before));
    }
    return 1.0 - 0.2 * hidden;
}
void main() {
    ivec2 spot = ivec2(texelFetch(spots, here(), 0).xy);
    vec4 world = texelFetch(world_map, spot, 0);
    colour = vec4(0.0, 0.0, 0.0, 1.0);
    for (int k = 0; k < 4; k++) {
        ivec2 at = spot + ivec2(k & 1, k >> 1) * apart;
        vec2 exact = (vec2(spot) + 0.5 + samples[k]) / vec2(size);
        float d = texelFetch(fine_depth_map, at, 0).r;
        float z = range.x * range.y / (range.y - d * (range.y - range.x));
        vec4 own = texelFetch(albedo_map, at, 0), facing = texelFetch(normal_map, at, 0);
        vec3 p = place(exact, z), n = normalize(facing.xyz - 0.5 * facing.a + 1e-5);
        float shade = min(shaded(exact, z), close(p, n, 0.25 * float(k)));
        colour.rgb += 0.25 * lit(own, facing, p, shade, world);
    }
}
"""
EDGE = _CELLS + _SUNNY + _LIT + _EDGE
EDGE_SUNLESS = _CELLS + _SUNLESS + _LIT + _EDGE

#: What is seen through, over what is behind it: how much of it hides that comes out as alpha.
VEIL = (
    _CELLS
    + """
uniform sampler2D veil_map;
out vec4 colour;
void main() {
    float z = texelFetch(depth_map, here(), 0).r;
    vec4 veil = texelFetch(veil_map, here(), 0);
    vec3 p = place(uv, max(z, 0.001)), n = texelFetch(normal_map, here(), 0).xyz;
    vec3 way = normalize(p - eye);
    if (dot(n, way) > 0.0) n = -n;
    // What it mirrors (Schlick 1994) comes from where the mirrored ray goes.
    float edge = clamp(1.0 + dot(n, way), 0.0, 1.0), mirrors = 0.04 + 0.7 * edge * edge * edge;
    // Glass is clearer than its colour's alpha has it, liquids are not.
    float clear = 1.0 - smoothstep(0.45, 0.62, veil.a);
    veil.a *= 1.0 - 0.75 * clear;
    // Towards its rim one looks through much of it, and at what is beside it: it is darker there.
    float rim = clear * smoothstep(0.08, 0.7, edge);
    veil = mix(veil, vec4(0.35 * veil.rgb, 0.5), rim);
    vec3 lit = toned(linear(veil.rgb), around(p, n));
    vec3 mirrored = toned(vec3(1.0), around(p, reflect(way, n)));
    float hides = 1.0 - (1.0 - veil.a) * (1.0 - mirrors);
    vec3 both = (lit * veil.a * (1.0 - mirrors) + mirrored * mirrors) / max(hides, 0.001);
    colour = vec4(both, z > 0.0 ? hides : 0.0);
}
"""
)

#: Smooth edges from one picture (Lottes 2009, FXAA, the short form).
SMOOTH = """
#version 330
uniform sampler2D picture; uniform vec2 pixel; uniform ivec2 last;
in vec2 uv;
out vec4 colour;
const vec3 GREY = vec3(0.299, 0.587, 0.114);
vec3 at(vec2 by) { return texture(picture, uv + by).rgb; }
float bright(int x, int y) {
    ivec2 place = clamp(ivec2(gl_FragCoord.xy) + ivec2(x, y), ivec2(0), last);
    return dot(texelFetch(picture, place, 0).rgb, GREY);
}
void main() {
    vec3 own = texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb;
    float m = dot(own, GREY), nw = bright(-1, -1), ne = bright(1, -1);
    float sw = bright(-1, 1), se = bright(1, 1);
    float low = min(m, min(min(nw, ne), min(sw, se))), high = max(m, max(max(nw, ne), max(sw, se)));
    colour = vec4(own, 1.0);
    if (high - low < max(0.02, 0.06 * high)) return;
    vec2 along = vec2(sw + se - nw - ne, nw + sw - ne - se);
    float least = max((nw + ne + sw + se) * 0.03125, 0.0078125);
    along = clamp(along / (min(abs(along.x), abs(along.y)) + least), -8.0, 8.0) * pixel;
    vec3 near = 0.5 * (at(along * (-1.0 / 6.0)) + at(along / 6.0));
    vec3 wide = 0.5 * near + 0.25 * (at(-0.5 * along) + at(0.5 * along));
    float found = dot(wide, GREY);
    colour.rgb = found < low || found > high ? near : wide;
}
"""
