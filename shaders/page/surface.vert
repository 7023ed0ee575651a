#version 300 es
// Morphs a union of keys, as surface.vert does in the program. There are no vertex arrays: the corner c of
// the leaf t is vertex 3 t + c, and textures of 2048 columns hold leaves, positions, normal products and
// fields.

precision highp float;
precision highp int;
precision highp sampler2D;
precision highp usampler2D;

const int most_keys = 4;

uniform usampler2D leaves;    // three vertices, and the tag
uniform sampler2D positions;  // key after key
uniform sampler2D products;   // normal product after product: (0,0), (0,1), (1,1), (0,2), ...
uniform sampler2D fields;     // key after key: linear light, or a scalar in red
uniform bool has_field;
uniform int key_count;
uniform int vertex_count;
uniform float weights[most_keys];
uniform mat4 view;
uniform mat4 projection;

out vec3 place;
centroid out vec3 normal;
centroid out vec3 value;
out vec3 barycentric;
flat out uint tag;

ivec2 texel(int index) { return ivec2(index & 2047, index >> 11); }

void main() {
    int leaf = gl_VertexID / 3;
    int corner = gl_VertexID - 3 * leaf;
    uvec4 entry = texelFetch(leaves, texel(leaf), 0);
    int vertex = int(entry[corner]);
    vec3 position = vec3(0.0);
    vec3 sum = vec3(0.0);
    value = vec3(0.0);
    int product = vertex;
    for (int j = 0; j < key_count; ++j) {
        position += weights[j] * texelFetch(positions, texel(j * vertex_count + vertex), 0).xyz;
        if (has_field) value += weights[j] * texelFetch(fields, texel(j * vertex_count + vertex), 0).xyz;
        for (int i = 0; i <= j; ++i) {
            sum += weights[i] * weights[j] * texelFetch(products, texel(product), 0).xyz;
            product += vertex_count;
        }
    }
    vec4 seen = view * vec4(position, 1.0);
    place = seen.xyz;
    normal = mat3(view) * sum;
    barycentric = vec3(corner == 0, corner == 1, corner == 2);
    tag = entry.w;
    gl_Position = projection * seen;
}
