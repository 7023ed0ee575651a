#include "hierarchy/matching/root_walk.h"

namespace interleaf {

namespace {

double squared_distance(const glm::vec3& a, const glm::vec3& b, const glm::dvec3& shift) {
    const glm::dvec3 way = glm::dvec3(b) + shift - glm::dvec3(a);
    return way.x * way.x + way.y * way.y + way.z * way.z;
}

}  // namespace

RootWalk RootWalker::walk_from(Index seed) {
    RootWalk walk;
    const auto reach = [&](Index t) {
        reached_[t] = true;
        walk.steps.push_back({t, 0, 0});
    };
    reach(seed);
    for (std::size_t place = 0; place < walk.steps.size(); ++place) {
        const Index t = walk.steps[place].triangle;
        unsigned leads_on = 0, is_visited = 0;
        for (Index k = 0; k < 3; ++k) {
            const Index vertex = gluing_->triangles[t][k];
            if (visited_[vertex]) {
                is_visited |= 1U << k;
            } else {
                visited_[vertex] = true;
                ++walk.vertex_count;
            }
            const Index across = gluing_->across[3 * t + k];
            if (across == no_index || reached_[across / 3]) continue;
            leads_on |= 1U << k;
            reach(across / 3);
        }
        walk.steps[place].leads_on = static_cast<std::uint8_t>(leads_on);
        walk.steps[place].is_visited = static_cast<std::uint8_t>(is_visited);
    }
    return walk;
}

ImageEnd RootImages::spread(const RootWalk& walk, const PlacedRoots& from, const PlacedRoots& to, Index image,
                            const ImageRules& rules) {
    using Kind = ImageEnd::Kind;
    ImageEnd end;
    const auto stop = [&end](Kind kind, Index side, Index image_side) {
        end.kind = kind;
        end.side = side;
        end.image_side = image_side;
        return end;
    };
    const Index first = walk.steps.front().triangle;
    if (!rules.given.empty() && rules.given[first] != image / 3) return stop(Kind::given, 3 * first, image);
    if (rules.marked && image % 3 != 0) return stop(Kind::refinement_edge, 3 * first, image);

    sides_[first] = image;
    for (const RootWalk::Step& step : walk.steps) {
        ++end.step_count;
        for (Index k = 0; k < 3; ++k) {
            const Index side = 3 * step.triangle + k;
            const Index image_side = turned(sides_[step.triangle], k);
            if ((step.is_visited >> k & 1) == 0) {
                const Index vertex = from.gluing->apex(side), other = to.gluing->apex(image_side);
                if (from.gluing->surroundings[vertex] != to.gluing->surroundings[other])
                    return stop(Kind::surroundings, side, image_side);
                end.distance += squared_distance(from.positions[vertex], to.positions[other], rules.shift);
            }
            const Index across = from.gluing->across[side];
            const Index image_across = to.gluing->across[image_side];
            if ((across == no_index) != (image_across == no_index))
                return stop(Kind::boundary, side, image_side);
            if (across == no_index) continue;

            const Index neighbor = across / 3;
            const Index neighbor_image = turned(image_across, 3 - across % 3);
            if ((step.leads_on >> k & 1) == 0) {
                if (sides_[neighbor] != neighbor_image) return stop(Kind::neighbor, side, image_side);
                continue;
            }
            if (!rules.given.empty() && rules.given[neighbor] != neighbor_image / 3)
                return stop(Kind::given, side, image_side);
            if (rules.marked && neighbor_image % 3 != 0) return stop(Kind::refinement_edge, side, image_side);
            sides_[neighbor] = neighbor_image;
        }
        if (end.distance > rules.max_distance) return stop(Kind::too_far, no_index, no_index);
    }
    return end;
}

}  // namespace interleaf
