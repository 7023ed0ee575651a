#version 330 core
// The morph: the weighted sum of the keys' positions, and the normal as a quadratic form in the weights.
// KEY_COUNT is defined by the renderer.

layout(location = 0) in vec3 position[KEY_COUNT];
layout(location = 4) in vec3 product[KEY_COUNT * (KEY_COUNT + 1) / 2];

uniform mat4 view;
uniform mat4 projection;
uniform float weights[KEY_COUNT];

// In the camera's coordinates; the normal is not normalised, so that it interpolates by area and may be zero.
out Corner {
    vec3 position;
    vec3 normal;
} corner;

void main() {
    vec3 morphed = vec3(0.0);
    vec3 normal = vec3(0.0);
    int next = 0;
    for (int j = 0; j < KEY_COUNT; ++j) {
        morphed += weights[j] * position[j];
        for (int i = 0; i <= j; ++i) normal += weights[i] * weights[j] * product[next++];
    }
    vec4 seen = view * vec4(morphed, 1.0);
    corner.position = seen.xyz;
    corner.normal = mat3(view) * normal;
    gl_Position = projection * seen;
}
