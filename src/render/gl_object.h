// Handles of OpenGL objects. They are move-only, and a handle's destructor deletes the object.
//
// A handle must be destroyed while the context that created its object is current.
#pragma once

#include <utility>

namespace interleaf {

enum class GlKind { buffer, vertex_array, texture, framebuffer, renderbuffer, program };

/// Creates an object of \p kind and returns its name.
/// \pre  a context is current
unsigned create_gl_object(GlKind kind);

/// Deletes the object \p name of \p kind. Ignores the name 0.
void delete_gl_object(GlKind kind, unsigned name);

template <GlKind kind>
class GlObject {
  public:
    /// A handle without an object.
    GlObject() = default;
    ~GlObject() { delete_gl_object(kind, name_); }
    GlObject(GlObject&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(name_, other.name_);
        return *this;
    }

    static GlObject create() {
        GlObject object;
        object.name_ = create_gl_object(kind);
        return object;
    }

    /// The name for GL functions; 0 if there is no object.
    unsigned name() const { return name_; }
    explicit operator bool() const { return name_ != 0; }

  private:
    unsigned name_ = 0;
};

using GlBuffer = GlObject<GlKind::buffer>;
using GlVertexArray = GlObject<GlKind::vertex_array>;
using GlTexture = GlObject<GlKind::texture>;
using GlFramebuffer = GlObject<GlKind::framebuffer>;
using GlRenderbuffer = GlObject<GlKind::renderbuffer>;
using GlProgram = GlObject<GlKind::program>;

}  // namespace interleaf
