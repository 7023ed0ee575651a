#include "fit/correspondence/coarsening.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <tuple>

#include <glm/geometric.hpp>

#include "fit/correspondence/even_mesh.h"
#include "fit/sphere_map/orientation.h"

namespace interleaf {
namespace {

/// Shapes are good from these qualities on.
constexpr double good_shape = 0.3;
constexpr double good_image = 0.2;

/// The least cosine between a triangle's normals before and after a collapse.
constexpr double min_turn_cosine = 0.2;

/// No collapse makes an edge longer than this multiple of the longest edge that may be collapsed.
constexpr double max_new_edge = 2.2;

/// Maximum number of edges at both ends of a collapsed edge together.
constexpr Index max_edges_at_ends = 20;

/// The factor by which the longest edge that may be collapsed grows, from round to round, and where it ends,
/// as a multiple of the edge of an even mesh.
constexpr double round_growth = 1.15;
constexpr double longest_collapsed = 2;

/// 1 for an equilateral triangle, 0 for a triangle without area.
double shape_quality(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    const glm::dvec3 ab = b - a;
    const glm::dvec3 bc = c - b;
    const glm::dvec3 ca = a - c;
    const double sides = glm::dot(ab, ab) + glm::dot(bc, bc) + glm::dot(ca, ca);
    return sides > 0 ? 2 * std::sqrt(3.0) * glm::length(glm::cross(ab, ca)) / sides : 0;
}

/// A number from 3/4 to 5/4 that depends on the edge and on \p variation.
double varied_part(Index low, Index high, std::uint32_t variation) {
    if (variation == 0) return 1;
    std::uint32_t hash = (low * 2654435761U) ^ (high * 40503U) ^ (variation * 97531U);
    hash ^= hash >> 15;
    hash *= 2246822519U;
    hash ^= hash >> 13;
    return 0.75 + 0.5 * double(hash & 0xffffU) / 65536;
}

class Coarsening {
  public:
    Coarsening(HalfEdgeMesh& mesh, std::size_t vertices, const CoarseningView& view, ProgressMeter& meter)
        : mesh_(mesh),
          wanted_(vertices),
          view_(view),
          meter_(meter),
          stamp_(mesh.vertex_capacity()),
          mark_(mesh.vertex_capacity(), no_index) {
        for (Index v = 0; v < mesh.vertex_capacity(); ++v) count_ += mesh.has_vertex(v) ? 1 : 0;
    }

    std::vector<Index> run() {
        const double last = longest_collapsed * even_edge(double(wanted_));
        for (limit_ = even_edge(double(std::max(count_, wanted_))); count_ > wanted_;
             limit_ *= round_growth) {
            run_round();
            if (limit_ > last) break;
        }
        return std::move(collapsed_);
    }

  private:
    struct Candidate {
        double length;
        Index half_edge;
        Index from;
        Index to;
        Index stamps;  ///< of both ends, added
        bool operator<(const Candidate& other) const {
            return std::tie(other.length, other.from, other.to) < std::tie(length, from, to);
        }
    };

    void run_round() {
        queue_ = {};
        for (Index h = 0; h < 3 * mesh_.triangle_capacity(); ++h) {
            if (!mesh_.has_triangle(h / 3)) continue;
            const bool is_first = !view_.are_first.empty() && view_.are_first[mesh_.origin(h)];
            if (is_first || mesh_.origin(h) < mesh_.target(h)) push(h, is_first);
            meter_.step(2);
        }
        while (!queue_.empty() && count_ > wanted_) {
            const Candidate edge = queue_.top();
            queue_.pop();
            meter_.step(20);
            if (!is_valid(edge)) continue;
            const Index twin = mesh_.twin(edge.half_edge);
            const double there = quality_after(edge.half_edge);
            const double back = quality_after(twin);
            if (std::max(there, back) < 0) continue;
            collapse(back > there ? twin : edge.half_edge);
        }
    }

    bool is_valid(const Candidate& edge) const {
        return mesh_.has_triangle(edge.half_edge / 3) && mesh_.origin(edge.half_edge) == edge.from &&
               mesh_.target(edge.half_edge) == edge.to && stamp_[edge.from] + stamp_[edge.to] == edge.stamps;
    }

