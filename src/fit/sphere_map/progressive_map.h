// The progressive map of a closed surface of genus 0 to the sphere (Praun and Hoppe 2003; Hu, Fu and Liu
// 2018). Edge collapses reduce the surface to a tetrahedron. Then each vertex returns, into the kernel of its
// star on the sphere, and the map is relaxed whenever the number of vertices has grown by some factor.
#pragma once

#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "fit/mesh/half_edge_mesh.h"
#include "fit/mesh/progress_meter.h"
#include "fit/sphere_map/spherical_star.h"

namespace interleaf {

struct ProgressiveOptions {
    double growth = 1.3;  ///< factor by which the number of vertices grows between relaxations
    double blend = 0.05;  ///< of rest shapes towards equilateral, 0 to 1
    int sweeps = 100;     ///< maximum per relaxation
    Keeps keeps = Keeps::areas;

    /// Where a new vertex has a triangle with less than this fraction of its target area, the surroundings
    /// are relaxed at once. 0 turns this off.
    double crowded = 0;
    int moves_where_crowded = 500;  ///< maximum
};

/// For surfaces where the default fails: slower, and shapes are kept less exactly.
inline constexpr ProgressiveOptions careful_options = {.growth = 1.15, .blend = 0.2};

struct ProgressiveMap {
    std::vector<glm::dvec3> points;  ///< unit vectors, one per vertex; empty on failure
    std::string failure;             ///< the reason, in words
};

/// \param mesh       a closed simplicial sphere; restored on return, unless the work is cancelled
/// \param positions  within the unit box
ProgressiveMap map_progressively(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                                 const ProgressiveOptions& options, ProgressMeter& meter);

/// Per vertex, its share of 4 pi: the share of the area that the surface around the vertex has. Never 0.
std::vector<double> solid_angles_wanted(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions);

}  // namespace interleaf
