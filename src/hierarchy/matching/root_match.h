// Matching the roots of a key with those of another (paper, section 3.2, constraints (B), 1 and 2), or saying
// where they differ. root_isomorphism.h has the search itself.
#pragma once

#include <array>
#include <string>
#include <string_view>
#include <variant>

#include "hierarchy/matching/root_isomorphism.h"

namespace interleaf {

/// Why the roots of a key do not match those of the reference, and where, in the key's own numbering. What is
/// not at one root, edge or vertex has none.
struct RootMismatch {
    enum class Kind {
        counts,           ///< they differ in triangles, vertices, boundary edges or components
        mirrored,         ///< they match with the orientation reversed
        refinement_edge,  ///< they match, but for the refinement edge `edge` of `root`, and maybe others
        boundary,         ///< `edge` or its counterpart is on the boundary, and the other is not
        surroundings,     ///< `vertex` has other triangles around it than its counterpart
        neighbour,        ///< across `edge` lies another triangle than across its counterpart
        given,            ///< the same, by the given permutation
        no_counterpart,   ///< no root of the reference is like `root`
        components,       ///< single components match, but not all, one for one
        undecided,        ///< too large and too symmetric to be searched through
    };
    using Edge = std::array<Index, 2>;

    Kind kind = Kind::counts;
    Index root = no_index;
    Edge edge = {no_index, no_index};
    Index vertex = no_index;
    Index reference_root = no_index;  ///< the counterparts of the three above
    Edge reference_edge = {no_index, no_index};
    Index reference_vertex = no_index;
    std::string figures;  ///< where they differ in some, in words: the key's, then the reference's
};

/// Matches the roots of \p key with those of \p reference.
/// \throw InputError if they are more than a third of 2^32
/// \pre   a given permutation is one, of the reference's roots, if both complexes have as many triangles
std::variant<RootMatch, RootMismatch> match_roots(const PlacedComplex& reference, const PlacedComplex& key,
                                                  const RootMatchOptions& options = {});

/// The mismatch in words, for a key called \p key and a reference called \p reference: "key star: root 12:
/// its refinement edge (3, 7) corresponds to edge (4, 9) of key sphere's root 5, which is not its refinement
/// edge".
std::string text_of(const RootMismatch& mismatch, std::string_view key, std::string_view reference);

}  // namespace interleaf
