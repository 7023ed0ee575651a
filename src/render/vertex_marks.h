// Marks at the vertices of a surface: dots, and lines along the normals. They have a constant size in pixels.
#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <utility>

#include "render/camera.h"
#include "render/display.h"
#include "render/gl_object.h"
#include "render/offscreen_target.h"
#include "render/surface_buffers.h"

namespace interleaf {

class VertexMarks {
  public:
    /// Draws the marks that \p display asks for over the surface of \p buffers. Of many normals, it draws at
    /// most about max_normals.
    /// \param weights  one per key of \p buffers
    /// \pre  the framebuffer of \p target is bound, and has the depths of the surface
    void draw(const SurfaceBuffers& buffers, const OffscreenTarget& target, const Camera& camera,
              std::span<const float> weights, const Display& display);

    /// Compiles the shaders that are in use again.
    /// \throw InputError with the compiler's message; the old ones stay
    void reload_shaders();

    static constexpr std::size_t max_normals = 5'000;

  private:
    using Kind = std::pair<std::size_t, bool>;  ///< number of keys; normals or dots
    const GlProgram& program(const Kind& kind);

    std::map<Kind, GlProgram> programs_;  ///< made when first needed
};

}  // namespace interleaf
