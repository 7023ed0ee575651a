// Random root complexes without a regular structure: surfaces of given genus, glued from pieces, with edges
// flipped and triangles cut out at random. Also renumbers a complex or a key.
#pragma once

#include <vector>

#include "hierarchy/random_families.h"

namespace interleaf::testing {

/// The connected sum: cuts triangle \p t out of \p a and triangle \p u out of \p b, and glues their edges.
RootComplex connected_sum(const RootComplex& a, Index t, const RootComplex& b, Index u);

/// Flips up to \p count edges, as long as the result is a simplicial complex.
RootComplex flipped_at_random(RootComplex roots, std::size_t count, Random& random);

/// A connected surface of \p genus 0 to 3, made of plates, tori, octahedra and tetrahedra, with edges
/// flipped, and with triangles cut out if \p open. Marked at random.
RootComplex random_surface(unsigned genus, bool open, Random& random);

/// A key over \p roots with bisections, even if there are very many roots.
Hierarchy bisected_key(const RootComplex& roots, Random& random);

/// The complex with the orientation of all triangles reversed, and with the same refinement edges.
RootComplex mirrored(const RootComplex& roots);

/// A renumbering: vertex v becomes vertex vertices[v], root r becomes root roots[r].
struct Renumbering {
    std::vector<Index> vertices;
    std::vector<Index> roots;
};

Renumbering random_renumbering(const RootComplex& roots, Random& random);

RootComplex renumbered(const RootComplex& roots, const Renumbering& renumbering);

/// The same surface over renumbered roots, computed from its leaves.
Hierarchy renumbered(const Hierarchy& key, const Renumbering& renumbering);

}  // namespace interleaf::testing
