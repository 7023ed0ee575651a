// A fitted key beside the mesh it was fitted to: how far they are from each other, vertex for vertex.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "family/family.h"
#include "fit/fit.h"
#include "fit/mesh/progress.h"

namespace interleaf {

/// Distances are in percent of the diagonal of the mesh's box.
struct FitComparison {
    std::string mesh_name;  ///< of its file
    SharedHierarchy key;
    std::vector<Triangle> triangles;  ///< of the mesh, once clean
    std::vector<glm::vec3> positions;
    std::vector<float> mesh_distances;  ///< of each vertex of the mesh from the key

    /// For each vertex of the key the largest distance from the mesh there and in the middles of the leaves
    /// about it and of their edges: the vertices themselves lie on the mesh.
    std::vector<float> key_distances;

    FitQuality quality;
};

/// \throw Cancelled when \p progress says so
FitComparison compare(std::string mesh_name, FittedKey fitted, const Progress& progress = {});

/// The largest of all distances.
float max_distance(const FitComparison& comparison);

using Comparisons = std::vector<std::shared_ptr<const FitComparison>>;

/// A key of a family that has a comparison.
struct ComparedKey {
    std::size_t key;  ///< index in the family
    std::shared_ptr<const FitComparison> comparison;
};

/// The keys of \p family, in their order, that \p comparisons are about: those with the same hierarchies in
/// memory, whatever they are called.
std::vector<ComparedKey> compared_keys(const Family& family, const Comparisons& comparisons);

/// How near \p comparison's key is, in a sentence without its end: "at most 0.12 % of the box diagonal from
/// the mesh, least angle 11 degrees, no flipped leaves".
std::string in_words(const FitQuality& quality);

}  // namespace interleaf
