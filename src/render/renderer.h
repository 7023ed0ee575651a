// The renderer: draws the morph of a union mesh. One for the window and for EGL.
//
// upload() sends what is constant while the active keys stay the same: leaves, tags, position streams, normal products.
// draw() sends weights, camera and display as uniforms and draws once; positions and exact normals are blended in the
// vertex shader. With more than max_gpu_keys active keys the blend is done on the processor into a streamed buffer.
#pragma once

#include <cstddef>
#include <span>

#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "render/camera.h"
#include "render/display.h"
#include "render/offscreen_target.h"

namespace interleaf {

/// Four keys take 14 of the 16 vertex attributes that OpenGL 3.3 promises.
inline constexpr std::size_t max_gpu_keys = 4;

class Renderer {
  public:
    /// \pre a context is current
    Renderer();

    /// Replaces the surface.
    void upload(const UnionMesh& mesh, const NormalForm& form);

    /// Draws the background and the surface with \p weights, one a key of the uploaded mesh, into \p target.
    void draw(const OffscreenTarget& target, const Camera& camera, std::span<const float> weights, const Display& display);

    /// Reads the shader files again and compiles them; keeps the old ones when that fails.
    /// \throw InputError with the compiler's message
    void reload_shaders();
};

}  // namespace interleaf
