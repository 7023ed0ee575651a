#version 330 core
// A vertical gradient, dithered, because 8 bits would show its steps as bands.

in float height;

uniform bool is_light;

out vec4 color;

const vec3 dark_bottom = vec3(0.020, 0.022, 0.027);
const vec3 dark_top = vec3(0.085, 0.095, 0.115);
const vec3 light_bottom = vec3(0.560, 0.585, 0.625);
const vec3 light_top = vec3(0.880, 0.895, 0.915);

// Interleaved gradient noise (Jimenez 2014), -0.5 to 0.5.
float noise(vec2 pixel) {
    return fract(52.9829189 * fract(dot(pixel, vec2(0.06711056, 0.00583715)))) - 0.5;
}

void main() {
    vec3 bottom = is_light ? light_bottom : dark_bottom;
    vec3 top = is_light ? light_top : dark_top;
    vec3 light = mix(bottom, top, height * height * (3.0 - 2.0 * height));
    // The approximate light of one step of the sRGB encoding, which is nearly a square root.
    vec3 step_of_light = 2.0 * sqrt(light) / 255.0;
    color = vec4(light + noise(gl_FragCoord.xy) * step_of_light, 1.0);
}
