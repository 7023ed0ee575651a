// The progressive map of a closed surface of genus 0 to the sphere (Praun and Hoppe 2003; Hu, Fu and Liu
// 2018): down to a tetrahedron by edge collapses, then each vertex back into the kernel of its star on the
// sphere, with relaxation whenever the count has grown by some factor.
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
    double growth = 1.3;  ///< the vertices grow by this factor between relaxations
    double blend = 0.05;  ///< rest shapes go this far towards equilateral, 0 to 1
    int sweeps = 100;     ///< at most, each time
    Keeps keeps = Keeps::areas;

    /// Where a new vertex has a triangle of less than this part of the area that it is to take, its
    /// surroundings are relaxed at once. 0 for nowhere.
    double crowded = 0;
    int moves_where_crowded = 500;  ///< at most
};

/// For when the default fails: slower, and the shapes are kept less exactly.
inline constexpr ProgressiveOptions careful_options = {.growth = 1.15, .blend = 0.2};

struct ProgressiveMap {
    std::vector<glm::dvec3> points;  ///< unit, one a vertex; empty when it failed
    std::string failure;             ///< in words
};

/// \param mesh       a closed simplicial sphere; as before on return, unless the work is cancelled
/// \param positions  within the unit box
ProgressiveMap map_progressively(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions,
                                 const ProgressiveOptions& options, ProgressMeter& meter);

/// The part of 4 pi that the surface around each vertex has of the whole area, none of it 0.
std::vector<double> solid_angles_wanted(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions);

}  // namespace interleaf
