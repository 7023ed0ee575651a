// What a fit with landmarks achieved, measured on the keys.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/sphere_map/sphere_roots.h"
#include "hierarchy/hierarchy.h"
#include "hierarchy/landmark.h"

namespace interleaf {

/// A landmark after the fit. Lengths are fractions of the box diagonal of the mesh.
struct FittedLandmark {
    std::string name;
    glm::dvec3 position{0};   ///< the point of the mesh nearest to the given position
    glm::dvec3 direction{0};  ///< on the sphere: where the map puts that point
    double from_mesh = 0;     ///< distance of the given position from the mesh
    double off_in_key = 0;    ///< distance of the position from the point that the key has in the direction
};

/// The landmarks as a set in which all have directions, the targets of further meshes.
std::vector<Landmark> targets_of(std::span<const FittedLandmark> landmarks);

/// The point of \p key over the point \p direction of the sphere: that of the leaf in whose cone the direction
/// lies. Midpoints of the roots' edges on the sphere are those of the bisection.
/// \param roots  over which \p key was sampled
glm::dvec3 point_in_direction(const Hierarchy& key, const SphereRoots& roots, const glm::dvec3& direction);

/// The points of the sphere over which the vertices of \p key lie.
/// \param roots  over which \p key was sampled
/// \return       unit vectors, one per vertex
std::vector<glm::dvec3> sphere_points_of(const Hierarchy& key, const SphereRoots& roots);

/// How much a morph between two keys over the same roots changes shapes.
struct MorphDistortion {
    /// The conformal distortion (MIPS, 1 for similar triangles) that nine tenths of the area do not exceed.
    double at_90_percent = 1;
    std::size_t worst = 0;  ///< the landmark around which there is most distortion
};

/// \param landmarks  points of \p first, at least one
/// \throw InputError if the roots differ
MorphDistortion morph_distortion(const Hierarchy& first, const Hierarchy& other,
                                 std::span<const glm::dvec3> landmarks);

/// The sentence about \p distortion; empty if it is not unusual.
/// \param name  of the landmark around which there is most distortion
std::string fault_of_distortion(const MorphDistortion& distortion, const std::string& name);

}  // namespace interleaf
