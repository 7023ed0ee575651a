// The search for the isomorphism between two root complexes that moves the vertices least: one that keeps the
// orientation, and maps refinement edges to refinement edges unless the marking is free.
//
// An isomorphism of a connected complex is known by the image of one triangle (docs/theory.md), so a
// component of n triangles has at most n candidates, 3 n where the marking is free. Signatures leave few of
// them unless the complex is symmetric. Several components are matched as wholes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/matching/root_walk.h"
#include "hierarchy/root_complex.h"

namespace interleaf {

/// Which root of a key corresponds to which of the reference. Corresponding triples are the same but for
/// their rotation, and in that, too, where the marking was not free.
struct RootMatch {
    std::vector<Index> roots;     ///< root r of the reference is root roots[r] of the key
    std::vector<Index> vertices;  ///< likewise the root vertices
};

struct RootMatchOptions {
    /// Whether refinement edges must correspond. If not, any edge of a triangle may be its refinement edge.
    bool marked = true;

    /// By root of the reference the root of the key that corresponds to it, a permutation of all. Empty: they
    /// are found.
    std::span<const Index> given{};

    /// Triangles visited for the sake of a better match than the first. So all candidates are tried in a
    /// complex of up to sqrt(step_limit) triangles, and in a larger one that is not that symmetric; beyond
    /// the limit, those nearest at the seed are.
    std::uint64_t step_limit = std::uint64_t{1} << 24;
};

/// A root complex with one position a root vertex, or more, of which the first count.
struct PlacedComplex {
    const RootComplex& roots;
    std::span<const glm::vec3> positions;
};

struct IsomorphismSearch {
    std::optional<RootMatch> match;
    bool undecided = false;       ///< no match, but not all candidates could be tried
    std::optional<ImageEnd> end;  ///< where the given permutation fails, if it does
};

/// The isomorphism from \p reference to \p key with the least sum of squared distances of vertices; of equal
/// ones, up to rounding, that which maps the seed, the triangle of the rarest signature in its component, to
/// the lowest root. Components of one kind are assigned to each other at the least sum if they are up to 100
/// and not too large; otherwise each in turn takes the one left whose centre is nearest, as seen from the
/// centre of all. Deterministic. Takes time n log n and, for each candidate, at most n, mostly far less: it
/// is left where it fails or is farther than the best. \pre  the complexes have the same numbers of
/// triangles, vertices and components; `given` is a permutation
IsomorphismSearch find_isomorphism(const PlacedComplex& reference, const PlacedComplex& key,
                                   const RootMatchOptions& options);

}  // namespace interleaf
