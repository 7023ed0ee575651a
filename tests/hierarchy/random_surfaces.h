// Random root complexes without a plan: surfaces of given genus, put together from pieces, with edges flipped
// and triangles cut out at random. And the same complex, or key, in another numbering.
#pragma once

#include <vector>

#include "hierarchy/random_families.h"

namespace interleaf::testing {

/// The connected sum: triangle \p t of \p a and triangle \p u of \p b are cut out and their edges put
/// together.
RootComplex connected_sum(const RootComplex& a, Index t, const RootComplex& b, Index u);

/// Up to \p count edges flipped, where what comes out is a simplicial complex.
RootComplex flipped_at_random(RootComplex roots, std::size_t count, Random& random);

/// A connected surface of \p genus 0 to 3, made of plates, tori, octahedra and tetrahedra, edges flipped;
/// with triangles cut out if \p open. Marked at random.
RootComplex random_surface(unsigned genus, bool open, Random& random);

/// A key over \p roots that is bisected, however many they are.
Hierarchy bisected_key(const RootComplex& roots, Random& random);

/// The complex with all triangles run round the other way, refinement edges kept.
RootComplex mirrored(const RootComplex& roots);

/// A renumbering: what is vertex v, root r, becomes vertex vertices[v], root roots[r].
struct Renumbering {
    std::vector<Index> vertices;
    std::vector<Index> roots;
};

Renumbering random_renumbering(const RootComplex& roots, Random& random);

RootComplex renumbered(const RootComplex& roots, const Renumbering& renumbering);

/// The same surface over renumbered roots, by way of its leaves.
Hierarchy renumbered(const Hierarchy& key, const Renumbering& renumbering);

}  // namespace interleaf::testing
