#version 330 core
// Marks at the vertices, of constant size in pixels: a dot, or with NORMALS a line along the normal. Vertices
// that face away from the viewer have none.

layout(points) in;
layout(triangle_strip, max_vertices = 4) out;

in Corner {
    vec3 position;
    centroid vec3 normal;
} corner[];

out vec2 place;  // in the mark: -1 to 1 across, and along

uniform mat4 projection;
uniform vec2 size;          // of the picture, in pixels
uniform float mark_size;    // radius of a dot, or half the width of a line, in pixels
uniform float line_length;  // of a normal, in pixels
uniform int step_size;      // one of so many vertices has a mark

const float towards_viewer = 3e-4;  // so that the surface does not hide its own marks

void emit(vec4 at, vec2 shift, vec2 in_mark) {
    place = in_mark;
    gl_Position = at + vec4(2.0 * shift / size * at.w, -towards_viewer * at.w, 0.0);
    EmitVertex();
}

void main() {
    if (gl_PrimitiveIDIn % step_size != 0) return;
    vec3 at = corner[0].position;
    vec4 from = projection * vec4(at, 1.0);
    if (from.w <= 0.0) return;
    float margin = mark_size + 1.0;  // the rim is blurred over a pixel
#if NORMALS
    float largest = max(abs(corner[0].normal.x), max(abs(corner[0].normal.y), abs(corner[0].normal.z)));
    if (largest == 0.0) return;
    vec3 normal = normalize(corner[0].normal / largest);
    float pixel = 2.0 * from.w / (projection[1][1] * size.y);  // in space, at the vertex
    vec4 to = projection * vec4(at + line_length * pixel * normal, 1.0);
    vec2 along = (to.xy / to.w - from.xy / from.w) * size;
    vec2 across = length(along) > 1e-6 ? normalize(vec2(-along.y, along.x)) : vec2(1.0, 0.0);
    emit(from, margin * across, vec2(1.0, 0.0));
    emit(from, -margin * across, vec2(-1.0, 0.0));
    emit(to, margin * across, vec2(1.0, 1.0));
    emit(to, -margin * across, vec2(-1.0, 1.0));
#else
    emit(from, vec2(-margin, -margin), vec2(-1.0, -1.0));
    emit(from, vec2(margin, -margin), vec2(1.0, -1.0));
    emit(from, vec2(-margin, margin), vec2(-1.0, 1.0));
    emit(from, vec2(margin, margin), vec2(1.0, 1.0));
#endif
    EndPrimitive();
}
