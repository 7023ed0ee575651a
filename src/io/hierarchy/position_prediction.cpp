#include "io/hierarchy/position_prediction.h"

#include <array>
#include <cstddef>
#include <utility>

namespace interleaf {

namespace {

using Pair = std::array<Index, 2>;

bool contains(const Pair& pair, Index vertex) {
    return pair[0] == vertex || pair[1] == vertex;
}

class Prediction {
  public:
    Prediction(const Connectivity& connectivity, std::span<const glm::vec3> positions)
        : connectivity_(connectivity), positions_(positions) {}

    glm::dvec3 at(Index vertex) const {
        const MidpointStar& star = connectivity_.stars[vertex];
        const auto [older, younger] = by_age(star.ends);
        const MidpointStar& base = connectivity_.stars[younger];
        if (contains(base.ends, older)) return middle(star.ends) + bend_of_half(older, younger);
        if (contains(base.apexes, older) && is_before(star.apexes[0], vertex) &&
            is_before(star.apexes[1], vertex))
            return middle(star.apexes) + 0.25 * bend(younger);
        return middle(star.ends);
    }

  private:
    /// The ends of an edge, the younger end second: its star contains the first end. The order of two root
    /// vertices does not matter.
    Pair by_age(const Pair& ends) const {
        const MidpointStar& star = connectivity_.stars[ends[0]];
        const bool first_is_younger = contains(star.ends, ends[1]) || contains(star.apexes, ends[1]);
        return first_is_younger ? Pair{ends[1], ends[0]} : ends;
    }

    bool is_before(Index a, Index b) const {
        if (a == no_index) return false;
        const auto& levels = connectivity_.levels;
        return std::pair(levels[a], a) < std::pair(levels[b], b);
    }

    glm::dvec3 middle(const Pair& pair) const {
        return 0.5 * (glm::dvec3(positions_[pair[0]]) + glm::dvec3(positions_[pair[1]]));
    }

    /// The offset of a midpoint from the middle of its edge.
    glm::dvec3 bend(Index midpoint) const {
        return glm::dvec3(positions_[midpoint]) - middle(connectivity_.stars[midpoint].ends);
    }

    /// The expected bend of the half edge from \p end to \p midpoint.
    glm::dvec3 bend_of_half(Index end, Index midpoint) const {
        const glm::dvec3 here = bend(midpoint);
        const auto [older, younger] = by_age(connectivity_.stars[midpoint].ends);
        if (!contains(connectivity_.stars[younger].ends, older)) return 0.25 * here;
        // The edge is a half edge, too. One step toward its younger end, the bend is the bend of that end,
        // and a quarter of it over half the length. The middle of the half edge is half a step from the
        // midpoint, in one direction or the other.
        const glm::dvec3 change = 0.25 * bend(younger) - here;
        return 0.25 * (here + (end == younger ? 0.5 : -0.5) * change);
    }

    const Connectivity& connectivity_;
    std::span<const glm::vec3> positions_;
};

}  // namespace

Buffer<Index> prediction_order(std::span<const std::uint8_t> levels) {
    std::array<std::size_t, 256> place{};  // where the next vertex of each level goes
    for (const std::uint8_t level : levels) ++place[level];
    for (std::size_t level = 0, sum = 0; level < place.size(); ++level)
        sum += std::exchange(place[level], sum);
    Buffer<Index> order;
    order.resize(levels.size());
    for (Index vertex = 0; vertex < levels.size(); ++vertex) order[place[levels[vertex]]++] = vertex;
    return order;
}

glm::dvec3 predicted_position(Index vertex, const Connectivity& connectivity,
                              std::span<const glm::vec3> positions) {
    return Prediction(connectivity, positions).at(vertex);
}

}  // namespace interleaf
