// The coloring of the surface in the window by values that the blend determines (render/surface_values.h). They
// are computed anew only when the surface or its weights change.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/union_mesh.h"
#include "render/color_map.h"
#include "render/display.h"
#include "render/pick.h"
#include "render/renderer.h"
#include "render/surface_values.h"

namespace interleaf {

class MeasuredColoring {
  public:
    /// What the values are of.
    struct Subject {
        Coloring coloring;
        std::pair<bool, std::size_t> mesh;  ///< distinguishes the meshes
        std::vector<float> weights;
        std::vector<std::size_t> keys;  ///< active ones; the scale stays while these stay
        bool operator==(const Subject&) const = default;
    };

    bool has(const Subject& subject) const { return subject_ == subject; }

    /// Computes the values of \p subject, and gives them to \p renderer.
    /// \param mesh       the surface of \p renderer
    /// \param positions  of the blend
    void take(const Subject& subject, const UnionMesh& mesh, std::span<const glm::vec3> positions,
              Renderer& renderer);

    void forget() { subject_.reset(); }

    /// The value at a point of \p mesh; none without values of it.
    std::optional<float> value_at(const Hit& hit, const UnionMesh& mesh) const;

    /// Keeps the range of the scale, whatever the values are; none for the range that suits them.
    void keep_range(std::optional<ValueRange> range) { kept_range_ = range; }

    /// Of the last take().
    ColorScale scale() const;

  private:
    std::optional<Subject> subject_;
    std::optional<std::pair<Coloring, std::vector<std::size_t>>> scale_of_;
    SurfaceValues values_;
    ColorScale scale_;  ///< with the range that suits the values
    std::optional<ValueRange> kept_range_;
};

}  // namespace interleaf
