// Creates and deletes the objects behind the handles of gl_object.h.
#include "render/gl_object.h"

#include <glad/gl.h>

namespace interleaf {

unsigned create_gl_object(GlKind kind) {
    GLuint name = 0;
    switch (kind) {
        case GlKind::buffer:
            glGenBuffers(1, &name);
            break;
        case GlKind::vertex_array:
            glGenVertexArrays(1, &name);
            break;
        case GlKind::texture:
            glGenTextures(1, &name);
            break;
        case GlKind::framebuffer:
            glGenFramebuffers(1, &name);
            break;
        case GlKind::renderbuffer:
            glGenRenderbuffers(1, &name);
            break;
        case GlKind::program:
            name = glCreateProgram();
            break;
    }
    return name;
}

void delete_gl_object(GlKind kind, unsigned name) {
    // This also keeps a handle without an object from calling into a library that is not loaded.
    if (name == 0) return;
    switch (kind) {
        case GlKind::buffer:
            glDeleteBuffers(1, &name);
            break;
        case GlKind::vertex_array:
            glDeleteVertexArrays(1, &name);
            break;
        case GlKind::texture:
            glDeleteTextures(1, &name);
            break;
        case GlKind::framebuffer:
            glDeleteFramebuffers(1, &name);
            break;
        case GlKind::renderbuffer:
            glDeleteRenderbuffers(1, &name);
            break;
        case GlKind::program:
            glDeleteProgram(name);
            break;
    }
}

}  // namespace interleaf