    void push(Index half_edge, bool is_first = false) {
        constexpr double part_of_first = 0.1;
        const Index from = mesh_.origin(half_edge);
        const Index to = mesh_.target(half_edge);
        double length = glm::distance(view_.positions[from], view_.positions[to]) *
                        varied_part(std::min(from, to), std::max(from, to), view_.variation);
        if (is_first) length *= part_of_first;
        if (length < limit_) queue_.push({length, half_edge, from, to, stamp_[from] + stamp_[to]});
    }

    /// Whether the two ends have exactly two common neighbors.
    bool keeps_complex(Index half_edge) {
        const Index from = mesh_.origin(half_edge);
        const Index to = mesh_.target(half_edge);
        if (mesh_.degree(from) + mesh_.degree(to) > max_edges_at_ends) return false;
        mesh_.for_spokes(to, [&](Index spoke) { mark_[mesh_.target(spoke)] = to; });
        int common = 0;
        mesh_.for_spokes(from, [&](Index spoke) { common += mark_[mesh_.target(spoke)] == to ? 1 : 0; });
        mesh_.for_spokes(to, [&](Index spoke) { mark_[mesh_.target(spoke)] = no_index; });
        return common == 2 && count_ > 4;
    }

    /// The worst quality of the triangles that the collapse makes; -1 if the collapse is not allowed.
    double quality_after(Index half_edge) {
        constexpr double refused = -1;
        const Index from = mesh_.origin(half_edge);
        if (!view_.are_held.empty() && view_.are_held[from]) return refused;
        if (!keeps_complex(half_edge)) return refused;
        const Index to = mesh_.target(half_edge);
        double worst = 1;
        double worst_before = 1;
        double worst_image = 1;
        double worst_image_before = 1;
        bool is_allowed = true;
        mesh_.for_spokes(from, [&](Index spoke) {
            const Index a = mesh_.target(spoke);
            const Index b = mesh_.origin(HalfEdgeMesh::previous(spoke));
            worst_before = std::min(worst_before, quality(view_.positions, from, a, b));
            if (!is_allowed || a == to || b == to) return;
            is_allowed = orientation(view_.points[to], view_.points[a], view_.points[b]) > 0 &&
                         !turns_over(from, to, a, b) && !is_long(to, a) && !is_long(to, b);
            worst = std::min(worst, quality(view_.positions, to, a, b));
            if (view_.images.empty()) return;
            worst_image_before = std::min(worst_image_before, quality(view_.images, from, a, b));
            worst_image = std::min(worst_image, quality(view_.images, to, a, b));
        });
        if (!is_allowed || (worst < good_shape && worst < worst_before) ||
            (worst_image < good_image && worst_image < worst_image_before))
            return refused;
        return std::min(worst, worst_image);
    }

    static double quality(std::span<const glm::dvec3> places, Index a, Index b, Index c) {
        return shape_quality(places[a], places[b], places[c]);
    }

    bool is_long(Index a, Index b) const {
        return glm::distance(view_.positions[a], view_.positions[b]) > max_new_edge * limit_;
    }

    bool turns_over(Index from, Index to, Index a, Index b) const {
        constexpr double no_area = 1e-10;
        const std::span<const glm::dvec3> p = view_.positions;
        const glm::dvec3 before = glm::cross(p[a] - p[from], p[b] - p[from]);
        const glm::dvec3 after = glm::cross(p[a] - p[to], p[b] - p[to]);
        const double length = glm::length(before);
        return length > no_area && glm::dot(before, after) < min_turn_cosine * length * glm::length(after);
    }

    void collapse(Index half_edge) {
        const Index to = mesh_.target(half_edge);
        mesh_.collapse(half_edge);
        collapsed_.push_back(half_edge);
        --count_;
        ++stamp_[to];
        mesh_.for_spokes(to, [&](Index spoke) {
            push(spoke);
            push(HalfEdgeMesh::next(spoke));
        });
    }

    HalfEdgeMesh& mesh_;
    std::size_t wanted_;
    CoarseningView view_;
    ProgressMeter& meter_;
    std::size_t count_ = 0;
    double limit_ = 0;  ///< longer edges are not collapsed in this round
    std::priority_queue<Candidate> queue_;
    std::vector<Index> stamp_;
    std::vector<Index> mark_;
    std::vector<Index> collapsed_;
};

}  // namespace

std::vector<Index> coarsen(HalfEdgeMesh& mesh, std::size_t vertices, const CoarseningView& view,
                           ProgressMeter& meter) {
    return Coarsening(mesh, vertices, view, meter).run();
}

}  // namespace interleaf
