#version 330 core
// Averages the openness over blocks of 4 by 4 pixels, without crossing the outlines of the surface.

uniform sampler2D openness;
uniform mat4 unprojection;

const float depth_per_height = 1.586;  // in the perspective of camera.h

out vec2 openness_and_depth;

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(openness, 0) - 1;
    float depth = texelFetch(openness, pixel, 0).y;
    // Differences of depth count relative to what the picture shows: in perspective it grows with the depth.
    bool is_perspective = unprojection[2][3] != 0.0;
    float scale = is_perspective ? depth : depth_per_height * 2.0 * unprojection[1][1];
    vec2 sum = vec2(0.0);
    for (int y = -2; y < 2; ++y)
        for (int x = -2; x < 2; ++x) {
            vec2 other = texelFetch(openness, clamp(pixel + ivec2(x, y), ivec2(0), last), 0).xy;
            float weight = max(1.0 - 30.0 * abs(other.y - depth) / scale, 0.001);
            sum += weight * vec2(other.x, 1.0);
        }
    openness_and_depth = vec2(sum.x / sum.y, depth);
}
