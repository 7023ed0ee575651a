#include "hierarchy/matching/root_match.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include <fmt/core.h>

namespace interleaf {

namespace {

using Kind = RootMismatch::Kind;

/// The limit of steps for finding the place where two complexes differ.
constexpr std::uint64_t max_explaining_steps = std::uint64_t{1} << 24;

RootMismatch::Edge ends_of(const RootGluing& gluing, Index side) {
    return {gluing.apex(turned(side, 1)), gluing.apex(turned(side, 2))};
}

/// The triangles around a vertex in words: "6 triangles around it, on the boundary".
std::string figures_of(Index surroundings) {
    return fmt::format("{} triangles around it{}", surroundings / 2,
                       (surroundings & 1) != 0 ? ", on the boundary" : "");
}

/// The mismatch at the pair of sides where an image ended.
RootMismatch mismatch_at(const ImageEnd& end, const RootGluing& reference, const RootGluing& key) {
    RootMismatch mismatch;
    mismatch.root = end.image_side / 3;
    mismatch.reference_root = end.side / 3;
    mismatch.edge = ends_of(key, end.image_side);
    mismatch.reference_edge = ends_of(reference, end.side);
    switch (end.kind) {
        case ImageEnd::Kind::boundary:
            mismatch.kind = Kind::boundary;
            mismatch.figures = key.across[end.image_side] == no_index
                                   ? "is on the boundary, the second is not"
                                   : "is not on the boundary, the second is";
            break;
        case ImageEnd::Kind::surroundings:
            mismatch.kind = Kind::surroundings;
            mismatch.vertex = key.apex(end.image_side);
            mismatch.reference_vertex = reference.apex(end.side);
            mismatch.edge = mismatch.reference_edge = {no_index, no_index};
            mismatch.figures =
                fmt::format("has {}, the second has {}", figures_of(key.surroundings[mismatch.vertex]),
                            figures_of(reference.surroundings[mismatch.reference_vertex]));
            break;
        case ImageEnd::Kind::given:
            mismatch.kind = Kind::given;
            break;
        default:
            mismatch.kind = Kind::neighbor;
            break;
    }
    return mismatch;
}

std::string figures_of(const RootComplex& roots, const RootGluing& gluing) {
    return fmt::format("{} root triangles, {} root vertices, {} boundary edges, {} component{}",
                       roots.triangle_count(), roots.vertex_count(), roots.boundary_edge_count(),
                       gluing.component_count(), gluing.component_count() == 1 ? "" : "s");
}

/// The first root whose refinement edge corresponds to another edge under \p match, which was found without
/// regard to refinement edges.
RootMismatch first_wrong_refinement_edge(const RootMatch& match, const RootGluing& reference,
                                         const RootGluing& key) {
    std::vector<Index> reference_root(match.roots.size());
    for (Index r = 0; r < match.roots.size(); ++r) reference_root[match.roots[r]] = r;
    for (Index root = 0; root < match.roots.size(); ++root) {
        const Triangle& triangle = reference.triangles[reference_root[root]];
        Index k = 0;
        while (match.vertices[triangle[k]] != key.triangles[root][0]) ++k;
        if (k == 0) continue;
        RootMismatch mismatch;
        mismatch.kind = Kind::refinement_edge;
        mismatch.root = root;
        mismatch.reference_root = reference_root[root];
        mismatch.edge = ends_of(key, 3 * root);
        mismatch.reference_edge = ends_of(reference, 3 * reference_root[root] + k);
        return mismatch;
    }
    return {};
}

/// The complex with the orientation of all triangles reversed, and with the same refinement edges.
RootComplex mirrored(const RootComplex& roots) {
    std::vector<Triangle> triangles(roots.triangles().begin(), roots.triangles().end());
    for (Triangle& triangle : triangles) std::swap(triangle[1], triangle[2]);
    return {roots.vertex_count(), std::move(triangles)};
}

/// Finds where two complexes with the same counts are glued differently.
class Difference {
  public:
    Difference(const PlacedComplex& reference, const PlacedComplex& key, const RootGluing& reference_gluing,
               const RootGluing& key_gluing)
        : reference_{&reference_gluing, reference.positions},
          key_{&key_gluing, key.positions},
          images_(reference_gluing.triangles.size()),
          walker_(reference_gluing) {}

