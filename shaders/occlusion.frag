#version 330 core
// How open the surface is to the light of the sky, from the depths of the picture: scalable ambient obscurance
// (McGuire, Mara and Luebke 2012). Drawn at half the size of the picture.

uniform sampler2D depths;
uniform mat4 unprojection;   // the inverse of the projection
uniform float reach;         // how far around a point its surroundings count, as a fraction of the picture's height

out vec2 openness_and_depth;  // openness from 0 to 1; distance in front of the viewer

const int sample_count = 24;
const float turns = 7.0;  // of the spiral that the samples form
const float two_pi = 6.2831853;

vec3 place_of(ivec2 pixel) {
    ivec2 size = textureSize(depths, 0);
    pixel = clamp(pixel, ivec2(0), size - 1);
    vec3 device = vec3((vec2(pixel) + 0.5) / vec2(size), texelFetch(depths, pixel, 0).r);
    vec4 place = unprojection * vec4(2.0 * device - 1.0, 1.0);
    return place.xyz / place.w;
}

// The difference to the neighbor on the same surface: the one whose depth is nearer.
vec3 slope(vec3 place, ivec2 pixel, ivec2 aside) {
    vec3 after = place_of(pixel + aside) - place;
    vec3 before = place - place_of(pixel - aside);
    return abs(after.z) < abs(before.z) ? after : before;
}

void main() {
    ivec2 pixel = 2 * ivec2(gl_FragCoord.xy);
    ivec2 last = textureSize(depths, 0) - 1;
    vec3 place = place_of(pixel);
    openness_and_depth = vec2(1.0, -place.z);
    if (texelFetch(depths, min(pixel, last), 0).r == 1.0) return;

    vec3 normal = normalize(cross(slope(place, pixel, ivec2(1, 0)), slope(place, pixel, ivec2(0, 1))));
    // Here the height of the picture is 2 unprojection[1][1], in perspective times the depth.
    bool is_perspective = unprojection[2][3] != 0.0;
    float radius = reach * 2.0 * unprojection[1][1] * (is_perspective ? -place.z : 1.0);
    float pixels = reach * float(textureSize(depths, 0).y);
    // Each pixel of a block of 4 by 4 turns the spiral differently; the blur averages over such blocks.
    ivec2 in_block = ivec2(gl_FragCoord.xy) & 3;
    float turned = float(((in_block.x ^ in_block.y) & 3) * 4 + in_block.x) / 16.0;
    float hidden = 0.0;
    for (int i = 0; i < sample_count; ++i) {
        float out_to = (float(i) + 0.5) / float(sample_count);
        float angle = two_pi * (turns * out_to + turned);
        vec3 to_sample = place_of(pixel + ivec2(out_to * pixels * vec2(cos(angle), sin(angle)))) - place;
        float squared = dot(to_sample, to_sample);
        float near = max(1.0 - squared / (radius * radius), 0.0);
        float rise = dot(to_sample, normal) - 0.02 * radius;
        hidden += near * max(rise, 0.0) / (sqrt(squared) + 0.01 * radius);
    }
    openness_and_depth.x = max(1.0 - 7.0 * hidden / float(sample_count), 0.0);
}
