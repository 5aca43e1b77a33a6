"""How much light each pixel gets: from the cells of its room, from the sun, less what is near."""

#: Where a pixel is, from its depth.
_PLACE = """
#version 330
uniform sampler2D normal_map, depth_map;
uniform mat4 world_from_camera; uniform vec4 lens; uniform vec3 eye;
in vec2 uv;
// lens: x and y of the ray through the picture's corner (0, 0), and how far they go across it.
vec3 place(vec2 at) {
    float z = texture(depth_map, at).r;
    return (world_from_camera * vec4((lens.xy + at * lens.zw) * z, z, 1.0)).xyz;
}
"""

#: Ambient occlusion on the screen (after Mittring 2007), a turn of its directions by pixel.
SHADE = (
    _PLACE
    + """
uniform mat4 clip_from_world;
out vec2 shade;
const float REACH = 0.32; const int RAYS = 12;
void main() {
    float z = texture(depth_map, uv).r;
    shade = vec2(1.0, z);
    if (z == 0.0) return;
    vec3 p = place(uv), n = texture(normal_map, uv).xyz;
    if (dot(n, eye - p) < 0.0) n = -n;
    ivec2 cell = ivec2(gl_FragCoord.xy) & 3;
    float turn = float((cell.x * 5 + cell.y * 7 + cell.x * cell.y * 3) & 15) / 16.0;
    vec3 t = normalize(cross(n, abs(n.z) < 0.9 ? vec3(0, 0, 1) : vec3(1, 0, 0)));
    vec3 b = cross(n, t);
    float hidden = 0.0;
    for (int k = 0; k < RAYS; k++) {
        float f = (float(k) + 0.5) / float(RAYS);
        float angle = 6.2831853 * turn + float(k) * 2.3999632;
        vec3 way = (t * cos(angle) + b * sin(angle)) * sqrt(f) + n * sqrt(1.0 - f);
        vec3 s = p + n * 0.01 + way * REACH * (0.15 + 0.85 * fract(float(k) * 0.618034 + turn));
        vec4 c = clip_from_world * vec4(s, 1.0);
        vec2 at = c.xy / c.w * 0.5 + 0.5;
        if (any(lessThan(at, vec2(0.0))) || any(greaterThan(at, vec2(1.0)))) continue;
        float before = c.w - texture(depth_map, at).r;
        if (before > 0.012 && before < 0.5) hidden += 1.0;
    }
    shade.x = 1.0 - 0.85 * hidden / float(RAYS);
}
"""
)

#: At most so many rooms in a home.
ROOMS = 24

LIGHT = (
    _PLACE
    + f"""
const int ROOMS = {ROOMS};
"""
    + """
uniform sampler2D albedo_map, shade_map, sun_map, room_map;
uniform sampler3D side_0, side_1, side_2, side_3, side_4, side_5;
uniform vec2 pixel;
uniform vec4 plan;                     // of the room map: corner, cells a metre
uniform vec4 corner[ROOMS], cell[ROOMS], count[ROOMS];  // of the rooms' grids; count.w: offset
uniform vec3 cells;                    // of all grids side by side
uniform vec3 sun_right, sun_up, sun_along, sun_corner, sun, sun_light;
uniform float sun_step, exposure;
out vec4 colour;
float shaded(float z) {
    float sum = 0.0, weight = 0.0;
    for (int i = -2; i < 2; i++) for (int j = -2; j < 2; j++) {
        vec2 near = texture(shade_map, uv + (vec2(i, j) + 0.5) * pixel).rg;
        float alike = exp(-40.0 * abs(near.g - z) / z);
        sum += near.r * alike; weight += alike;
    }
    return weight > 0.001 ? sum / weight : 1.0;
}
vec3 around(vec3 p, vec3 n) {
    vec3 q = p + 0.14 * n;
    float room = texture(room_map, (q.xy - plan.xy) * plan.zw).r * 255.0;
    if (room < 0.5) { room = texture(room_map, (p.xy - plan.xy) * plan.zw).r * 255.0; }
    if (room < 0.5) return vec3(1.0);
    int k = int(room + 0.5) - 1;
    vec3 at = clamp((q - corner[k].xyz) / cell[k].xyz, vec3(0.5), count[k].xyz - 0.5);
    at = (at + vec3(count[k].w, 0.0, 0.0)) / cells;
    vec3 share = n * n;
    return share.x * (n.x > 0.0 ? texture(side_0, at) : texture(side_1, at)).rgb
         + share.y * (n.y > 0.0 ? texture(side_2, at) : texture(side_3, at)).rgb
         + share.z * (n.z > 0.0 ? texture(side_4, at) : texture(side_5, at)).rgb;
}
float sunny(vec3 p, vec3 n) {
    vec3 q = p + 0.03 * n;
    vec2 at = vec2(dot(q, sun_right), dot(q, sun_up)) - sun_corner.xy;
    float depth = dot(q, sun_along) - 0.03, sum = 0.0;
    for (int i = -2; i <= 2; i++) for (int j = -2; j <= 2; j++)
        sum += step(depth, texelFetch(sun_map, ivec2(at / sun_step + 0.8 * vec2(i, j)), 0).r);
    return sum / 25.0;
}
// Narkowicz 2015, "ACES filmic tone mapping curve".
vec3 toned(vec3 x) {
    return clamp(x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}
void main() {
    float z = texture(depth_map, uv).r;
    vec4 own = texture(albedo_map, uv);
    if (z == 0.0) { colour = vec4(0.0); return; }
    vec3 p = place(uv), n = texture(normal_map, uv).xyz;
    if (dot(n, eye - p) < 0.0) n = -n;
    vec3 given = around(p, n) * shaded(z);
    float slant = dot(n, sun);
    if (slant > 0.0 && sun_light.r > 0.0) given += sun_light * slant * sunny(p, n);
    vec3 linear = pow(own.rgb, vec3(2.2));
    vec3 light = linear * given / 3.14159265 * exposure;
    colour = vec4(pow(toned(light), vec3(1.0 / 2.2)), 1.0);
    // What gives light is as bright as its texture by day and by night.
    if (own.a > 0.5) colour.rgb = max(colour.rgb, own.rgb);
}
"""
)

#: Smooth edges from one picture (Lottes 2009, FXAA, the short form).
SMOOTH = """
#version 330
uniform sampler2D picture; uniform vec2 pixel;
in vec2 uv;
out vec4 colour;
const vec3 GREY = vec3(0.299, 0.587, 0.114);
vec3 at(vec2 by) { return texture(picture, uv + by).rgb; }
float bright(vec2 by) { return dot(at(by * pixel), GREY); }
void main() {
    float m = bright(vec2(0)), nw = bright(vec2(-1, -1)), ne = bright(vec2(1, -1));
    float sw = bright(vec2(-1, 1)), se = bright(vec2(1, 1));
    float low = min(m, min(min(nw, ne), min(sw, se))), high = max(m, max(max(nw, ne), max(sw, se)));
    vec2 along = vec2(sw + se - nw - ne, nw + sw - ne - se);
    float least = max((nw + ne + sw + se) * 0.03125, 0.0078125);
    along = clamp(along / (min(abs(along.x), abs(along.y)) + least), -8.0, 8.0) * pixel;
    vec3 near = 0.5 * (at(along * (-1.0 / 6.0)) + at(along / 6.0));
    vec3 wide = 0.5 * near + 0.25 * (at(-0.5 * along) + at(0.5 * along));
    float found = dot(wide, GREY);
    colour = vec4(found < low || found > high ? near : wide, 1.0);
}
"""
