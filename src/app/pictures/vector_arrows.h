// Arrows of a vector field over the shown surface: at most one per cell of a grid over the picture.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "app/pictures/picture_depths.h"
#include "family/family.h"
#include "family/vector_field.h"
#include "hierarchy/union_mesh.h"
#include "render/camera.h"

namespace interleaf {

struct Arrow {
    glm::vec2 from{0};  ///< pixels, y down
    glm::vec2 to{0};
};

class VectorArrows {
  public:
    /// Unites \p vector, unless that is done for this union.
    /// \param mesh    the union of the active keys of \p weights
    /// \param number  changes with the union
    /// \param vector  none for no arrows
    void follow(const Family& family, const Weights& weights, const UnionMesh& mesh, std::size_t number,
                const std::optional<VectorField>& vector);

    bool are_shown() const { return !parts_.empty(); }

    /// The arrows at the visible vertices. The longest possible vector has the length of 1.5 cells.
    /// \param mesh, weights  those of the last follow()
    /// \param cell           side of a cell in pixels
    std::vector<Arrow> arrows(const UnionMesh& mesh, const Weights& weights, const Camera& camera,
                              const PictureDepths& picture, float cell) const;

  private:
    std::optional<VectorField> vector_;
    std::size_t number_ = 0;
    std::vector<float> offsets_;  ///< of the parts (family/field_scale.h)
    std::vector<UnionField>
        parts_;  ///< of x, y, and z if there is one; empty without a vector that all keys have
};

}  // namespace interleaf
