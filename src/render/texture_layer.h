// A texture to draw into, with the framebuffer that does so.
#pragma once

#include "render/gl_object.h"

namespace interleaf {

struct TextureLayer {
    GlTexture texture;
    GlFramebuffer framebuffer;
};

/// \param format  GL_DEPTH_COMPONENT24, or a color format of two floats
/// \param attachment  of the framebuffer: GL_DEPTH_ATTACHMENT or GL_COLOR_ATTACHMENT0
/// \throw MachineError if the machine cannot draw into it
TextureLayer make_texture_layer(unsigned format, unsigned attachment, int width, int height);

}  // namespace interleaf
