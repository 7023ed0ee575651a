#version 330 core
// Gives each corner its barycentric coordinates in the leaf, from which the fragment shader finds the edges
// (single-pass wireframe, after Baerentzen et al. 2006). With CHECKER it also gives the coordinates in the
// root, which differ between the roots that share a vertex. FIELD as in surface.vert.

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in Corner {
    vec3 position;
    centroid vec3 normal;
#if FIELD == 1
    centroid float value;
#elif FIELD == 3
    centroid vec3 value;
#endif
} corner[];

out Surface {
    vec3 position;
    centroid vec3 normal;
#if FIELD == 1
    centroid float value;
#elif FIELD == 3
    centroid vec3 value;
#endif
#if CHECKER
    vec3 in_root;
#endif
    vec3 barycentric;
} surface;

#if CHECKER
uniform usamplerBuffer leaf_data;   // x: tag
uniform usamplerBuffer leaf_paths;  // bit n of 64 is the child taken at level n

// Level map (paper, equation (1)): the coordinates in the parent of a point in a child. Halving is exact, and
// so is a sum of numbers that were halved less than 24 times. So the coordinates are exact down to level 48.
vec3 in_parent(vec3 b, bool second) {
    return second ? vec3(b.y, 0.5 * b.x + b.z, 0.5 * b.x) : vec3(b.z, 0.5 * b.x, 0.5 * b.x + b.y);
}

// The coordinates of the leaf's corners in its root.
mat3 corners_in_root() {
    uvec2 path = texelFetch(leaf_paths, gl_PrimitiveIDIn).xy;
    mat3 corners = mat3(1.0);
    for (int level = int(texelFetch(leaf_data, gl_PrimitiveIDIn).x & 0x7fu) - 1; level >= 0; --level) {
        uint word = level < 32 ? path.x : path.y;
        bool second = (word >> uint(level & 31) & 1u) != 0u;
        for (int c = 0; c < 3; ++c) corners[c] = in_parent(corners[c], second);
    }
    return corners;
}
#endif

void main() {
#if CHECKER
    mat3 corners = corners_in_root();
#endif
    for (int i = 0; i < 3; ++i) {
        surface.position = corner[i].position;
        surface.normal = corner[i].normal;
#if FIELD
        surface.value = corner[i].value;
#endif
#if CHECKER
        surface.in_root = corners[i];
#endif
        surface.barycentric = vec3(i == 0, i == 1, i == 2);
        gl_Position = gl_in[i].gl_Position;
        gl_PrimitiveID = gl_PrimitiveIDIn;
        EmitVertex();
    }
    EndPrimitive();
}
