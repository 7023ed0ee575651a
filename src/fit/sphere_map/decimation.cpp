#include "fit/sphere_map/decimation.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <queue>
#include <tuple>

#include <glm/geometric.hpp>

namespace interleaf {
namespace {

/// The squared ratio of (sum of squared sides) to area, 1 for an equilateral triangle; large but finite for a
/// triangle without area.
double squared_shape(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const glm::dvec3 bc = c - b;
    const double sides = glm::dot(ab, ab) + glm::dot(ac, ac) + glm::dot(bc, bc);
    const glm::dvec3 normal = glm::cross(ab, ac);
    constexpr double flattest = 1e-20;
    return sides > 0 ? sides * sides / (12 * (glm::dot(normal, normal) + flattest * sides * sides)) : 1;
}

/// The cheapest collapse of one vertex.
struct Collapse {
    double cost = std::numeric_limits<double>::infinity();
    Index half_edge = no_index;
};

class Decimation {
  public:
    Decimation(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions, std::span<const char> kept)
        : mesh_(mesh),
          positions_(positions),
          kept_(kept),
          stamp_(mesh.vertex_capacity()),
          place_in_ring_(mesh.vertex_capacity(), no_index) {}

    std::vector<Index> run(ProgressMeter& meter, double last_part) {
        std::vector<Index> collapsed;
        const std::size_t wanted = mesh_.vertex_capacity() - 4;
        collapsed.reserve(wanted);
        for (; collapsed.size() < wanted; max_degree_ *= 8) {
            for (Index vertex = 0; vertex < mesh_.vertex_capacity(); ++vertex) {
                if (mesh_.has_vertex(vertex)) push(vertex);
                meter.step();
            }
            while (collapsed.size() < wanted && !queue_.empty()) {
                const Index half_edge = pop();
                if (half_edge == no_index) continue;
                apply(half_edge);
                collapsed.push_back(half_edge);
                meter.set_part(last_part * double(collapsed.size()) / double(wanted));
                meter.step();
            }
        }
        return collapsed;
    }

  private:
    struct Entry {
        bool is_kept;
        double cost;
        Index vertex;
        Index stamp;
        Index half_edge;
        bool operator<(const Entry& other) const {
            return std::tie(other.is_kept, other.cost, other.vertex, other.stamp) <
                   std::tie(is_kept, cost, vertex, stamp);
        }
    };

    void push(Index vertex) {
        const Collapse best = cheapest(vertex);
        ++stamp_[vertex];
        if (best.half_edge == no_index) return;
        queue_.push(
            {!kept_.empty() && kept_[vertex] != 0, best.cost, vertex, stamp_[vertex], best.half_edge});
    }

    /// The half-edge to collapse next; none if the cheapest entry is out of date.
    Index pop() {
        const Entry entry = queue_.top();
        queue_.pop();
        if (!mesh_.has_vertex(entry.vertex) || stamp_[entry.vertex] != entry.stamp) return no_index;
        // Edges made since then, beyond the vertex's own star, can block the collapse.
        gather_ring(entry.vertex);
        const bool blocked = blocked_[place_of(entry.half_edge)];
        clear_ring();
        if (!blocked) return entry.half_edge;
        push(entry.vertex);
        return no_index;
    }

    void apply(Index half_edge) {
        const Index removed = mesh_.origin(half_edge);
        gather_ring(removed);
        clear_ring();
        mesh_.collapse(half_edge);
        const std::vector<Index> changed = ring_;
        for (const Index vertex : changed) push(vertex);
    }

