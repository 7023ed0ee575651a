// Synchronising the keys of a family: all are put over the roots of the first (paper, section 3.2,
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

/// A key that could not be put over the roots of the first, and why; `mismatch` in the numbers of both keys.
struct KeyMismatch {
    std::size_t key;
    RootMismatch mismatch;
    std::string text;  ///< the mismatch in words, with the keys' names
};

struct Synchronisation {
    std::vector<std::string> changes;  ///< one sentence for each key that was changed
    std::vector<KeyMismatch> mismatches;
};

/// A key that could not be put over the roots of another, for showing where.
struct MismatchedKeys {
    Key key;
    Key reference;  ///< the first of its family
    RootMismatch mismatch;
};

/// Keys do not match: what() says it in words, `keys` has the first of them.
struct MismatchError : InputError {
    /// \pre  \p family are the keys among which \p mismatch was found
    MismatchError(const std::string& text, std::span<const Key> family, const KeyMismatch& mismatch);

    std::shared_ptr<const MismatchedKeys> keys;  ///< not null
};

/// Puts every key over the roots of the first, whose numbering stays. Keys that have these roots already stay
/// as they are, unless \p given says otherwise.
///
/// Refinement edges must correspond, but a key in which nothing is bisected has no say in them: it takes
/// those of the others. So if nothing is bisected in the first key, the marking of the family is that of the
/// first key with bisections.
///
/// \param given  by key a permutation, root r of the first key being root given[key][r] of this one; where it
///               is empty, or where there is none for a key, the match is found (root_isomorphism.h). That of
///               the first key is empty
/// \pre keys pass check(); permutations are permutations of their key's roots
Synchronisation synchronise(std::span<Key> keys, std::span<const std::vector<Index>> given = {});

}  // namespace interleaf
