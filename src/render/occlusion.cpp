#include "render/occlusion.h"

#include <string_view>

#include <glad/gl.h>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "render/shader.h"

namespace interleaf {
namespace {

/// How far around a point its surroundings count, as a fraction of the picture's height.
constexpr float reach = 0.10F;

GlProgram make_pass(std::string_view fragment_shader) {
    const std::string_view files[] = {"background.vert", fragment_shader};
    return link_program(files);
}

void bind_texture(GLuint unit, const GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture.name());
}

/// Draws one triangle over the whole of the bound framebuffer with \p program, whose samplers read texture
/// units 0 (`depths`) and 1 (`openness`).
void run_pass(const GlProgram& program, const glm::mat4& unprojection) {
    const auto uniform = [&](const char* name) { return glGetUniformLocation(program.name(), name); };
    glUniform1i(uniform("depths"), 0);
    glUniform1i(uniform("openness"), 1);
    glUniformMatrix4fv(uniform("unprojection"), 1, GL_FALSE, glm::value_ptr(unprojection));
    glUniform1f(uniform("reach"), reach);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

Occlusion::Occlusion()
    : occlusion_program_(make_pass("occlusion.frag")),
      blur_program_(make_pass("occlusion_blur.frag")),
      occlude_program_(make_pass("occlude.frag")),
      no_attributes_(GlVertexArray::create()) {}

const Occlusion::Layers& Occlusion::layers_for(const OffscreenTarget& target) {
    const int width = target.width();
    const int height = target.height();
    if (!layers_ || layers_->width != width || layers_->height != height) {
        layers_.reset();  // two sets at a time may exceed the memory
        const int half_width = (width + 1) / 2;
        const int half_height = (height + 1) / 2;
        layers_ = Layers{width, height,
                         make_texture_layer(GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, width, height),
                         make_texture_layer(GL_RG32F, GL_COLOR_ATTACHMENT0, half_width, half_height),
                         make_texture_layer(GL_RG32F, GL_COLOR_ATTACHMENT0, half_width, half_height)};
    }
    return *layers_;
}

void Occlusion::darken(OffscreenTarget& target, const Camera& camera, float strength) {
    if (strength <= 0) return;
    const Layers& layers = layers_for(target);
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    const glm::mat4 unprojection = glm::inverse(camera.projection(aspect));
    target.copy_depths(layers.depths.framebuffer.name());

    glDisable(GL_DEPTH_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_BLEND);
    glBindVertexArray(no_attributes_.name());
    bind_texture(0, layers.depths.texture);

    glViewport(0, 0, (target.width() + 1) / 2, (target.height() + 1) / 2);
    glBindFramebuffer(GL_FRAMEBUFFER, layers.openness.framebuffer.name());
    glUseProgram(occlusion_program_.name());
    run_pass(occlusion_program_, unprojection);

    bind_texture(1, layers.openness.texture);
    glBindFramebuffer(GL_FRAMEBUFFER, layers.blurred.framebuffer.name());
    glUseProgram(blur_program_.name());
    run_pass(blur_program_, unprojection);

    bind_texture(1, layers.blurred.texture);
    target.bind();
    glUseProgram(occlude_program_.name());
    glUniform1f(glGetUniformLocation(occlude_program_.name(), "strength"), strength);
    // Light is multiplied, not encoded values.
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    run_pass(occlude_program_, unprojection);

    glDisable(GL_BLEND);
    glDisable(GL_FRAMEBUFFER_SRGB);
    bind_texture(1, {});
    bind_texture(0, {});
    glUseProgram(0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace interleaf