    /// Fills ring_ with the neighbors of \p vertex. Marks the neighbors onto which it must not collapse,
    /// because they have a third neighbor in common with it.
    void gather_ring(Index vertex) {
        ring_.clear();
        half_edges_.clear();
        Index half_edge = mesh_.outgoing(vertex);
        do {
            place_in_ring_[mesh_.target(half_edge)] = static_cast<Index>(ring_.size());
            ring_.push_back(mesh_.target(half_edge));
            half_edges_.push_back(half_edge);
            half_edge = mesh_.rotated(half_edge);
        } while (half_edge != mesh_.outgoing(vertex));
        blocked_.assign(ring_.size(), 0);
        if (ring_.size() == 3) return;
        // The search does not look up whether an edge joins two neighbors of large degree: both count as
        // blocked.
        const auto is_large = [&](Index neighbor) { return mesh_.degree(neighbor) > max_degree_; };
        const bool block_large = std::count_if(ring_.begin(), ring_.end(), is_large) > 1;
        for (Index place = 0; place < ring_.size(); ++place) {
            if (!is_large(ring_[place]))
                block_chords(place);
            else if (block_large)
                blocked_[place] = 1;
        }
    }

    void block_chords(Index place) {
        const auto size = static_cast<Index>(ring_.size());
        const Index start = mesh_.outgoing(ring_[place]);
        Index half_edge = start;
        do {
            const Index other = place_in_ring_[mesh_.target(half_edge)];
            if (other != no_index && other != (place + 1) % size && place != (other + 1) % size)
                blocked_[place] = blocked_[other] = 1;
            half_edge = mesh_.rotated(half_edge);
        } while (half_edge != start);
    }

    void clear_ring() {
        for (const Index vertex : ring_) place_in_ring_[vertex] = no_index;
    }

    Index place_of(Index half_edge) const {
        return static_cast<Index>(std::find(half_edges_.begin(), half_edges_.end(), half_edge) -
                                  half_edges_.begin());
    }

    Collapse cheapest(Index vertex) {
        Collapse best;
        if (mesh_.degree(vertex) > max_degree_) return best;
        gather_ring(vertex);
        double worst_shape = 1;
        for (Index place = 0; place < ring_.size(); ++place) {
            const Index after = place + 1 == ring_.size() ? 0 : place + 1;
            worst_shape = std::max(worst_shape, squared_shape(positions_[vertex], positions_[ring_[place]],
                                                              positions_[ring_[after]]));
        }
        for (Index place = 0; place < ring_.size(); ++place) {
            if (blocked_[place]) continue;
            const double cost = cost_of(vertex, place, best.cost * worst_shape) / worst_shape;
            if (cost < best.cost) best = {cost, half_edges_[place]};
        }
        clear_ring();
        return best;
    }

    /// The squared cost of moving \p vertex onto its neighbor at \p place; any value that is not below
    /// \p limit if the cost is not.
    double cost_of(Index vertex, Index place, double limit) const {
        const auto size = static_cast<Index>(ring_.size());
        const glm::dvec3 target = positions_[ring_[place]];
        const auto squared_distance = [&](Index other) {
            const glm::dvec3 edge = positions_[other] - target;
            return glm::dot(edge, edge);
        };
        double longest = squared_distance(vertex);
        double worst_shape = 1;
        Index at = place + 1 == size ? 0 : place + 1;
        for (Index i = 2; i < size && longest * worst_shape < limit; ++i) {
            const Index after = at + 1 == size ? 0 : at + 1;
            if (i + 1 < size) longest = std::max(longest, squared_distance(ring_[after]));
            worst_shape =
                std::max(worst_shape, squared_shape(target, positions_[ring_[at]], positions_[ring_[after]]));
            at = after;
        }
        return longest * worst_shape;
    }

    HalfEdgeMesh& mesh_;
    std::span<const glm::dvec3> positions_;
    std::span<const char> kept_;
    std::priority_queue<Entry> queue_;
    Index max_degree_ = 16;  // vertices of larger degree wait; a fan would take quadratic time
    std::vector<Index> stamp_;
    std::vector<Index> place_in_ring_;
    std::vector<Index> ring_;
    std::vector<Index> half_edges_;
    std::vector<char> blocked_;
};

}  // namespace

std::vector<Index> decimate(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions, ProgressMeter& meter,
                            double last_part, std::span<const char> kept) {
    assert(mesh.vertex_capacity() >= 4);
    return Decimation(mesh, positions, kept).run(meter, last_part);
}

}  // namespace interleaf
