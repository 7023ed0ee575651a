#version 330 core
// The morph: the weighted sum of the keys' positions, and the normal as a quadratic form in the weights.
// A shown field is the weighted sum of the keys' values. The renderer defines KEY_COUNT, and FIELD, the
// number of components of the shown field, 0 for none. With VALUES, the values are not those of keys: with 1 there
// is one per vertex, with 2 one per leaf, which surface.frag reads.

layout(location = 0) in vec3 position[KEY_COUNT];
layout(location = 4) in vec3 product[KEY_COUNT * (KEY_COUNT + 1) / 2];

uniform mat4 view;
uniform mat4 projection;
uniform float weights[KEY_COUNT];
#if FIELD
uniform samplerBuffer field_values;  // vertex after vertex, key after key; colors in linear light
#endif

// In the camera's coordinates. The normal is not normalized, so it interpolates by area and may be zero. Normal and
// value are not extrapolated to the middle of a pixel that the triangle only touches.
out Corner {
    vec3 position;
    centroid vec3 normal;
#if FIELD == 1
    centroid float value;
#elif FIELD == 3
    centroid vec3 value;
#endif
} corner;

#if FIELD
vec3 field_value() {
#if VALUES == 1
    return vec3(texelFetch(field_values, gl_VertexID).r);
#elif VALUES == 2
    return vec3(0.0);
#else
    vec3 value = vec3(0.0);
    int next = gl_VertexID * KEY_COUNT * FIELD;
    for (int key = 0; key < KEY_COUNT; ++key)
        for (int c = 0; c < FIELD; ++c) value[c] += weights[key] * texelFetch(field_values, next++).r;
    return value;
#endif
}
#endif

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
#if FIELD == 1
    corner.value = field_value().x;
#elif FIELD == 3
    corner.value = field_value();
#endif
    gl_Position = projection * seen;
}
