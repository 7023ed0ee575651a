#include "render/ground.h"

#include <algorithm>
#include <string_view>

#include <glad/gl.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

#include "render/shader.h"

namespace interleaf {
namespace {

/// Width of the square that holds the shadow, in texels. It is soft, so that few suffice.
constexpr int side = 256;

/// The disc reaches so much farther than the surface, as a part of the surface's width and of its height.
constexpr float beyond_width = 0.7F;
constexpr float beyond_height = 0.35F;

GlProgram program_of(std::string_view vertex_shader, std::string_view fragment_shader) {
    const std::string_view files[] = {vertex_shader, fragment_shader};
    return link_program(files);
}

GLint place_of(const GlProgram& program, const char* name) {
    return glGetUniformLocation(program.name(), name);
}

void bind_layer(const TextureLayer& layer) {
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, layer.texture.name());
}

void unbind() {
    glBindTexture(GL_TEXTURE_2D, 0);
    glUseProgram(0);
    glBindVertexArray(0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
}

}  // namespace

Ground::Ground()
    : shadow_program_(program_of("background.vert", "ground_shadow.frag")),
      ground_program_(program_of("ground.vert", "ground.frag")),
      no_attributes_(GlVertexArray::create()),
      depths_(make_texture_layer(GL_DEPTH_COMPONENT24, GL_DEPTH_ATTACHMENT, side, side)),
      shadow_(make_texture_layer(GL_RG32F, GL_COLOR_ATTACHMENT0, side, side)) {
    glBindTexture(GL_TEXTURE_2D, shadow_.texture.name());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    glBindTexture(GL_TEXTURE_2D, 0);
}

void Ground::cast_shadow(Renderer& renderer, std::span<const float> weights, const Box& box, UpAxis up) {
    axes_ = axes_with(up);
    const glm::mat3 to_ground = glm::transpose(axes_);
    const glm::vec3 one_corner = to_ground * box.min;
    const glm::vec3 other_corner = to_ground * box.max;
    const glm::vec3 low = glm::min(one_corner, other_corner);
    const glm::vec3 high = glm::max(one_corner, other_corner);
    const glm::vec3 size = high - low;
    const float half = std::max(size.x, size.z) / 2;
    radius_ = std::max(half * (1 + 2 * beyond_width) + beyond_height * size.y, 1e-6F);
    center_ = {(low.x + high.x) / 2, low.y, (low.z + high.z) / 2};

    // Orthographic, from far below: x and z over the square, heights from 0 to `range` over the depths.
    const float range = std::max(1.2F * size.y, 1e-6F);
    glm::mat4 from_below(0);
    from_below[0][0] = 1 / radius_;
    from_below[2][1] = 1 / radius_;
    from_below[1][2] = 2 / range;
    from_below[3] = {-center_.x / radius_, -center_.z / radius_, -2 * center_.y / range - 1, 1};

    glBindFramebuffer(GL_FRAMEBUFFER, depths_.framebuffer.name());
    glViewport(0, 0, side, side);
    renderer.draw_depths(weights, from_below * glm::mat4(to_ground));

    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDisable(GL_SCISSOR_TEST);
    glBindFramebuffer(GL_FRAMEBUFFER, shadow_.framebuffer.name());
    glViewport(0, 0, side, side);
    glBindVertexArray(no_attributes_.name());
    bind_layer(depths_);
    glUseProgram(shadow_program_.name());
    glUniform1i(place_of(shadow_program_, "depths"), 0);
    glUniform1f(place_of(shadow_program_, "range"), range / radius_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    unbind();
}

void Ground::draw(const OffscreenTarget& target, const Camera& camera, bool is_light) const {
    target.bind();
    const float aspect = static_cast<float>(target.width()) / static_cast<float>(target.height());
    const glm::mat4 to_picture = camera.projection(aspect) * camera.view() * glm::mat4(axes_);
    const glm::vec3 normal = axes_[1];
    // Parallel rays see the ground from above wherever the camera stands, if they point down.
    const bool is_perspective = camera.projection() == Projection::perspective;
    const float above = is_perspective ? glm::dot(normal, camera.eye()) - center_.y
                                       : glm::dot(normal, camera.axes()[2]) * camera.distance();

    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glEnable(GL_DEPTH_CLAMP);  // the clipping planes lie close about the surface
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(no_attributes_.name());
    bind_layer(shadow_);
    glUseProgram(ground_program_.name());
    glUniform1i(place_of(ground_program_, "shadows"), 0);
    glUniformMatrix4fv(place_of(ground_program_, "to_picture"), 1, GL_FALSE, glm::value_ptr(to_picture));
    glUniform3fv(place_of(ground_program_, "center"), 1, glm::value_ptr(center_));
    glUniform1f(place_of(ground_program_, "radius"), radius_);
    glUniform1f(place_of(ground_program_, "above"), above / radius_);
    glUniform1i(place_of(ground_program_, "is_light"), is_light ? 1 : 0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);

    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_CLAMP);
    glDepthMask(GL_TRUE);
    glDisable(GL_FRAMEBUFFER_SRGB);
    unbind();
}

}  // namespace interleaf
