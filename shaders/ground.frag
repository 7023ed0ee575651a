#version 330 core
// The ground: a disc that fades into the background, darkened by the shadow.

in vec2 place;

uniform sampler2D shadows;
uniform float above;    // height of the viewer above the ground, in radii
uniform bool is_light;

out vec4 color;

const vec3 dark_ground = vec3(0.060, 0.064, 0.072);
const vec3 light_ground = vec3(0.82, 0.83, 0.85);

// The shadow around the place: rings of single rays leave streaks, which this average removes.
float smooth_shadow() {
    const int samples = 16;
    const float reach = 0.022;
    float sum = 0.0;
    for (int i = 0; i < samples; ++i) {
        float angle = 2.39996 * float(i);  // the golden angle
        vec2 aside = reach * sqrt((float(i) + 0.5) / float(samples)) * vec2(cos(angle), sin(angle));
        sum += texture(shadows, 0.5 + 0.5 * (place + aside)).r;
    }
    return sum / float(samples);
}

void main() {
    float shadow = smooth_shadow();
    float disc = 1.0 - smoothstep(0.20, 0.98, length(place));
    // Seen from the edge on, the disc would be a bright line.
    float seen = smoothstep(0.0, 0.25, above);
    vec3 light = is_light ? light_ground : dark_ground;
    color = vec4(light * (1.0 - 0.92 * shadow), disc * seen);
}
