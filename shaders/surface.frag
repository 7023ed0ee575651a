#version 330 core
// Colors the surface by leaf, by a field or by the place in the root, lights it, and draws edges of constant
// width in pixels. The renderer defines EDGES and CHECKER, which are 1 if edges or the checkerboard are drawn
// (this shader then follows surface.geom), and FIELD and VALUES as in surface.vert.

#if EDGES || CHECKER
in Surface {
#else
in Corner {
#endif
    vec3 position;
    centroid vec3 normal;
#if FIELD == 1
    centroid float value;
#elif FIELD == 3
    centroid vec3 value;
#endif
#if CHECKER
    vec3 in_root;
#endif
#if EDGES || CHECKER
    vec3 barycentric;
#endif
} surface;

uniform mat4 projection;
uniform bool flat_shading;
uniform int coloring;             // 0 plain, 1 by level, 2 by origin, 3 other; FIELD and CHECKER take precedence
uniform int material;             // 0 clay, 1 porcelain, 2 steel, 3 jade, 4 normals; 0 with any coloring
uniform bool show_wireframe;
uniform bool show_refinement_edges;
uniform bool show_root_edges;
uniform float line_width;         // in pixels
uniform usamplerBuffer leaf_data; // x: tag; y: bits 0-2 corners on root edges, above: place of its origin
uniform samplerBuffer palette;    // linear light
#if VALUES == 2
uniform samplerBuffer field_values;  // one value per leaf
#endif
#if FIELD == 1
uniform vec2 value_range;         // values outside get the color of the nearer end
uniform vec3 placing;             // base, factor and offset of a value's place in the palette, 0 to 1
uniform bool is_logarithmic;      // the place is that of the value's logarithm
#endif

out vec4 color;

// Three soft lights, fixed to the camera: x right, y up, z towards the viewer. A soft light reaches past the edge of
// its shadow, as far as `wrap` says (0 is a point far away), so that no part of the surface ends in the dark.
struct Light {
    vec3 towards;
    vec3 color;
    float wrap;
};
const Light key_light = Light(normalize(vec3(-0.48, 0.68, 0.55)), vec3(0.92, 0.89, 0.84), 0.25);
const Light fill_light = Light(normalize(vec3(0.85, 0.05, 0.50)), vec3(0.18, 0.22, 0.29), 0.50);
const Light rim_light = Light(normalize(vec3(0.45, 0.35, -0.82)), vec3(0.42, 0.50, 0.62), 0.20);
const vec3 sky_light = vec3(0.140, 0.155, 0.180);
const vec3 ground_light = vec3(0.050, 0.046, 0.043);

const vec3 wire_color = vec3(0.012, 0.014, 0.020);
const vec3 refinement_color = vec3(0.90, 0.10, 0.03);
const vec3 refinement_over_colors = vec3(0.22, 0.015, 0.010);  // dark, so that the colors stay readable
const vec3 root_color = vec3(0.92, 0.95, 1.00);

// Normalizes without underflow or overflow; the zero vector stays zero.
vec3 direction(vec3 v) {
    float largest = max(abs(v.x), max(abs(v.y), abs(v.z)));
    return largest > 0.0 ? normalize(v / largest) : vec3(0.0);
}

vec3 direction_to_viewer() {
    bool is_perspective = projection[2][3] != 0.0;
    return is_perspective ? normalize(-surface.position) : vec3(0.0, 0.0, 1.0);
}

// The normal on the side of the viewer. Along an outline the interpolated normal may point away from the viewer,
// where the rim light would make bright specks: it is bent until it is perpendicular to the view.
vec3 shading_normal() {
    vec3 face = cross(dFdx(surface.position), dFdy(surface.position));
    vec3 smoothed = direction(gl_FrontFacing ? surface.normal : -surface.normal);
    vec3 to_viewer = direction_to_viewer();
    smoothed -= min(dot(smoothed, to_viewer), 0.0) * to_viewer;
    return direction(flat_shading || smoothed == vec3(0.0) ? face : smoothed);
}

#if FIELD == 1
vec3 field_color() {
#if VALUES == 2
    float shown = texelFetch(field_values, gl_PrimitiveID).r;
#else
    float shown = surface.value;
#endif
    float value = clamp(shown, value_range.x, value_range.y);
    if (is_logarithmic) value = log(value);
    float place = clamp((value - placing.x) * placing.y + placing.z, 0.0, 1.0);
    int last = textureSize(palette) - 1;
    float at = place * float(last);
    int before = clamp(int(at), 0, last - 1);
    return mix(texelFetch(palette, before).rgb, texelFetch(palette, before + 1).rgb, at - float(before));
}
#elif FIELD == 3
vec3 field_color() { return clamp(surface.value, 0.0, 1.0); }
#endif

#if CHECKER
const float cells = 8.0;  // along each edge of a root
const vec3 light_cell = vec3(0.80, 0.77, 0.70);
const vec3 dark_cell = vec3(0.085, 0.15, 0.22);

// A wave of 1 and -1 that changes its sign at the whole numbers from 1 on, blurred over the width of a pixel.
vec3 square_wave(vec3 x, vec3 width) {
    vec3 nearest = mix(0.5 - abs(fract(x) - 0.5), vec3(0.5), lessThan(x, vec3(0.5)));
    vec3 wave = (1.0 - 2.0 * mod(floor(max(x, 0.0)), 2.0)) * clamp(nearest / (0.5 * width), 0.0, 1.0);
    return wave * clamp(2.0 - 2.0 * width, 0.0, 1.0);
}

// Triangles of two colors. Along each edge of a root, the cells on both sides have one color, so the pattern
// does not show how the roots are marked.
vec3 checker_color() {
    vec3 x = cells * surface.in_root;
    vec3 waves = square_wave(x, max(fwidth(x), 1e-20));
    return mix(dark_cell, light_cell, 0.5 - 0.5 * waves.x * waves.y * waves.z);
}
#endif

vec3 leaf_color(uvec2 leaf) {
    int place = coloring == 1 ? int(leaf.x & 0x7fu) : coloring == 2 ? int(leaf.y >> 3) : 0;
    return texelFetch(palette, place).rgb;
}

// The light from a soft light; the square lets it fade out smoothly.
vec3 received(Light light, vec3 normal) {
    float reached = max(dot(normal, light.towards) + light.wrap, 0.0) / (1.0 + light.wrap);
    return light.color * reached * reached;
}

// Bends what is brighter than the shoulder towards white, as film does, so that bright parts keep their shape.
vec3 filmic(vec3 light) {
    const float shoulder = 0.45;
    const float above = 1.0 - shoulder;
    return mix(light, 1.0 - above * exp((shoulder - light) / above), step(shoulder, light));
}

vec3 lit(vec3 albedo, vec3 normal) {
    vec3 to_viewer = direction_to_viewer();
    vec3 light = mix(ground_light, sky_light, 0.5 + 0.5 * normal.y);
    light += received(key_light, normal) + received(fill_light, normal) + received(rim_light, normal);
    float gloss = max(dot(normal, normalize(key_light.towards + to_viewer)), 0.0);
    for (int i = 0; i < 5; ++i) gloss *= gloss;  // to the power of 32
    // A highlight would falsify colors that have a meaning.
    float shine = coloring == 0 ? 0.05 : 0.012;
    return filmic(albedo * light + shine * gloss * key_light.color);
}

float schlick(float cosine) { return 0.04 + 0.96 * pow(1.0 - clamp(cosine, 0.0, 1.0), 5.0); }

// The light of a studio with a bright ceiling, a dark floor and a window to the left.
vec3 studio(vec3 direction) {
    float up = direction.y;
    vec3 walls = mix(vec3(0.05, 0.05, 0.055), vec3(0.30, 0.32, 0.36), smoothstep(-0.9, -0.05, up));
    vec3 sky = mix(vec3(0.10, 0.11, 0.13), vec3(0.78, 0.81, 0.86), smoothstep(0.0, 0.9, up));
    float window = smoothstep(0.84, 0.97, dot(direction, key_light.towards));
    return mix(walls, sky, smoothstep(-0.03, 0.03, up)) + 1.4 * window * key_light.color;
}

vec3 porcelain(vec3 normal, vec3 to_viewer) {
    vec3 body = lit(vec3(0.86, 0.87, 0.88), normal);
    float mirrored = schlick(dot(normal, to_viewer));
    return filmic(mix(body, studio(reflect(-to_viewer, normal)), max(mirrored, 0.10)));
}

vec3 steel(vec3 normal, vec3 to_viewer) {
    vec3 mirrored = studio(reflect(-to_viewer, normal));
    vec3 tint = mix(vec3(0.60, 0.61, 0.64), vec3(1.0), schlick(dot(normal, to_viewer)));
    return filmic(tint * mirrored);
}

vec3 jade(vec3 normal, vec3 to_viewer) {
    float front = 0.5 + 0.5 * dot(normal, key_light.towards);
    float edge = 1.0 - clamp(dot(normal, to_viewer), 0.0, 1.0);
    vec3 body = mix(vec3(0.008, 0.050, 0.034), vec3(0.20, 0.50, 0.28), front * front);
    body += vec3(0.06, 0.15, 0.06) * edge * edge;  // light that shines through thin parts
    return filmic(mix(body, studio(reflect(-to_viewer, normal)), schlick(dot(normal, to_viewer))));
}

vec3 made_of(vec3 albedo, vec3 normal) {
    vec3 to_viewer = direction_to_viewer();
    if (material == 1) return porcelain(normal, to_viewer);
    if (material == 2) return steel(normal, to_viewer);
    if (material == 3) return jade(normal, to_viewer);
    if (material == 4) return pow(0.5 + 0.5 * normal, vec3(2.2));
    return lit(albedo, normal);
}

#if EDGES
vec3 flags(uint bits) { return vec3(bits & 1u, (bits >> 1) & 1u, (bits >> 2) & 1u); }

// The place of the fragment in its triangle, in pixels. It is computed from derivatives of the barycentric
// coordinates, which are correct even if a corner is behind the viewer, unlike corners projected to the window.
struct Place {
    vec3 rise;        // of each coordinate per pixel: the inverse of the triangle's height
    vec3 to_edges;    // distances to the edges opposite each corner
    vec3 to_corners;
};

Place place_in_triangle() {
    vec3 b = surface.barycentric;
    vec3 x = dFdx(b);
    vec3 y = dFdy(b);
    Place place;
    place.rise = max(sqrt(x * x + y * y), 1e-20);
    place.to_edges = abs(b) / place.rise;
    // Cramer's rule; the bound keeps the result finite for a sliver of no area.
    mat2 adjugate = mat2(y.y, -x.y, -y.x, x.x);
    float determinant = max(abs(x.x * y.y - y.x * x.y), 1e-30);
    place.to_corners.x = length(adjugate * (b.xy - vec2(1.0, 0.0))) / determinant;
    place.to_corners.y = length(adjugate * (b.xy - vec2(0.0, 1.0))) / determinant;
    place.to_corners.z = length(adjugate * b.xy) / determinant;
    return place;
}

// The fraction (0 to 1) of the fragment that lines of this width cover if their middles are at these distances.
vec3 coverage(vec3 distances, float width) {
    return 1.0 - smoothstep(0.5 * width - 0.6, 0.5 * width + 0.6, distances);
}

float largest(vec3 v) { return max(v.x, max(v.y, v.z)); }

// Lines fade as their triangle shrinks, so that they do not hide the shape of a dense mesh: they cover at
// most a fixed fraction of the triangle.
float fade(vec3 rise, vec3 shown) {
    const float max_fraction = 0.35;
    return min(1.0, max_fraction / (line_width * dot(rise, shown)));
}

// Root edges are light with a dark rim, so that they stand out from every color. They are wider than small
// triangles, so a triangle that only touches a root edge also draws its share of the line.
vec3 with_root_edges(vec3 light, uvec2 leaf, Place place) {
    vec3 edges = flags(leaf.x >> 7);
    vec3 corners = flags(leaf.y);
    float width = line_width;
    vec3 core = max(edges * coverage(place.to_edges, width), corners * coverage(place.to_corners, width));
    width *= 2.6;
    vec3 rim = max(edges * coverage(place.to_edges, width), corners * coverage(place.to_corners, width));
    return mix(mix(light, wire_color, largest(rim)), root_color, largest(core));
}

// Leaf edges, refinement edges above them, and root edges on top.
vec3 with_edges(vec3 light, uvec2 leaf) {
    const vec3 refinement = vec3(1.0, 0.0, 0.0);
    Place place = place_in_triangle();
    vec3 lines = coverage(place.to_edges, line_width);
    if (show_wireframe) light = mix(light, wire_color, 0.75 * fade(place.rise, vec3(1.0)) * largest(lines));
    if (show_refinement_edges) {
        vec3 line = coloring == 0 ? refinement_color : refinement_over_colors;
        float strength = coloring == 0 ? 1.0 : 0.7;
        light = mix(light, line, strength * fade(place.rise, refinement) * lines.x);
    }
    if (show_root_edges) light = with_root_edges(light, leaf, place);
    return light;
}
#endif

void main() {
    uvec2 leaf = texelFetch(leaf_data, gl_PrimitiveID).xy;
#if CHECKER
    vec3 albedo = checker_color();
#elif FIELD
    vec3 albedo = field_color();
#else
    vec3 albedo = leaf_color(leaf);
#endif
    if (!gl_FrontFacing) albedo *= vec3(0.50, 0.55, 0.65);
    vec3 light = made_of(albedo, shading_normal());
    if (material != 0 && !gl_FrontFacing) light *= vec3(0.50, 0.55, 0.65);
#if EDGES
    light = with_edges(light, leaf);
#endif
    color = vec4(light, 1.0);
}
