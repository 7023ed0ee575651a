#version 330 core
// The part of the sky that the surface hides from each point of the ground, from the heights of the surface above the
// ground as seen from below: the form factor of parallel areas, summed over rings whose radii grow by a factor.
// Lengths are in half widths of the square.

uniform sampler2D depths;
uniform float range;  // height of the depths

out vec2 shadow_and_nothing;

const int rings = 12;
const int directions = 16;
const float first_radius = 0.012;
const float growth = 1.42;
const float two_pi = 6.2831853;

// The height of the surface above the ground; negative for none.
float height_at(vec2 place) {
    if (any(greaterThan(abs(place), vec2(1.0)))) return -1.0;
    float depth = texture(depths, 0.5 + 0.5 * place).r;
    return depth == 1.0 ? -1.0 : max(depth * range, 0.002);
}

void main() {
    vec2 place = 2.0 * gl_FragCoord.xy / vec2(textureSize(depths, 0)) - 1.0;
    float hidden = 0.0;
    float here = height_at(place);
    if (here >= 0.0) hidden = first_radius * first_radius / (here * here + first_radius * first_radius);
    float inner = first_radius;
    for (int ring = 0; ring < rings; ++ring) {
        float outer = inner * growth;
        float middle = sqrt(inner * outer);
        for (int i = 0; i < directions; ++i) {
            float angle = two_pi * (float(i) + 0.618 * float(ring)) / float(directions);
            float height = height_at(place + middle * vec2(cos(angle), sin(angle)));
            if (height < 0.0) continue;
            float squared = height * height;
            // The integral of the form factor over the ring.
            float part = outer * outer / (squared + outer * outer) - inner * inner / (squared + inner * inner);
            hidden += part / float(directions);
        }
        inner = outer;
    }
    shadow_and_nothing = vec2(clamp(hidden, 0.0, 1.0), 0.0);
}
