#include "app/brushing/fitted_surface.h"

#include <utility>

#include <glm/geometric.hpp>

namespace interleaf {

FittedSurface::FittedSurface(std::shared_ptr<const FitComparison> comparison)
    : comparison_(std::move(comparison)),
      positions_(comparison_->positions.begin(), comparison_->positions.end()),
      distance_(comparison_->triangles, positions_) {}

glm::vec3 FittedSurface::place(const glm::vec3& middle, float length) {
    constexpr float max_part = 0.25F;
    const glm::vec3 nearest(distance_.nearest_point(middle, nearest_));
    return glm::distance(nearest, middle) <= max_part * length ? nearest : middle;
}

}  // namespace interleaf
