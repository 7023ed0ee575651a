#include "hierarchy/matching/root_isomorphism.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "hierarchy/matching/assignment.h"
#include "hierarchy/matching/point_tree.h"

namespace interleaf {

namespace {

/// The radius of signatures, in triangles. A larger radius would distinguish sides that differ only farther
/// away; a walk finds that as well.
constexpr unsigned signature_radius = 4;

/// The search finds the best assignment for at most this many components of one kind, and if it takes at most
/// this many steps, that is, triangles to visit.
constexpr std::size_t max_assigned = 100;
constexpr std::size_t max_assignment_steps = std::size_t{1} << 26;

/// Sums of squares count as equal if their relative difference is less than this.
constexpr double rounding = 1e-9;

constexpr double infinity = std::numeric_limits<double>::infinity();

double square(const glm::dvec3& v) {
    return v.x * v.x + v.y * v.y + v.z * v.z;
}

/// The mean of the vertices of each component.
std::vector<glm::dvec3> centers_of(const RootGluing& gluing, std::span<const glm::vec3> positions) {
    std::vector<glm::dvec3> centers;
    std::vector<bool> visited(gluing.surroundings.size());
    for (Index c = 0; c < gluing.component_count(); ++c) {
        glm::dvec3 sum(0);
        double count = 0;
        for (const Index t : gluing.component(c))
            for (const Index vertex : gluing.triangles[t]) {
                if (visited[vertex]) continue;
                visited[vertex] = true;
                sum += glm::dvec3(positions[vertex]);
                ++count;
            }
        centers.push_back(sum / count);
    }
    return centers;
}

/// One of the two complexes, with the data that the search needs.
struct Searched {
    Searched(const PlacedComplex& complex, bool marked)
        : gluing(gluing_of(complex.roots)),
          positions(complex.positions),
          signature(signatures(gluing, marked, signature_radius)),
          centers(centers_of(gluing, positions)) {}

    RootGluing gluing;
    std::span<const glm::vec3> positions;
    std::vector<std::uint64_t> signature;  ///< by side
    std::vector<glm::dvec3> centers;       ///< by component

    PlacedRoots placed() const { return {&gluing, positions}; }
};

/// The seed of a component: the triangle whose side 0 has the rarest signature in the component; the lowest
/// of several.
Index seed_of(const Searched& searched, Index component) {
    std::vector<std::pair<std::uint64_t, Index>> sides;
    sides.reserve(3 * searched.gluing.component(component).size());
    for (const Index t : searched.gluing.component(component))
        for (const Index side : {3 * t, 3 * t + 1, 3 * t + 2})
            sides.emplace_back(searched.signature[side], side);
    std::sort(sides.begin(), sides.end());

    std::pair<std::ptrdiff_t, Index> rarest = {std::numeric_limits<std::ptrdiff_t>::max(), no_index};
    for (auto begin = sides.begin(), end = begin; begin != sides.end(); begin = end) {
        end = std::find_if(begin, sides.end(), [&](const auto& side) { return side.first != begin->first; });
        const auto first = std::find_if(begin, end, [](const auto& side) { return side.second % 3 == 0; });
        if (first != end) rarest = std::min(rarest, std::pair(end - begin, first->second));
    }
    return rarest.second / 3;
}

/// Gives each of \p centers a partner among equally many \p others: each in turn takes the nearest of those
/// that remain. Both sets are shifted to a common mean.
std::vector<std::size_t> nearest_left(const std::vector<glm::dvec3>& centers,
                                      const std::vector<glm::dvec3>& others) {
    glm::dvec3 shift(0);
    for (std::size_t i = 0; i < centers.size(); ++i)
        shift += (others[i] - centers[i]) / static_cast<double>(centers.size());
    PointTree left(others);
    std::vector<std::size_t> partners;
    partners.reserve(centers.size());
    for (const glm::dvec3& center : centers) partners.push_back(left.take_nearest(center + shift));
    return partners;
}

enum class Wanted { any, closest };

class Search {
  public:
    Search(const PlacedComplex& reference, const PlacedComplex& key, const RootMatchOptions& options)
        : options_(options),
          reference_(reference, options.marked),
          key_(key, options.marked),
          images_(reference.roots.triangle_count()),
          walker_(reference_.gluing),
          steps_left_(4 * options.step_limit + 64 * std::uint64_t{reference.roots.triangle_count()}) {
        match_.roots.resize(reference.roots.triangle_count());
        match_.vertices.resize(reference.roots.vertex_count());
    }

    IsomorphismSearch run() {
        IsomorphismSearch result;
        if (options_.given.empty() ? match_components() : match_given(result))
            result.match = std::move(match_);
        result.undecided = undecided_;
        return result;
    }

