// Handles of OpenGL objects: move-only, and the object goes when its handle goes.
//
// A handle must be destroyed while the context is current in which it was made.
#pragma once

#include <utility>

namespace interleaf {

enum class GlKind { buffer, vertex_array, texture, framebuffer, renderbuffer, program };

/// The name of a new object of \p kind.
/// \pre a context is current
unsigned create_gl_object(GlKind kind);

/// Releases the object \p name of \p kind; 0 is no object.
void delete_gl_object(GlKind kind, unsigned name);

template <GlKind kind>
class GlObject {
  public:
    /// No object.
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

    /// The name that GL functions take; 0 when there is no object.
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
