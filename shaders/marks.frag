#version 330 core
// Dots with a dark rim, and lines that end in a light point.

in vec2 place;
out vec4 color;

uniform float mark_size;  // as in marks.geom

const vec3 dot_color = vec3(0.92, 0.95, 1.00);
const vec3 rim_color = vec3(0.012, 0.014, 0.020);
const vec3 root_color = vec3(0.02, 0.20, 0.55);
const vec3 tip_color = vec3(0.20, 0.65, 1.00);

void main() {
    float margin = mark_size + 1.0;
#if NORMALS
    float covered = clamp(mark_size + 0.5 - margin * abs(place.x), 0.0, 1.0);
    if (covered <= 0.0) discard;
    color = vec4(mix(root_color, tip_color, place.y), covered);
#else
    float radius = margin * length(place);
    float covered = clamp(mark_size + 0.5 - radius, 0.0, 1.0);
    if (covered <= 0.0) discard;
    float inner = clamp(0.62 * mark_size + 0.5 - radius, 0.0, 1.0);
    color = vec4(mix(rim_color, dot_color, inner), covered);
#endif
}