  private:
    /// The image of a walk's seed, and the sum of squared distances between the walk's vertices and their
    /// images when the centers of the two components coincide.
    struct Image {
        Index side;
        double distance;
    };
    /// Isomorphic components, each with a walk from its seed.
    struct Kind {
        std::vector<Index> components;  ///< of the reference
        std::vector<RootWalk> walks;
        std::vector<Index> key_components;
    };

    bool match_given(IsomorphismSearch& result) {
        for (Index c = 0; c < reference_.gluing.component_count(); ++c) {
            const RootWalk walk = walker_.walk_from(reference_.gluing.component(c).front());
            const Index image = 3 * options_.given[walk.steps.front().triangle];
            std::optional<Image> best;
            ImageEnd farthest;
            for (Index side = image; side < image + (options_.marked ? 1 : 3); ++side) {
                const ImageEnd end = images_.spread(walk, reference_.placed(), key_.placed(), side,
                                                    {.marked = options_.marked, .given = options_.given});
                if (end.kind == ImageEnd::Kind::complete) {
                    keep_better(best, {side, end.distance});
                } else if (end.step_count >= farthest.step_count) {
                    farthest = end;
                }
            }
            if (!best) {
                result.end = farthest;
                return false;
            }
            take(walk, best->side);
        }
        return true;
    }

    bool match_components() {
        struct Group {
            std::vector<Index> ours, theirs;
        };
        std::map<std::pair<std::size_t, std::uint64_t>, Group> groups;  // by size and sum of signatures
        const auto group_of = [&](const Searched& searched, Index c) -> Group& {
            std::uint64_t sum = 0;
            for (const Index t : searched.gluing.component(c))
                for (const Index side : {3 * t, 3 * t + 1, 3 * t + 2}) sum += searched.signature[side];
            return groups[{searched.gluing.component(c).size(), sum}];
        };
        for (Index c = 0; c < reference_.gluing.component_count(); ++c)
            group_of(reference_, c).ours.push_back(c);
        for (Index c = 0; c < key_.gluing.component_count(); ++c) group_of(key_, c).theirs.push_back(c);
        for (const auto& [size, group] : groups)
            if (group.ours.size() != group.theirs.size()) return false;
        return std::all_of(groups.begin(), groups.end(), [this](const auto& entry) {
            return match_kinds(entry.second.ours, entry.second.theirs);
        });
    }

    /// Sorts components with equal signatures into kinds, and matches the components of each kind.
    bool match_kinds(std::span<const Index> ours, std::span<const Index> theirs) {
        std::vector<Kind> kinds;
        const auto kind_of = [&](const Searched& searched, Index c) {
            return std::find_if(kinds.begin(), kinds.end(), [&](const Kind& kind) {
                // then closest_image() is sufficient as a test
                return (ours.size() == 1 && &searched == &key_) ||
                       image_of(kind.walks.front(), kind.components.front(), searched, c, Wanted::any);
            });
        };
        for (const Index c : ours) {
            auto kind = kind_of(reference_, c);
            if (kind == kinds.end()) kind = kinds.emplace(kind);
            kind->components.push_back(c);
            kind->walks.push_back(walker_.walk_from(seed_of(reference_, c)));
        }
        for (const Index c : theirs) {
            const auto kind = kind_of(key_, c);
            if (kind == kinds.end()) return false;
            kind->key_components.push_back(c);
        }
        return std::all_of(kinds.begin(), kinds.end(), [this](const Kind& kind) {
            return kind.components.size() == kind.key_components.size() && match_kind(kind);
        });
    }

    bool match_kind(const Kind& kind) {
        const std::size_t count = kind.components.size();
        if (count > 1 && count <= max_assigned &&
            count * count * kind.walks.front().steps.size() <= max_assignment_steps)
            return assign(kind);

        std::vector<glm::dvec3> centers, key_centers;
        for (const Index c : kind.components) centers.push_back(reference_.centers[c]);
        for (const Index c : kind.key_components) key_centers.push_back(key_.centers[c]);
        const std::vector<std::size_t> partners = nearest_left(centers, key_centers);
        for (std::size_t i = 0; i < count; ++i) {
            const std::optional<Image> image = image_of(kind.walks[i], kind.components[i], key_,
                                                        kind.key_components[partners[i]], Wanted::closest);
            if (!image) return false;
            take(kind.walks[i], image->side);
        }
        return true;
    }

