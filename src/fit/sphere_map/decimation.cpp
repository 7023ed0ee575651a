#include "fit/sphere_map/decimation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>

#include <glm/geometric.hpp>

#include "fit/mesh/space_triangle.h"

namespace interleaf {
namespace {

/// Whether a plate erodes is judged as long as it has at least this many vertices.
constexpr Index min_vertices_of_plate = 300;

/// A plate erodes if less than this fraction of its area is left after three halvings of its vertices, or after six.
/// Other bodies than plates keep over 0.24 and 0.5, rods 500 times as long as wide 0.205 in three.
constexpr double left_of_three_halvings = 0.2;
constexpr double left_of_six_halvings = 0.4;

/// How much the distance of the surface counts against the length of edges where a plate would erode.
constexpr double weight_of_distance = 4;

double area_of(const HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions) {
    double doubled = 0;
    for (Index triangle = 0; triangle < mesh.triangle_capacity(); ++triangle) {
        if (!mesh.has_triangle(triangle)) continue;
        const Index first = 3 * triangle;
        doubled += doubled_area({positions[mesh.origin(first)], positions[mesh.origin(first + 1)],
                                 positions[mesh.origin(first + 2)]});
    }
    return doubled / 2;
}

/// \param areas  of the mesh after each halving of its vertices
bool is_eroding(std::span<const double> areas) {
    const auto is_less = [&](std::size_t halvings, double part) {
        return areas.size() > halvings && areas.back() < part * areas[areas.size() - 1 - halvings];
    };
    return is_less(3, left_of_three_halvings) || is_less(6, left_of_six_halvings);
}

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
    /// \param distance_weight  how much the distance of the surface counts; 0 for not at all
    Decimation(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions, std::span<const char> kept,
               double distance_weight)
        : mesh_(mesh),
          positions_(positions),
          kept_(kept),
          squared_weight_(distance_weight * distance_weight),
          stamp_(mesh.vertex_capacity()),
          place_in_ring_(mesh.vertex_capacity(), no_index) {}

    /// Collapses vertices until \p count are left. Progress begins at \p first_part, and ends at \p last_part when four
    /// are left.
    void collapse_to(std::size_t count, ProgressMeter& meter, double first_part, double last_part) {
        const std::size_t wanted = mesh_.vertex_capacity() - 4;
        collapsed_.reserve(wanted);
        while (mesh_.vertex_capacity() - collapsed_.size() > count) {
            if (queue_.empty()) push_all(meter);
            if (queue_.empty()) continue;
            const Index half_edge = pop();
            if (half_edge == no_index) continue;
            apply(half_edge);
            collapsed_.push_back(half_edge);
            meter.set_part(std::max(first_part, last_part * double(collapsed_.size()) / double(wanted)));
            meter.step();
        }
    }

    void undo() {
        for (; !collapsed_.empty(); collapsed_.pop_back()) mesh_.undo_collapse(collapsed_.back());
    }

    std::vector<Index>& collapsed() { return collapsed_; }

  private:
    /// Fills the queue. Vertices of large degree wait until no other vertex can go; a fan would take quadratic time.
    void push_all(ProgressMeter& meter) {
        max_degree_ *= 8;
        for (Index vertex = 0; vertex < mesh_.vertex_capacity(); ++vertex) {
            if (mesh_.has_vertex(vertex)) push(vertex);
            meter.step();
        }
    }

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
        normals_.clear();
        double worst_shape = 1;
        for (Index place = 0; place < ring_.size(); ++place) {
            const Index after = place + 1 == ring_.size() ? 0 : place + 1;
            const TriangleCorners corners{positions_[vertex], positions_[ring_[place]],
                                          positions_[ring_[after]]};
            worst_shape = std::max(worst_shape, squared_shape(corners[0], corners[1], corners[2]));
            if (squared_weight_ > 0) normals_.push_back(unit_normal(corners));
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
        const double distance = squared_weight_ * squared_distance_from_star(vertex, target);
        const auto squared_distance = [&](Index other) {
            const glm::dvec3 edge = positions_[other] - target;
            return glm::dot(edge, edge);
        };
        double longest = squared_distance(vertex);
        double worst_shape = 1;
        Index at = place + 1 == size ? 0 : place + 1;
        for (Index i = 2; i < size && (longest + distance) * worst_shape < limit; ++i) {
            const Index after = at + 1 == size ? 0 : at + 1;
            if (i + 1 < size) longest = std::max(longest, squared_distance(ring_[after]));
            worst_shape =
                std::max(worst_shape, squared_shape(target, positions_[ring_[at]], positions_[ring_[after]]));
            at = after;
        }
        return (longest + distance) * worst_shape;
    }

    /// The largest squared distance of \p place from the planes of the star of \p vertex, whose normals are gathered.
    double squared_distance_from_star(Index vertex, const glm::dvec3& place) const {
        double largest = 0;
        for (const glm::dvec3& normal : normals_)
            largest = std::max(largest, std::abs(glm::dot(normal, place - positions_[vertex])));
        return largest * largest;
    }

    HalfEdgeMesh& mesh_;
    std::span<const glm::dvec3> positions_;
    std::span<const char> kept_;
    double squared_weight_;
    std::vector<Index> collapsed_;
    std::priority_queue<Entry> queue_;
    Index max_degree_ = 2;  // eight times as much whenever the queue is filled
    std::vector<Index> stamp_;
    std::vector<Index> place_in_ring_;
    std::vector<Index> ring_;
    std::vector<Index> half_edges_;
    std::vector<char> blocked_;
    std::vector<glm::dvec3> normals_;  // of the triangles of a star, if distances count
};

}  // namespace

std::vector<Index> decimate(HalfEdgeMesh& mesh, std::span<const glm::dvec3> positions, ProgressMeter& meter,
                            double last_part, std::span<const char> kept) {
    assert(mesh.vertex_capacity() >= 4);
    Decimation decimation(mesh, positions, kept, 0);
    std::vector<double> areas{area_of(mesh, positions)};
    for (Index left = mesh.vertex_capacity() / 2; left >= min_vertices_of_plate; left /= 2) {
        decimation.collapse_to(left, meter, 0, last_part);
        areas.push_back(area_of(mesh, positions));
        if (!is_eroding(areas)) continue;
        decimation.undo();
        Decimation of_plate(mesh, positions, kept, weight_of_distance);
        const double done = 1 - double(left) / double(mesh.vertex_capacity());
        of_plate.collapse_to(4, meter, done * last_part, last_part);
        return std::move(of_plate.collapsed());
    }
    decimation.collapse_to(4, meter, 0, last_part);
    return std::move(decimation.collapsed());
}

}  // namespace interleaf
