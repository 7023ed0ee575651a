#version 330 core
// Colour by leaf, light, and edges of constant width in pixels.
// EDGES is defined by the renderer: 1 behind surface.geom.

#if EDGES
in Surface {
    vec3 position;
    vec3 normal;
    vec3 barycentric;
} surface;
#else
in Corner {
    vec3 position;
    vec3 normal;
} surface;
#endif

uniform bool flat_shading;
uniform int coloring;             // 0 plain, 1 by level, 2 by origin
uniform bool show_wireframe;
uniform bool show_refinement_edges;
uniform bool show_root_edges;
uniform float line_width;         // pixels
uniform usamplerBuffer leaf_data; // x the tag; y which corners touch root edges, above: its origin's place
uniform samplerBuffer palette;    // linear light

out vec4 color;

// Fixed to the camera: x right, y up, z towards the viewer.
const vec3 key_direction = normalize(vec3(-0.45, 0.65, 0.62));
const vec3 fill_direction = normalize(vec3(0.80, -0.05, 0.45));
const vec3 key_light = vec3(1.05, 1.01, 0.95);
const vec3 fill_light = vec3(0.16, 0.19, 0.25);
const vec3 sky_light = vec3(0.17, 0.185, 0.21);
const vec3 ground_light = vec3(0.045, 0.042, 0.04);

const vec3 wire_color = vec3(0.012, 0.014, 0.020);
const vec3 refinement_color = vec3(0.90, 0.10, 0.03);
const vec3 root_color = vec3(0.92, 0.95, 1.00);

// Normalises without under- or overflow; the zero vector stays zero.
vec3 direction(vec3 v) {
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}

// Towards the viewer.
vec3 shading_normal() {
    vec3 face = cross(dFdx(surface.position), dFdy(surface.position));
    vec3 smoothed = gl_FrontFacing ? surface.normal : -surface.normal;
    return direction(flat_shading || smoothed == vec3(0.0) ? face : smoothed);
}

vec3 leaf_color(uvec2 leaf) {
    int place = coloring == 1 ? int(leaf.x & 0x7fu) : coloring == 2 ? int(leaf.y >> 3) : 0;
    return texelFetch(palette, place).rgb;
}

vec3 lit(vec3 albedo, vec3 normal) {
    vec3 to_viewer = normalize(-surface.position);
    vec3 ambient = mix(ground_light, sky_light, 0.5 + 0.5 * normal.y);
    vec3 diffuse = key_light * max(dot(normal, key_direction), 0.0);
    diffuse += fill_light * max(dot(normal, fill_direction), 0.0);
    float gloss = max(dot(normal, normalize(key_direction + to_viewer)), 0.0);
    for (int i = 0; i < 5; ++i) gloss *= gloss;  // to the power of 32
    // A highlight would falsify colours that mean something.
    float shine = coloring == 0 ? 0.06 : 0.015;
    return albedo * (ambient + diffuse) + shine * gloss * key_light;
}

#if EDGES
vec3 flags(uint bits) { return vec3(bits & 1u, (bits >> 1) & 1u, (bits >> 2) & 1u); }

// Where the fragment is in its triangle, in pixels. Measured by derivatives of the barycentric coordinates,
// which, unlike corners projected to the window, are right also where a corner is behind the viewer.
struct Place {
    vec3 rise;        // of each coordinate in a pixel: the inverse of the triangle's height
    vec3 to_edges;    // opposite each corner
    vec3 to_corners;
};

Place place_in_triangle() {
    vec3 b = surface.barycentric;
    vec3 x = dFdx(b);
    vec3 y = dFdy(b);
    Place place;
    place.rise = max(sqrt(x * x + y * y), 1e-20);
    place.to_edges = abs(b) / place.rise;
    // Cramer's rule; the bound keeps a sliver of no area finite.
    mat2 adjugate = mat2(y.y, -x.y, -y.x, x.x);
    float determinant = max(abs(x.x * y.y - y.x * x.y), 1e-30);
    place.to_corners.x = length(adjugate * (b.xy - vec2(1.0, 0.0))) / determinant;
    place.to_corners.y = length(adjugate * (b.xy - vec2(0.0, 1.0))) / determinant;
    place.to_corners.z = length(adjugate * b.xy) / determinant;
    return place;
}

// How much of the fragment lines of this width cover whose middles are at these distances, 0 to 1.
vec3 coverage(vec3 distances, float width) {
    return 1.0 - smoothstep(0.5 * width - 0.6, 0.5 * width + 0.6, distances);
}

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

// The lines of a triangle darken at most this part of it: they fade as their triangle shrinks, so that on a
// dense mesh the shape does not drown.
float fade(vec3 rise, vec3 shown) {
    const float most = 0.35;
    return min(1.0, most / (line_width * dot(rise, shown)));
}

// Edges of the roots are light with a dark rim, so that they stand out from every colour. They are wider than
// small triangles: a triangle that only touches one draws its share of the line, too.
vec3 with_root_edges(vec3 light, uvec2 leaf, Place place) {
    vec3 edges = flags(leaf.x >> 7);
    vec3 corners = flags(leaf.y);
    float width = line_width;
    vec3 core = max(edges * coverage(place.to_edges, width), corners * coverage(place.to_corners, width));
    width *= 2.6;
    vec3 rim = max(edges * coverage(place.to_edges, width), corners * coverage(place.to_corners, width));
    return mix(mix(light, wire_color, largest(rim)), root_color, largest(core));
}

// Edges of all leaves, above them refinement edges, above them edges of the roots.
vec3 with_edges(vec3 light, uvec2 leaf) {
    const vec3 refinement = vec3(1.0, 0.0, 0.0);
    Place place = place_in_triangle();
    vec3 lines = coverage(place.to_edges, line_width);
    if (show_wireframe) light = mix(light, wire_color, 0.75 * fade(place.rise, vec3(1.0)) * largest(lines));
    if (show_refinement_edges) light = mix(light, refinement_color, fade(place.rise, refinement) * lines.x);
    if (show_root_edges) light = with_root_edges(light, leaf, place);
    return light;
}
#endif

void main() {
    uvec2 leaf = texelFetch(leaf_data, gl_PrimitiveID).xy;
    vec3 albedo = leaf_color(leaf);
    if (!gl_FrontFacing) albedo *= vec3(0.50, 0.55, 0.65);
    vec3 light = lit(albedo, shading_normal());
#if EDGES
    light = with_edges(light, leaf);
#endif
    color = vec4(light, 1.0);
}