    bool assign(const Kind& kind) {
        const std::size_t count = kind.components.size();
        std::vector<Index> images;
        std::vector<double> costs;
        for (std::size_t i = 0; i < count; ++i)
            for (const Index key_component : kind.key_components) {
                const Index component = kind.components[i];
                const std::optional<Image> image =
                    image_of(kind.walks[i], component, key_, key_component, Wanted::closest, count);
                if (!image) return false;
                images.push_back(image->side);
                costs.push_back(image->distance +
                                static_cast<double>(kind.walks[i].vertex_count) *
                                    square(key_.centers[key_component] - reference_.centers[component]));
            }
        const std::vector<std::size_t> partners = assignment(count, costs);
        for (std::size_t i = 0; i < count; ++i) take(kind.walks[i], images[i * count + partners[i]]);
        return true;
    }

    /// The closest image of \p walk, or any image, if \p wanted says so. The walk goes over component \p
    /// component of the reference, its image over component \p other of \p target. None if there is no image,
    /// or if none was found within the step limit.
    std::optional<Image> image_of(const RootWalk& walk, Index component, const Searched& target, Index other,
                                  Wanted wanted, std::size_t parts = 1) {
        std::uint64_t allowed = allowed_steps(walk.steps.size(), parts);
        std::optional<Image> best;
        ImageRules rules{.marked = options_.marked,
                         .shift = reference_.centers[component] - target.centers[other],
                         .max_distance = infinity};
        for (const Index side : candidates(walk.steps.front().triangle, target, other, rules.shift)) {
            if (allowed == 0) {
                undecided_ = undecided_ || !best;
                break;
            }
            const ImageEnd end = images_.spread(walk, reference_.placed(), target.placed(), side, rules);
            allowed -= std::min<std::uint64_t>(allowed, end.step_count);
            steps_left_ -= std::min<std::uint64_t>(steps_left_, end.step_count);
            if (end.kind != ImageEnd::Kind::complete) continue;
            keep_better(best, {side, end.distance});
            rules.max_distance = best->distance * (1 + rounding);
            if (wanted == Wanted::any) break;
        }
        return best;
    }

    /// The share of the step limit for one of \p parts searches in a component of \p size triangles, and at
    /// least the steps of a few candidates. 0 once the whole search has taken many times the limit.
    std::uint64_t allowed_steps(std::size_t size, std::size_t parts) {
        steps_left_ -= std::min<std::uint64_t>(steps_left_, size);  // for looking at the candidates
        const double share = static_cast<double>(size) / static_cast<double>(match_.roots.size() * parts);
        const auto part = static_cast<std::uint64_t>(share * static_cast<double>(options_.step_limit));
        return std::min(steps_left_, part + 4 * size);
    }

    /// The possible images of side 0 of the triangle \p seed in a component, nearest first.
    std::vector<Index> candidates(Index seed, const Searched& target, Index component,
                                  const glm::dvec3& shift) const {
        std::vector<std::pair<double, Index>> sides;
        const Index seed_side = 3 * seed;
        for (const Index t : target.gluing.component(component))
            for (const Index side : {3 * t, 3 * t + 1, 3 * t + 2}) {
                if (target.signature[side] != reference_.signature[seed_side]) continue;
                double distance = 0;
                for (Index k = 0; k < 3; ++k) {
                    const Index ours = reference_.gluing.triangles[seed][k];
                    const Index theirs = target.gluing.apex(turned(side, k));
                    distance += square(glm::dvec3(target.positions[theirs]) + shift -
                                       glm::dvec3(reference_.positions[ours]));
                }
                sides.emplace_back(distance, side);
            }
        std::sort(sides.begin(), sides.end());
        std::vector<Index> result;
        result.reserve(sides.size());
        for (const auto& [distance, side] : sides) result.push_back(side);
        return result;
    }

    static void keep_better(std::optional<Image>& best, const Image& image) {
        if (!best || image.distance < best->distance * (1 - rounding) ||
            (image.distance <= best->distance * (1 + rounding) && image.side < best->side))
            best = image;
    }

    void take(const RootWalk& walk, Index image) {
        images_.spread(walk, reference_.placed(), key_.placed(), image, {.marked = options_.marked});
        for (const RootWalk::Step& step : walk.steps) {
            match_.roots[step.triangle] = images_[step.triangle] / 3;
            for (Index k = 0; k < 3; ++k)
                match_.vertices[reference_.gluing.triangles[step.triangle][k]] =
                    key_.gluing.apex(turned(images_[step.triangle], k));
        }
    }

    RootMatchOptions options_;
    Searched reference_, key_;
    RootImages images_;
    RootWalker walker_;
    RootMatch match_;
    std::uint64_t steps_left_;
    bool undecided_ = false;
};

}  // namespace

IsomorphismSearch find_isomorphism(const PlacedComplex& reference, const PlacedComplex& key,
                                   const RootMatchOptions& options) {
    return Search(reference, key, options).run();
}

}  // namespace interleaf
