#version 330 core
// Gives each corner its barycentric coordinates, from which the fragment shader finds the edges
// (single-pass wireframe, after Baerentzen et al. 2006).

layout(triangles) in;
layout(triangle_strip, max_vertices = 3) out;

in Corner {
    vec3 position;
    vec3 normal;
} corner[];

out Surface {
    vec3 position;
    vec3 normal;
    vec3 barycentric;
} surface;

void main() {
    for (int i = 0; i < 3; ++i) {
        surface.position = corner[i].position;
        surface.normal = corner[i].normal;
        surface.barycentric = vec3(i == 0, i == 1, i == 2);
        gl_Position = gl_in[i].gl_Position;
        gl_PrimitiveID = gl_PrimitiveIDIn;
        EmitVertex();
    }
    EndPrimitive();
}
