// The overlay of red-green keys: the coarsest conforming mesh on which each key is linear in every triangle.
// It is to red-green keys what the union (src/hierarchy/union_mesh.h) is to bisected keys.
//
// The green lines of the keys divide the leaves of the union of the red forests. Each line is a median of the
// leaf: the line of a key that has the same leaf, or the line of a larger leaf, which passes through the red
// triangles inside along their medians. So each key divides a leaf at most once. Several keys leave a leaf
// undivided, halve it, or divide it by two or three medians that cross in the centroid.
//
// The centroid is no vertex of any red-green mesh over these roots: their vertices have dyadic barycentric
// coordinates, but the centroid has thirds. Another red split does not help: the two medians cross again in
// the middle child. So the overlay is not a red-green hierarchy, and no red-green hierarchy represents the
// keys.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "key_over_node.h"
#include <glm/vec3.hpp>

namespace interleaf::bench {

/// How the green lines of the keys divide a leaf of the united red forest.
enum class LeafKind {
    plain,     ///< no line
    green,     ///< halved by a line, and all keys with the line have the leaf as a leaf, as in a single key
    across,    ///< halved by a line of a larger leaf, which another key splits
    crossing,  ///< two lines, five triangles
    triple,    ///< three lines, six triangles
};
inline constexpr std::size_t leaf_kind_count = 5;

struct OverlayLeaf {
    Index node;  ///< in the red complex
    LeafKind kind;
    Triangle corners;  ///< vertices of the overlay
    Triangle middles;  ///< at the end of each median that is a line; no_index otherwise
    Index centroid;    ///< no_index unless lines cross
};

/// The triangles of \p leaf: 1, 2, 5 or 6.
std::vector<Triangle> triangles_of(const OverlayLeaf& leaf);

struct Overlay {
    RedForest forest;  ///< the union of the red forests
    std::vector<OverlayLeaf> leaves;
    std::vector<std::vector<glm::dvec3>> positions;  ///< positions[key][vertex]
    std::size_t vertices_of_no_key = 0;

    std::size_t vertex_count() const { return positions.front().size(); }
};

/// \pre  there is at least one key, and all are over one red complex
Overlay overlay(std::span<const RedGreenKey> keys);

std::vector<Triangle> triangles_of(const Overlay& overlay);

}  // namespace interleaf::bench
