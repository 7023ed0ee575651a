// Matches the roots of a key with those of another key (paper, section 3.2, constraints (B), 1 and 2), or
// says where they differ. The search itself is in root_isomorphism.h.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "hierarchy/matching/root_isomorphism.h"

namespace interleaf {

/// Why the roots of a key do not match those of the reference, and where, in the key's own numbering. The
/// indices stay unset if the mismatch is not at one root, edge or vertex.
struct RootMismatch {
    enum class Kind {
        counts,    ///< the numbers of triangles, vertices, boundary edges or components differ
        mirrored,  ///< they match with the orientation reversed
        /// They match, except for the refinement edge `edge` of `root`, and possibly others.
        refinement_edge,
        boundary,        ///< exactly one of `edge` and its counterpart is on the boundary
        surroundings,    ///< the triangles around `vertex` and around its counterpart differ
        neighbor,        ///< the triangle across `edge` does not correspond to the one across its counterpart
        given,           ///< as `neighbor`, by the given permutation
        no_counterpart,  ///< no root of the reference looks like `root`
        components,      ///< single components match, but not all of them one to one
        undecided,       ///< too large and too symmetric for a complete search
    };
    using Edge = std::array<Index, 2>;

    Kind kind = Kind::counts;
    Index root = no_index;
    Edge edge = {no_index, no_index};
    Index vertex = no_index;
    Index reference_root = no_index;  ///< the counterparts of the three above
    Edge reference_edge = {no_index, no_index};
    Index reference_vertex = no_index;
    std::string figures;  ///< in words, how the two differ: first the key's numbers, then the reference's
};

/// Matches the roots of \p key with those of \p reference.
/// \throw InputError if the roots have more than 2^32 sides
/// \pre  if the complexes have equally many triangles, a given permutation is a permutation of the
///     reference's roots
std::variant<RootMatch, RootMismatch> match_roots(const PlacedComplex& reference, const PlacedComplex& key,
                                                  const RootMatchOptions& options = {});

/// The mismatch in words, for a key called \p key and a reference called \p reference: "key star: root 12:
/// its refinement edge (3, 7) corresponds to edge (4, 9) of key sphere's root 5, which is not its refinement
/// edge".
std::string text_of(const RootMismatch& mismatch, std::string_view key, std::string_view reference);

}  // namespace interleaf