    /// The mismatch where an image of a component got farthest, for the first component of the reference that
    /// the key does not have. The image begins where the complexes look the same up to the largest possible
    /// radius. So the mismatch is a local difference, without many others around it.
    RootMismatch find() {
        const RootGluing& gluing = *reference_.gluing;
        std::vector<bool> is_done(gluing.component_count());
        for (const unsigned radius : {8U, 4U, 2U, 1U, 0U}) {
            look(radius);
            for (Index c = 0; c < gluing.component_count() && steps_left_ > 0; ++c) {
                if (is_done[c]) continue;
                const Index seed = shared_seed(c);
                if (seed == no_index) continue;
                is_done[c] = true;
                const ImageEnd end = farthest_image(seed);
                if (end.kind != ImageEnd::Kind::complete) return mismatch_at(end, gluing, *key_.gluing);
            }
        }
        RootMismatch mismatch;
        mismatch.kind = std::find(is_done.begin(), is_done.end(), false) == is_done.end()
                            ? Kind::components
                            : Kind::no_counterpart;
        return mismatch;
    }

  private:
    void look(unsigned radius) {
        signature_ = signatures(*reference_.gluing, false, radius);
        const std::vector<std::uint64_t> theirs = signatures(*key_.gluing, false, radius);
        sides_.clear();
        for (Index side = 0; side < theirs.size(); ++side) sides_.emplace_back(theirs[side], side);
        std::sort(sides_.begin(), sides_.end());
    }

    /// The key's sides with the same signature as side 0 of \p triangle.
    std::span<const std::pair<std::uint64_t, Index>> alike(Index triangle) const {
        const Index side = 3 * triangle;
        const std::uint64_t signature = signature_[side];
        const auto begin = std::lower_bound(sides_.begin(), sides_.end(), std::pair(signature, Index{0}));
        const auto end = std::upper_bound(begin, sides_.end(), std::pair(signature, no_index));
        return {begin, end};
    }

    /// The triangle of a component whose side 0 has the same signature as the fewest sides of the key, but at
    /// least one; no_index if there is none.
    Index shared_seed(Index component) const {
        Index seed = no_index;
        std::size_t fewest = sides_.size() + 1;
        for (const Index t : reference_.gluing->component(component)) {
            const std::size_t count = alike(t).size();
            if (count == 0 || count >= fewest) continue;
            fewest = count;
            seed = t;
        }
        return seed;
    }

    ImageEnd farthest_image(Index seed) {
        const RootWalk walk = walker_.walk_from(seed);
        ImageEnd farthest;
        for (const auto& [signature, side] : alike(seed)) {
            const ImageEnd end = images_.spread(walk, reference_, key_, side, {.marked = false});
            if (end.kind == ImageEnd::Kind::complete) return end;
            if (end.step_count > farthest.step_count) farthest = end;
            steps_left_ -= std::min<std::uint64_t>(steps_left_, end.step_count);
            if (steps_left_ == 0) break;
        }
        return farthest;
    }

