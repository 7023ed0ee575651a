// The mesh that a key was fitted to, as the place of the key's new vertices.
#pragma once

#include <memory>
#include <vector>

#include <glm/vec3.hpp>

#include "app/document/fit_comparison.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/triangle.h"

namespace interleaf {

class FittedSurface {
  public:
    /// \param comparison  of the key, or of the key that brushing has changed
    explicit FittedSurface(std::shared_ptr<const FitComparison> comparison);
    FittedSurface(const FittedSurface&) = delete;  // distance_ refers to positions_
    FittedSurface& operator=(const FittedSurface&) = delete;
    ~FittedSurface() = default;

    /// The point of the mesh nearest to \p middle, the middle of an edge of the length \p length. It is \p middle
    /// itself where the mesh is farther away than a quarter of the edge: there the nearest point may belong to
    /// another part of the body.
    glm::vec3 place(const glm::vec3& middle, float length);

    const std::shared_ptr<const FitComparison>& comparison() const { return comparison_; }

  private:
    std::shared_ptr<const FitComparison> comparison_;
    std::vector<glm::dvec3> positions_;
    SurfaceDistance distance_;
    Index nearest_ = no_index;
};

}  // namespace interleaf
