#version 300 es
// Colors the surface by level or by a field, lights it, and draws edges of constant width, as surface.frag
// does in the program.

precision highp float;
precision highp int;

in vec3 place;
centroid in vec3 normal;
centroid in vec3 value;
in vec3 barycentric;
flat in uint tag;

const int color_count = 13;

uniform int coloring;              // 0 plain, 1 by level, 2 by a scalar, 3 by a color
uniform vec3 colors[color_count];  // linear light, from the least to the largest
uniform vec2 range;                // of levels or of a scalar
uniform bvec3 edges;               // refinement edges, wireframe, root edges
uniform float line_width;          // pixels to each side

out vec4 color;

// Three soft lights, as in the program: towards each, and how far it reaches past the edge of its shadow.
const vec3 key = normalize(vec3(-0.48, 0.68, 0.55));
const vec3 fill = normalize(vec3(0.85, 0.05, 0.50));
const vec3 rim = normalize(vec3(0.45, 0.35, -0.82));

vec3 direction(vec3 v) {
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}

vec3 color_at(float number) {
    float at = clamp((number - range.x) / max(range.y - range.x, 1e-30), 0.0, 1.0) * float(color_count - 1);
    int before = min(int(at), color_count - 2);
    return mix(colors[before], colors[before + 1], at - float(before));
}

// How much of a pixel a line covers that reaches so many pixels to each side, from the distance of its
// middle.
float covered(float pixels, float reach) { return clamp(reach + 0.5 - pixels, 0.0, 1.0); }

float received(vec3 towards, float wrap, vec3 n) {
    float reached = max(dot(n, towards) + wrap, 0.0) / (1.0 + wrap);
    return reached * reached;
}

vec3 filmic(vec3 light) { return mix(light, 1.0 - 0.55 * exp((0.45 - light) / 0.55), step(0.45, light)); }

vec3 encoded(vec3 light) {
    light = clamp(light, 0.0, 1.0);
    return mix(12.92 * light, 1.055 * pow(light, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, light));
}

void main() {
    vec3 smoothed = direction(gl_FrontFacing ? normal : -normal);
    vec3 to_viewer = direction(-place);
    smoothed -= min(dot(smoothed, to_viewer), 0.0) * to_viewer;  // along an outline it may point away
    vec3 face = cross(dFdx(place), dFdy(place));
    vec3 n = direction(smoothed == vec3(0.0) ? face : smoothed);
    vec3 base = vec3(0.67, 0.62, 0.55);
    if (coloring == 1) base = color_at(float(tag & 127u));
    if (coloring == 2) base = color_at(value.x);
    if (coloring == 3) base = clamp(value, 0.0, 1.0);
    vec3 light = vec3(0.92, 0.89, 0.84) * received(key, 0.25, n)
               + vec3(0.18, 0.22, 0.29) * received(fill, 0.50, n)
               + vec3(0.42, 0.50, 0.62) * received(rim, 0.20, n)
               + mix(vec3(0.048), vec3(0.140, 0.155, 0.180), 0.5 + 0.5 * n.y);
    vec3 half_way = direction(key + to_viewer);
    vec3 lit = filmic(base * light + 0.04 * pow(max(dot(n, half_way), 0.0), 32.0));

    vec3 across = dFdx(barycentric);
    vec3 along = dFdy(barycentric);
    vec3 distances = barycentric / max(sqrt(across * across + along * along), vec3(1e-12));
    float nearest = min(distances.x, min(distances.y, distances.z));
    float nearest_root = 1e9;
    for (int side = 0; side < 3; ++side)
        if ((tag >> (7 + side) & 1u) != 0u) nearest_root = min(nearest_root, distances[side]);
    if (edges.y) lit = mix(lit, vec3(0.014), 0.75 * covered(nearest, 0.5 * line_width));
    if (edges.x) lit = mix(lit, vec3(0.90, 0.10, 0.03), covered(distances.x, line_width));
    if (edges.z) {
        lit = mix(lit, vec3(0.014), covered(nearest_root, line_width + 1.0));
        lit = mix(lit, vec3(0.92, 0.95, 1.00), covered(nearest_root, line_width));
    }
    color = vec4(encoded(lit), 1.0);
}
