// What is measured of a key, once, for its levels of detail.
//
// A refinement for a view reads bisections in any order, mostly those with large errors, and neighbors together.
// Memory decides its speed. So bisections are sorted by the powers of two of their errors, and among these by
// their place on the surface, and everything about a bisection is in one place.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/detail/detail_levels.h"
#include "hierarchy/detail/deviation.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// A bisected node. Places are indices in KeyDetail::bisections.
struct DetailBisection {
    Index midpoint = no_index;  ///< vertex of the key
    Index partner = no_index;   ///< the other bisection with this midpoint; no_index on a boundary
    Index needed = no_index;    ///< a bisection whose midpoint must exist before; no_index below no bisection
    std::array<Index, 2> children = {no_index, no_index};  ///< the bisections of the children
    float deviation = 0;                                   ///< see deviation.h
    glm::vec3 position{0};                                 ///< of the midpoint
    glm::vec3 axis{0};                                     ///< of the cone around the normals below
    float sine = 2;  ///< of the cone's half angle; over 1 if the cone has directions over a right angle apart
};

struct KeyDetail {
    std::vector<DetailBisection> bisections{};
    std::vector<Index> roots{};         ///< by root triangle: its bisection; no_index for a leaf
    std::vector<float> errors{};        ///< vertex_errors(), by vertex of the key
    std::vector<DetailLevel> levels{};  ///< detail_levels()

    std::size_t byte_count() const;
};

/// \pre  the hierarchy passes check()
KeyDetail measure_detail(const Hierarchy& hierarchy, const DetailProgress& progress = {});

}  // namespace interleaf
