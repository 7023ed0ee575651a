// The similarity that brings some points nearest to others: a scale, a rotation and a translation (Horn 1987,
// "Closed-form solution of absolute orientation using unit quaternions").
#pragma once

#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace interleaf {

struct Similarity {
    double scale = 1;
    glm::dmat3 rotation{1};
    glm::dvec3 from_center{0};
    glm::dvec3 to_center{0};

    glm::dvec3 operator()(const glm::dvec3& point) const {
        return to_center + scale * (rotation * (point - from_center));
    }
};

/// Centers go to centers. The scale is Horn's symmetric one: the ratio of the root mean square distances from
/// the centers.
/// \param from       at least three points
/// \param to         one point per point of \p from
/// \param is_scaled  otherwise, the scale is 1
/// \throw InputError if either points lie on one line, or nearly so, which leaves the rotation open
Similarity fit_similarity(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to, bool is_scaled);

}  // namespace interleaf