    PlacedRoots reference_, key_;
    RootImages images_;
    RootWalker walker_;
    std::vector<std::uint64_t> signature_;                ///< of the reference, by side
    std::vector<std::pair<std::uint64_t, Index>> sides_;  ///< of the key, by signature
    std::uint64_t steps_left_ = max_explaining_steps;
};

/// Why there is no match between complexes with the same counts.
RootMismatch explanation(const PlacedComplex& reference, const PlacedComplex& key, RootMatchOptions options,
                         const RootGluing& reference_gluing, const RootGluing& key_gluing) {
    const bool needs_marks = options.marked;
    options.marked = false;
    if (needs_marks) {
        const IsomorphismSearch unmarked = find_isomorphism(reference, key, options);
        if (unmarked.match) return first_wrong_refinement_edge(*unmarked.match, reference_gluing, key_gluing);
        if (unmarked.end) return mismatch_at(*unmarked.end, reference_gluing, key_gluing);
    }
    const RootComplex turned_over = mirrored(key.roots);
    RootMismatch mismatch;
    if (find_isomorphism(reference, {turned_over, key.positions}, options).match) {
        mismatch.kind = Kind::mirrored;
        return mismatch;
    }
    return Difference(reference, key, reference_gluing, key_gluing).find();
}

}  // namespace

std::variant<RootMatch, RootMismatch> match_roots(const PlacedComplex& reference, const PlacedComplex& key,
                                                  const RootMatchOptions& options) {
    const RootGluing reference_gluing = gluing_of(reference.roots), key_gluing = gluing_of(key.roots);
    const std::string expected = figures_of(reference.roots, reference_gluing);
    RootMismatch mismatch;
    mismatch.figures = figures_of(key.roots, key_gluing);
    if (mismatch.figures != expected) {
        mismatch.figures += ", expected " + expected;
        return mismatch;
    }
    IsomorphismSearch search = find_isomorphism(reference, key, options);
    if (search.match) return *std::move(search.match);
    if (search.undecided) {
        mismatch.kind = Kind::undecided;
        return mismatch;
    }
    if (search.end && search.end->kind != ImageEnd::Kind::refinement_edge)
        return mismatch_at(*search.end, reference_gluing, key_gluing);
    return explanation(reference, key, options, reference_gluing, key_gluing);
}

std::string text_of(const RootMismatch& mismatch, std::string_view key, std::string_view reference) {
    const auto edge = [](const RootMismatch::Edge& ends) {
        return fmt::format("({}, {})", ends[0], ends[1]);
    };
    const std::string at_root = fmt::format("key {}: root {}: ", key, mismatch.root);
    const std::string counterpart = fmt::format("edge {} of key {}'s root {}", edge(mismatch.reference_edge),
                                                reference, mismatch.reference_root);
    switch (mismatch.kind) {
        case Kind::counts:
            return fmt::format("key {}: {} as key {} has", key, mismatch.figures, reference);
        case Kind::mirrored:
            return fmt::format(
                "key {}: its roots match those of key {} only after its orientation is reversed: all its "
                "triangles have the opposite orientation",
                key, reference);
        case Kind::refinement_edge:
            return fmt::format("{}its refinement edge {} corresponds to {}, which is not its refinement edge",
                               at_root, edge(mismatch.edge), counterpart);
        case Kind::boundary:
            return fmt::format("{}edge {} corresponds to {}; the first {}", at_root, edge(mismatch.edge),
                               counterpart, mismatch.figures);
        case Kind::surroundings:
            return fmt::format("{}vertex {} corresponds to vertex {} of key {}; the first {}", at_root,
                               mismatch.vertex, mismatch.reference_vertex, reference, mismatch.figures);
        case Kind::neighbor:
            return fmt::format(
                "{}edge {} corresponds to {}, but the roots across these edges do not correspond", at_root,
                edge(mismatch.edge), counterpart);
        case Kind::given:
            return fmt::format(
                "{}edge {} corresponds to {} by the given roots, but the roots across these edges do not",
                at_root, edge(mismatch.edge), counterpart);
        case Kind::no_counterpart:
            return fmt::format(
                "key {}: none of its roots has the same numbers of triangles around its vertices as the "
                "roots of a component of key {}",
                key, reference);
        case Kind::components:
            return fmt::format("key {}: its components do not match those of key {} one to one", key,
                               reference);
        case Kind::undecided:
            return fmt::format(
                "key {}: no match with the roots of key {} was found in reasonable time, because the roots "
                "are "
                "too many and too symmetric; specify the match as \"roots\" in family.json",
                key, reference);
    }
    return {};
}

}  // namespace interleaf
