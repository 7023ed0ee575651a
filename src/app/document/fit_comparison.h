// Compares a fitted key with the mesh it was fitted to: the distances between them, per vertex.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "family/family.h"
#include "fit/fit.h"
#include "hierarchy/progress.h"

namespace interleaf {

/// Distances are in percent of the diagonal of the mesh's box.
struct FitComparison {
    std::string mesh_name;  ///< the name of the mesh's file
    SharedHierarchy key;
    std::vector<Triangle> triangles;  ///< of the cleaned mesh
    std::vector<glm::vec3> positions;
    std::vector<float> mesh_distances;  ///< from each vertex of the mesh to the key

    /// Per vertex of the key, the largest distance to the mesh from the vertex, from the centers of the
    /// leaves around it, and from the middles of their edges. The vertices themselves lie on the mesh.
    std::vector<float> key_distances;

    FitQuality quality;
};

/// Compares a key with its mesh.
/// \throw Cancelled when \p progress says so
FitComparison compare(std::string mesh_name, FittedKey fitted, const Progress& progress = {});

/// The largest of all distances in \p comparison.
float max_distance(const FitComparison& comparison);

using Comparisons = std::vector<std::shared_ptr<const FitComparison>>;

/// A key of a family that has a comparison.
struct ComparedKey {
    std::size_t key;  ///< index in the family
    std::shared_ptr<const FitComparison> comparison;
};

/// The keys of \p family that \p comparisons compare, in the family's order. A key belongs to a comparison if
/// both share the same hierarchy in memory; names do not matter.
std::vector<ComparedKey> compared_keys(const Family& family, const Comparisons& comparisons);

/// The quality of a fit as the beginning of a sentence: "at most 0.12 % of the box diagonal from the mesh,
/// least angle 11 degrees, no flipped leaves".
std::string in_words(const FitQuality& quality);

}  // namespace interleaf
