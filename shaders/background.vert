#version 330 core
// One triangle that covers the picture; height is 0 at its lower and 1 at its upper edge.

out float height;

void main() {
    vec2 corner = vec2((gl_VertexID << 1) & 2, gl_VertexID & 2);
    height = corner.y;
    gl_Position = vec4(2.0 * corner - 1.0, 0.0, 1.0);
}
