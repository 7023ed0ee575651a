#include "fit/landmarks/similarity.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "hierarchy/rotation_fit.h"

namespace interleaf {
namespace {

/// Points lie on one line if they are this much thinner than long, squared.
constexpr double thinnest = 1e-4;

glm::dvec3 center_of(std::span<const glm::dvec3> points) {
    glm::dvec3 sum(0);
    for (const glm::dvec3& point : points) sum += point;
    return sum / double(points.size());
}

std::vector<glm::dvec3> offsets_from(const glm::dvec3& center, std::span<const glm::dvec3> points) {
    std::vector<glm::dvec3> offsets;
    offsets.reserve(points.size());
    for (const glm::dvec3& point : points) offsets.push_back(point - center);
    return offsets;
}

double squared_size(std::span<const glm::dvec3> offsets) {
    double sum = 0;
    for (const glm::dvec3& offset : offsets) sum += glm::dot(offset, offset);
    return sum;
}

}  // namespace

Similarity fit_similarity(std::span<const glm::dvec3> from, std::span<const glm::dvec3> to, bool is_scaled) {
    Similarity found{.from_center = center_of(from), .to_center = center_of(to)};
    const std::vector<glm::dvec3> from_offsets = offsets_from(found.from_center, from);
    const std::vector<glm::dvec3> to_offsets = offsets_from(found.to_center, to);
    const double from_size = std::sqrt(squared_size(from_offsets));
    const double to_size = std::sqrt(squared_size(to_offsets));
    const RotationFit fit = fit_rotation(from_offsets, to_offsets);
    if (!(fit.margin > thinnest * from_size * to_size))
        throw InputError("the landmarks lie on one line, or nearly so, which leaves the placement open");
    found.rotation = fit.rotation;
    if (is_scaled) found.scale = to_size / from_size;
    return found;
}

}  // namespace interleaf
