// The surface in the window at the detail that suits the camera: a cut of the active keys, within a budget of
// leaves, that is made anew for every view (hierarchy/detail/view_refinement.h).
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "app/pictures/key_details.h"
#include "app/pictures/morph_surface.h"
#include "family/family.h"
#include "hierarchy/detail/view_mesh.h"
#include "hierarchy/detail/view_refinement.h"
#include "hierarchy/measure.h"
#include "render/camera.h"
#include "render/pick.h"
#include "render/renderer.h"

namespace interleaf {

/// Leaves of the surface in the window while its detail follows the camera.
inline constexpr std::size_t view_leaf_budget = 20'000;

class DetailSurface {
  public:
    /// \pre a GL context is current
    DetailSurface() = default;

    /// Adopts the active keys of \p weights.
    /// \return false, and changes nothing, if \p details has not measured all of them
    bool follow(const Family& family, const Weights& weights, const KeyDetails& details);

    /// Refines the blend for a picture, unless the last picture was the same.
    /// \param weights  those of the last follow()
    /// \param aspect   width / height of the picture
    /// \param field    the field to show; null for none
    void refine(const Family& family, const Weights& weights, const Camera& camera, float aspect,
                const FieldName* field);

    /// As in MorphSurface, of the last refine().
    std::optional<glm::vec3> field_at(const Ray& ray) const;
    std::optional<NodePath> leaf_at(const Ray& ray) const;
    Extent extent() const;
    const SurfaceFigures& figures() const { return figures_; }

    /// Counts the surfaces, from 1.
    std::size_t version() const { return version_; }

    /// The mesh of the last refine(), and the positions of its blend.
    const UnionMesh& mesh() const { return mesh_.mesh; }
    std::span<const glm::vec3> positions() const { return mesh_.positions; }

    Renderer& renderer() { return renderer_; }

  private:
    /// What the surface was made from.
    struct Subject {
        std::vector<std::size_t> keys;
        std::vector<float> weights;
        Camera camera;
        float aspect;
        std::optional<FieldName> field;
        std::vector<std::string> names;
        bool operator==(const Subject&) const = default;
    };
    std::vector<SharedHierarchy> hierarchies_;  ///< of the active keys
    std::vector<KeyDetails::Measured> measured_;
    std::optional<ViewRefinement> refinement_;
    std::optional<Subject> subject_;  ///< of mesh_; none before the first
    ViewMesh mesh_;
    std::optional<UnionField> field_;
    SurfaceFigures figures_;
    std::size_t version_ = 0;
    Renderer renderer_;
};

}  // namespace interleaf
