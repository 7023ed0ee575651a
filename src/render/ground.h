// The ground below the surface, with the soft shadow that the surface casts on it from an evenly bright sky. The
// ground is a disc that fades into the background; from below it is invisible.
#pragma once

#include <span>
#include <vector>

#include "hierarchy/measure.h"
#include "render/camera.h"
#include "render/gl_object.h"
#include "render/offscreen_target.h"
#include "render/renderer.h"
#include "render/texture_layer.h"

namespace interleaf {

class Ground {
  public:
    /// \pre a context is current
    Ground();

    /// Makes the shadow anew.
    /// \param renderer  has the surface
    /// \param weights   as in Renderer::draw()
    /// \param box       the ground lies at its bottom; the shadow holds for surfaces within it
    /// \param up        the normal of the ground
    void cast_shadow(Renderer& renderer, std::span<const float> weights, const Box& box,
                     UpAxis up = UpAxis::y);

    /// Draws the ground behind the surface of \p target. Its depths stay.
    /// \param is_light  whether the background is light
    /// \pre cast_shadow() has been called
    void draw(const OffscreenTarget& target, const Camera& camera, bool is_light) const;

  private:
    GlProgram shadow_program_;
    GlProgram ground_program_;
    GlVertexArray no_attributes_;
    TextureLayer depths_;  ///< the surface from below
    TextureLayer shadow_;
    glm::mat3 axes_{1};    ///< of the ground: the middle one is its normal
    glm::vec3 center_{0};  ///< of the disc, along these axes
    float radius_ = 1;     ///< of the disc
};

}  // namespace interleaf
