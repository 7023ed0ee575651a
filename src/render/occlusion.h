// Ambient occlusion: darkens the hollows of a drawn surface, where less light of the sky arrives. It needs only
// the depths of the picture, so it costs the same however many leaves there are.
#pragma once

#include <optional>

#include "render/camera.h"
#include "render/gl_object.h"
#include "render/offscreen_target.h"
#include "render/texture_layer.h"

namespace interleaf {

class Occlusion {
  public:
    /// \pre  a context is current
    Occlusion();

    /// Darkens the picture in \p target, which shows a surface as \p camera sees it.
    /// \param strength  0 for no effect, 1 for the full effect
    void darken(OffscreenTarget& target, const Camera& camera, float strength);

  private:
    /// The intermediate pictures, for targets of one size.
    struct Layers {
        int width;
        int height;
        TextureLayer depths;
        TextureLayer openness;  ///< half the size, as blurred
        TextureLayer blurred;
    };

    const Layers& layers_for(const OffscreenTarget& target);

    GlProgram occlusion_program_;
    GlProgram blur_program_;
    GlProgram occlude_program_;
    GlVertexArray no_attributes_;
    std::optional<Layers> layers_;
};

}  // namespace interleaf
