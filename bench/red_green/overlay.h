// The overlay of red-green keys: the coarsest conforming mesh on which each of them is linear in every
// triangle. It is to red-green keys what the union (src/hierarchy/union_mesh.h) is to bisected ones.
//
// A leaf of the union of the red forests is divided by the green lines of the keys over it. Each is a median
// of the leaf: its own key's where the leaf is one, or the line of a larger leaf, which runs through the red
// triangles inside along their medians. So a key divides a leaf once at most, and several keys leave it as it
// is, or halve it, or divide it by two or three medians that cross in the centroid.
//
// The centroid is no vertex of any red-green mesh over these roots: all of those have dyadic barycentric
// coordinates, and it has thirds. Splitting red once more does not help: the two medians cross again in
// the middle child. So the overlay is not a red-green hierarchy, and no red-green hierarchy represents the
// keys.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "key_over_node.h"
#include <glm/vec3.hpp>

namespace interleaf::bench {

/// What the green lines of the keys do to a leaf of the united red forest.
enum class LeafKind {
    plain,     ///< no line
    green,     ///< halved by a line whose keys all have the leaf as a leaf: as in one key alone
    across,    ///< halved by a line that comes from a larger leaf, which another key splits
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

/// \pre the keys are over one red complex, and at least one
Overlay overlay(std::span<const RedGreenKey> keys);

std::vector<Triangle> triangles_of(const Overlay& overlay);

}  // namespace interleaf::bench
