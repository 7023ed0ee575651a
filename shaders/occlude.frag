#version 330 core
// Darkens the picture where the surface is not open. Blending multiplies the picture by the result.

uniform sampler2D depths;
uniform sampler2D openness;
uniform mat4 unprojection;
uniform float strength;  // 0 for no effect, 1 for the full effect

const float depth_per_height = 1.586;  // in the perspective of camera.h

out vec4 factor;

float depth_of(float device_depth) {
    vec4 place = unprojection * vec4(0.0, 0.0, 2.0 * device_depth - 1.0, 1.0);
    return -place.z / place.w;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    float device_depth = texelFetch(depths, pixel, 0).r;
    factor = vec4(1.0);
    if (device_depth == 1.0) return;
    float depth = depth_of(device_depth);
    // Differences of depth count relative to what the picture shows: in perspective it grows with the depth.
    bool is_perspective = unprojection[2][3] != 0.0;
    float scale = is_perspective ? depth : depth_per_height * 2.0 * unprojection[1][1];
    vec2 at = 0.5 * vec2(pixel);
    ivec2 first = ivec2(floor(at));
    vec2 between = at - vec2(first);
    ivec2 last = textureSize(openness, 0) - 1;
    vec2 sum = vec2(0.0);
    for (int y = 0; y < 2; ++y)
        for (int x = 0; x < 2; ++x) {
            vec2 other = texelFetch(openness, min(first + ivec2(x, y), last), 0).xy;
            vec2 share = mix(1.0 - between, between, vec2(x, y));
            float weight = (share.x * share.y + 0.001) * max(1.0 - 30.0 * abs(other.y - depth) / scale, 0.001);
            sum += weight * vec2(other.x, 1.0);
        }
    factor = vec4(vec3(mix(1.0, sum.x / sum.y, strength)), 1.0);
}
