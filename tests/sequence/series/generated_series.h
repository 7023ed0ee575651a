// Series of flat, bisected meshes for tests: random refinement and coarsening over common roots, flattened, and
// disguised as files of other programs disguise them.
#pragma once

#include <array>
#include <random>
#include <set>
#include <vector>

#include "trials.h"
#include <doctest/doctest.h>

#include "hierarchy/field_mesh.h"
#include "hierarchy/hierarchy.h"
#include "sequence/series/series.h"

namespace interleaf::testing {

/// Calls \p test with the random numbers of each of \p count seeds, fewer under the sanitizers.
template <typename Test>
void for_each_trial(unsigned count, const Test& test) {
    for (unsigned seed = 0; seed < trials(count); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        test(random);
    }
}

/// The unit square, of \p cells by \p cells squares of two triangles each.
Hierarchy square_roots(unsigned cells);

/// A field over the square: a front around a circle that moves with \p time.
double front_at(const glm::dvec3& at, double time);

/// Random meshes over \p roots: each refines and coarsens the one before. The triangles are in preorder, and the
/// newest vertex is the first corner. The field "u" is front_at() the time of the step.
std::vector<FieldMesh> random_steps(const Hierarchy& roots, unsigned count, std::mt19937& random);

/// How a mesh is written, without a change of the surface.
struct Disguise {
    unsigned newest = 0;       ///< the corner that is the newest vertex
    bool turned_over = false;  ///< about half of the triangles are clockwise
    bool shuffled = false;     ///< triangles and their corners are in random order
    bool doubled = false;      ///< each triangle has its own points
    double noise = 0;          ///< points are moved by up to this length
};
FieldMesh disguised(const FieldMesh& mesh, const Disguise& disguise, std::mt19937& random);

/// The corners of all triangles, with their first field: x, y, z, u. Corners of a triangle are in ascending
/// order.
using CornerSets = std::multiset<std::array<std::array<float, 4>, 3>>;
CornerSets corner_sets(const FieldMesh& mesh);
CornerSets corner_sets(const Hierarchy& key);

/// A series of \p steps, which must outlive it.
Series series_of(const std::vector<FieldMesh>& steps);

struct Recovered {
    SeriesReport report;
    std::vector<Hierarchy> keys;
};
Recovered recovered(const std::vector<FieldMesh>& steps, const SeriesOptions& options = {});

/// The length of the shortest edge of all \p steps.
double shortest_edge(const std::vector<FieldMesh>& steps);

}  // namespace interleaf::testing
