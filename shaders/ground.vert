#version 330 core
// The square of the ground.

uniform mat4 to_picture;
uniform vec3 center;
uniform float radius;

out vec2 place;  // -1 to 1 over the square

void main() {
    place = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    gl_Position = to_picture * vec4(center + radius * vec3(place.x, 0.0, place.y), 1.0);
}
