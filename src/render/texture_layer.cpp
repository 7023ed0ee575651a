#include "render/texture_layer.h"

#include <fmt/core.h>
#include <glad/gl.h>

#include "hierarchy/error.h"

namespace interleaf {

TextureLayer make_texture_layer(unsigned format, unsigned attachment, int width, int height) {
    TextureLayer layer{GlTexture::create(), GlFramebuffer::create()};
    const bool is_depth = attachment == GL_DEPTH_ATTACHMENT;
    glBindTexture(GL_TEXTURE_2D, layer.texture.name());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0,
                 is_depth ? GL_DEPTH_COMPONENT : GL_RG, is_depth ? GL_UNSIGNED_INT : GL_FLOAT, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, layer.framebuffer.name());
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, layer.texture.name(), 0);
    const GLenum buffer = is_depth ? GL_NONE : GL_COLOR_ATTACHMENT0;
    glDrawBuffer(buffer);
    glReadBuffer(buffer);
    const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (status != GL_FRAMEBUFFER_COMPLETE)
        throw MachineError(fmt::format("cannot make a framebuffer: status {:#x}", status));
    return layer;
}

}  // namespace interleaf
