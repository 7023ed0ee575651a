// Synchronizes the keys of a family: puts all keys over the roots of the first key (paper, section 3.2,
// constraints (B)).
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "family/family.h"
#include "hierarchy/error.h"
#include "hierarchy/matching/root_match.h"

namespace interleaf {

/// A key that cannot be put over the roots of the first key, and the reason. `mismatch` uses the numbering of
/// both keys.
struct KeyMismatch {
    std::size_t key;
    RootMismatch mismatch;
    std::string text;  ///< the mismatch in words, with the keys' names
};

struct Synchronization {
    std::vector<std::string> changes;  ///< one sentence for each key that was changed
    std::vector<KeyMismatch> mismatches;
};

/// A key that cannot be put over the roots of another key; used to show where they differ.
struct MismatchedKeys {
    Key key;
    Key reference;  ///< the first key of its family
    RootMismatch mismatch;
};

/// Keys do not match: what() describes the first mismatch in words, `keys` has its keys.
struct MismatchError : InputError {
    /// \pre  \p mismatch was found among the keys \p family
    MismatchError(const std::string& text, std::span<const Key> family, const KeyMismatch& mismatch);

    std::shared_ptr<const MismatchedKeys> keys;  ///< not null
};

/// Puts every key over the roots of the first key, which keeps its numbering. Keys that already have these
/// roots stay unchanged, unless \p given says otherwise.
///
/// Refinement edges must correspond, but a key without bisections imposes none: it takes those of the other
/// keys. So if the first key has no bisections, the family gets the marking of the first key with bisections.
/// \param given  for each key, a permutation: root r of the first key corresponds to root given[key][r] of
///     this key. If the permutation is empty or missing, the match is searched for (root_isomorphism.h). The
///     first key's permutation is empty.
/// \pre  keys pass check(); each permutation is a permutation of its key's roots
Synchronization synchronize(std::span<Key> keys, std::span<const std::vector<Index>> given = {});

}  // namespace interleaf
