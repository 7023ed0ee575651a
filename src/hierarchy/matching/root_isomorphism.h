// The search for the isomorphism between two root complexes that moves the vertices least. The isomorphism
// keeps the orientation, and maps refinement edges to refinement edges unless the marking is free.
//
// An isomorphism of a connected complex is determined by the image of one triangle (docs/theory.md). So a
// component of n triangles has at most n candidates, or 3 n if the marking is free. Signatures exclude most
// of them unless the complex is symmetric. Several components are matched as wholes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/matching/root_walk.h"
#include "hierarchy/root_complex.h"

namespace interleaf {

/// Which root of a key corresponds to which root of the reference. Corresponding triples are equal up to
/// rotation, and exactly equal if the marking was not free.
struct RootMatch {
    std::vector<Index> roots;     ///< root r of the reference is root roots[r] of the key
    std::vector<Index> vertices;  ///< likewise for the root vertices
};

struct RootMatchOptions {
    /// Whether refinement edges must correspond. If not, any edge of a triangle may be its refinement edge.
    bool marked = true;

    /// The corresponding root of the key for each root of the reference: a permutation of all roots. If
    /// empty, the search finds it.
    std::span<const Index> given{};

    /// The maximum number of triangles visited in search of a better match than the first. So the search
    /// tries all candidates in a complex of up to sqrt(step_limit) triangles, and in larger complexes that
    /// are less symmetric. Beyond the limit, it tries the candidates whose seed is nearest.
    std::uint64_t step_limit = std::uint64_t{1} << 24;
};

/// A root complex with one position per root vertex. Further positions are ignored.
struct PlacedComplex {
    const RootComplex& roots;
    std::span<const glm::vec3> positions;
};

struct IsomorphismSearch {
    std::optional<RootMatch> match;
    bool undecided = false;       ///< no match, but not all candidates could be tried
    std::optional<ImageEnd> end;  ///< where the given permutation fails, if it does
};

/// The isomorphism from \p reference to \p key with the minimum sum of squared distances between vertices. If
/// several have the same sum up to rounding, the result is the one that maps the seed to the lowest root; the
/// seed is the triangle with the rarest signature in its component.
///
/// Components of one kind are assigned to each other at the minimum sum if they are at most 100 and not too
/// large. Otherwise each component in turn takes the remaining one with the nearest center, relative to the
/// center of all.
///
/// The search is deterministic. It takes time n log n, plus at most n per candidate. A candidate usually
/// takes far less: the search drops it as soon as it fails or exceeds the best distance.
/// \pre  the complexes have the same numbers of triangles, vertices and components; `given` is a permutation
IsomorphismSearch find_isomorphism(const PlacedComplex& reference, const PlacedComplex& key,
                                   const RootMatchOptions& options);

}  // namespace interleaf
