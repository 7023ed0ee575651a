// A cone around the normals of the leaves below each bisected node. It tells from which directions a silhouette
// may run through the surface below the node.
#pragma once

#include <numbers>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/detail/bisection_forest.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// All directions within \p half_angle, 0 to pi, of \p axis, a unit vector. Without an axis (zero) all
/// directions.
struct NormalCone {
    glm::vec3 axis{0};
    float half_angle = std::numbers::pi_v<float>;
};

/// The smallest cone around two cones.
NormalCone cone_around(const NormalCone& a, const NormalCone& b);

/// By the place of a bisected node: a cone around the normals of all leaves below it, in time proportional to
/// the number of leaves. Leaves without area do not count.
/// \param forest  bisection_forest() of \p hierarchy
/// \pre  the hierarchy passes check()
std::vector<NormalCone> normal_cones(const Hierarchy& hierarchy, const BisectionForest& forest);

}  // namespace interleaf
