// Synchronising: a key is put over the roots of another (paper, section 3.2, constraints (B)), once
// root_match.h has found which roots correspond. The surface stays as it is; only numbers change.
#pragma once

#include "hierarchy/hierarchy.h"
#include "hierarchy/matching/root_match.h"

namespace interleaf {

/// The root complex of \p key with the positions of its root vertices, as match_roots() takes it.
inline PlacedComplex placed_roots(const Hierarchy& key) {
    return {key.roots, key.positions};
}

/// \p key over the root complex \p roots: the trees of its roots in the order of \p roots, vertices numbered
/// by first visit. A key that is not bisected gets the marking of \p roots, too.
/// \pre  \p key passes check(); \p match comes from match_roots(roots, key), its marking free only if nothing
///       is bisected in \p key
Hierarchy with_roots_of(const RootComplex& roots, const Hierarchy& key, const RootMatch& match);

/// \p roots with the refinement edges that its counterparts in \p key have.
/// \pre  \p match comes from match_roots(roots, key), its marking free
RootComplex with_marking_of(const RootComplex& roots, const RootComplex& key, const RootMatch& match);

}  // namespace interleaf
