// A picture of one mesh by itself, drawn once: of a key in a list, of a key in a message, of a mesh before it
// is fitted.
#pragma once

#include <glm/vec2.hpp>

#include "hierarchy/union_mesh.h"
#include "render/camera.h"
#include "render/display.h"
#include "render/gl_object.h"
#include "render/offscreen_target.h"
#include "render/renderer.h"

namespace interleaf {

/// What is drawn, and how.
struct LonePicture {
    glm::ivec2 size;  ///< pixels
    int samples = 4;  ///< per pixel
    Camera camera;
    Display display;
    const UnionField* field = nullptr;  ///< of the mesh, what Coloring::field shows; null for none
};

/// Draws \p mesh, the union of one key, with weight 1. \p renderer has it as its surface afterwards.
/// \throw MachineError if the mesh or the picture is too large for the machine
OffscreenTarget draw_alone(Renderer& renderer, const UnionMesh& mesh, const NormalForm& form,
                           const LonePicture& picture);

/// The same as a texture.
GlTexture texture_alone(Renderer& renderer, const UnionMesh& mesh, const NormalForm& form,
                        const LonePicture& picture);

}  // namespace interleaf
