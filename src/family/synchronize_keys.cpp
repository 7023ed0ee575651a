#include "family/synchronize_keys.h"

#include <algorithm>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "hierarchy/matching/synchronize.h"

namespace interleaf {

namespace {

bool is_bisected(const Key& key) {
    return !key.hierarchy->midpoints.empty();
}

class Synchronizer {
  public:
    Synchronizer(std::span<Key> keys, std::span<const std::vector<Index>> given)
        : keys_(keys), given_(given) {}

    Synchronization run() {
        mark_first();
        for (std::size_t key = 1; key < keys_.size(); ++key) synchronize(key);
        return std::move(result_);
    }

  private:
    const Hierarchy& first() const { return *keys_.front().hierarchy; }

    std::span<const Index> given(std::size_t key) const {
        return key < given_.size() ? std::span<const Index>(given_[key]) : std::span<const Index>();
    }

    std::variant<RootMatch, RootMismatch> match(std::size_t key, bool marked) const {
        return match_roots(placed_roots(first()), placed_roots(*keys_[key].hierarchy),
                           {.marked = marked, .given = given(key)});
    }

    /// If the first key has no bisections, gives it the refinement edges of the first key with bisections.
    void mark_first() {
        if (is_bisected(keys_.front())) return;
        const auto marking = std::find_if(keys_.begin(), keys_.end(), is_bisected);
        if (marking == keys_.end()) return;
        const auto key = static_cast<std::size_t>(marking - keys_.begin());
        if (marking->hierarchy->roots == first().roots && given(key).empty()) return;
        const auto found = match(key, false);
        const auto* const correspondence = std::get_if<RootMatch>(&found);
        if (correspondence == nullptr) return;  // synchronize() will report why
        const RootComplex roots = with_marking_of(first().roots, marking->hierarchy->roots, *correspondence);
        if (roots == first().roots) return;
        Hierarchy marked = first();
        marked.roots = roots;
        keys_.front().hierarchy = std::move(marked);
        marked_as_ = marking->name;
        result_.changes.push_back(
            fmt::format("key {}: it has no bisections, so its roots took the refinement edges of key {}",
                        keys_.front().name, marking->name));
    }

    void synchronize(std::size_t key) {
        if (keys_[key].hierarchy->roots == first().roots && given(key).empty()) return;
        const auto found = match(key, is_bisected(keys_[key]));
        if (const auto* const mismatch = std::get_if<RootMismatch>(&found)) {
            result_.mismatches.push_back({key, *mismatch, text(key, *mismatch)});
            return;
        }
        const RootMatch& correspondence = std::get<RootMatch>(found);
        if (const std::string change = change_of(key, correspondence); !change.empty())
            result_.changes.push_back(change);
        keys_[key].hierarchy = with_roots_of(first().roots, *keys_[key].hierarchy, correspondence);
    }

    std::string change_of(std::size_t key, const RootMatch& match) const {
        const auto triangles = keys_[key].hierarchy->roots.triangles();
        const bool is_renumbered =
            !std::ranges::is_sorted(match.roots) || !std::ranges::is_sorted(match.vertices);
        std::size_t remarked = 0;
        for (std::size_t r = 0; r < triangles.size(); ++r)
            if (match.vertices[first().roots.triangles()[r][0]] != triangles[match.roots[r]][0]) ++remarked;
        std::string change;
        if (is_renumbered)
            change = fmt::format("its roots were renumbered to match key {}{}", keys_.front().name,
                                 given(key).empty() ? "" : ", by the given permutation");
        if (remarked > 0)
            change += fmt::format("{}it has no bisections, so {} of its {} roots took other refinement edges",
                                  is_renumbered ? "; " : "", remarked, triangles.size());
        return change.empty() ? change : fmt::format("key {}: {}", keys_[key].name, change);
    }

    std::string text(std::size_t key, const RootMismatch& mismatch) const {
        std::string text = text_of(mismatch, keys_[key].name, keys_.front().name);
        if (mismatch.kind != RootMismatch::Kind::refinement_edge) return text;
        // This key has bisections: otherwise it would have been marked anew.
        return text + (marked_as_.empty() ? "; both keys have bisections, so neither can be marked anew"
                                          : fmt::format("; its roots are marked as those of key {}, and both "
                                                        "have bisections, so neither can be marked anew",
                                                        marked_as_));
    }

    std::span<Key> keys_;
    std::span<const std::vector<Index>> given_;
    std::string marked_as_;  ///< the key whose refinement edges the first key took
    Synchronization result_;
};

}  // namespace

MismatchError::MismatchError(const std::string& text, std::span<const Key> family,
                             const KeyMismatch& mismatch)
    : InputError(text),
      keys(std::make_shared<const MismatchedKeys>(
          MismatchedKeys{family[mismatch.key], family.front(), mismatch.mismatch})) {}

Synchronization synchronize(std::span<Key> keys, std::span<const std::vector<Index>> given) {
    return Synchronizer(keys, given).run();
}

}  // namespace interleaf
