// Synchronization: puts a key over the roots of another key (paper, section 3.2, constraints (B)), after
// root_match.h has found which roots correspond. The surface stays the same; only numbers change.
#pragma once

#include "hierarchy/hierarchy.h"
#include "hierarchy/matching/root_match.h"

namespace interleaf {

/// The root complex of \p key with the positions of its root vertices, as match_roots() expects it.
inline PlacedComplex placed_roots(const Hierarchy& key) {
    return {key.roots, key.positions};
}

/// \p key over the root complex \p roots: the trees are in the order of \p roots, and vertices are numbered
/// by first visit. A key without bisections also gets the marking of \p roots.
/// \pre  \p key passes check()
/// \pre  \p match comes from match_roots(roots, key), with a free marking only if \p key has no bisections
Hierarchy with_roots_of(const RootComplex& roots, const Hierarchy& key, const RootMatch& match);

/// \p roots with the refinement edges of their counterparts in \p key.
/// \pre  \p match comes from match_roots(roots, key), with a free marking
RootComplex with_marking_of(const RootComplex& roots, const RootComplex& key, const RootMatch& match);

}  // namespace interleaf
