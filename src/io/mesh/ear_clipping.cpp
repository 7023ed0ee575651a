#include "io/mesh/ear_clipping.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <functional>
#include <queue>
#include <tuple>
#include <utility>

#include "io/mesh/crossing_edges.h"
#include "io/mesh/polygon_plane.h"
#include "io/mesh/reflex_tree.h"

namespace interleaf {
namespace {

/// A polygon that bulges less than this (PlanePolygon::bulge) counts as flat.
constexpr double max_bulge = 1e-3;

/// The part of a polygon that remains after clipping some ears, as a ring of its corners.
class Ring {
  public:
    /// \param points   the corners in their plane, in counterclockwise order
    /// \param corners  the corners in space
    Ring(std::span<const PlanePoint> points, std::span<const glm::dvec3> corners)
        : points_(points), corners_(corners), links_(points.size()), reflex_(points, reflex_corners(points)) {
        const auto count = static_cast<Index>(points.size());
        for (Index corner = 0; corner < count; ++corner)
            links_[corner] = {(corner + count - 1) % count, (corner + 1) % count, 0};
        triangles_.reserve(points.size() - 2);
    }

    std::vector<Triangle> clip() && {
        clip_ears(Touching::forbidden);
        // A polygon that touches itself may have no strict ears. Each round clips at least one ear.
        constexpr int max_rounds = 32;
        for (int round = 0; round < max_rounds && !is_done(); ++round) clip_ears(Touching::allowed);
        while (!is_done()) clip_corner(first_);  // it crosses itself; the sum of the areas shows that later
        return std::move(triangles_);
    }

  private:
    /// Whether an ear may have no area, or a corner on one of its sides.
    enum class Touching { forbidden, allowed };

    struct Link {
        Index previous;
        Index next;
        Index age;  ///< how often the neighbors have changed
    };

    struct Candidate {
        bool is_flat;
        double squared_diagonal;
        Index corner;
        Index age;
        bool operator>(const Candidate& other) const {
            return std::tie(is_flat, squared_diagonal, corner) >
                   std::tie(other.is_flat, other.squared_diagonal, other.corner);
        }
    };

    /// Whether the corner \p b between \p a and \p c can prevent an ear: the polygon turns right or back
    /// there, as at the end of a slit.
    static bool is_reflex(const PlanePoint& a, const PlanePoint& b, const PlanePoint& c) {
        const std::int64_t turn = orientation(a, b, c);
        return turn < 0 || (turn == 0 && (b.x - a.x) * (c.x - b.x) + (b.y - a.y) * (c.y - b.y) < 0);
    }

    static std::vector<Index> reflex_corners(std::span<const PlanePoint> points) {
        std::vector<Index> reflex;
        const std::size_t count = points.size();
        for (std::size_t i = 0; i < count; ++i)
            if (is_reflex(points[(i + count - 1) % count], points[i], points[(i + 1) % count]))
                reflex.push_back(static_cast<Index>(i));
        return reflex;
    }

    bool is_done() const { return triangles_.size() + 2 == points_.size(); }

    std::int64_t turn_at(Index corner) const {
        const Link& link = links_[corner];
        return orientation(points_[link.previous], points_[corner], points_[link.next]);
    }

    void add_candidate(Index corner, Touching touching) {
        const std::int64_t turn = turn_at(corner);
        if (turn < 0 || (turn == 0 && touching == Touching::forbidden)) return;
        const Link& link = links_[corner];
        const glm::dvec3 diagonal = corners_[link.next] - corners_[link.previous];
        candidates_.push({turn == 0,
                          diagonal.x * diagonal.x + diagonal.y * diagonal.y + diagonal.z * diagonal.z, corner,
                          link.age});
    }

    bool is_ear(Index corner, Touching touching) const {
        const Link& link = links_[corner];
        return !reflex_.has_inside(
            points_[link.previous], points_[corner], points_[link.next],
            touching == Touching::forbidden ? ReflexTree::Border::inside : ReflexTree::Border::outside);
    }

    /// Clips ears until there are none. A corner that is not an ear does not become one until a neighbor is
    /// clipped: part of its triangle is outside the polygon, and the outside only grows.
    void clip_ears(Touching touching) {
        candidates_ = {};
        Index corner = first_;
        do {
            add_candidate(corner, touching);
            corner = links_[corner].next;
        } while (corner != first_);
        while (!candidates_.empty() && !is_done()) {
            const Candidate best = candidates_.top();
            candidates_.pop();
            const Link link = links_[best.corner];
            if (best.age != link.age || !is_ear(best.corner, touching)) continue;
            clip_corner(best.corner);
            for (const Index neighbor : {link.previous, link.next}) add_candidate(neighbor, touching);
        }
    }

    void clip_corner(Index corner) {
        Link& link = links_[corner];
        triangles_.push_back({link.previous, corner, link.next});
        links_[link.previous].next = link.next;
        links_[link.next].previous = link.previous;
        ++link.age;
        reflex_.remove(corner);
        for (const Index neighbor : {link.previous, link.next}) {
            ++links_[neighbor].age;
            const Link& beside = links_[neighbor];
            if (!is_reflex(points_[beside.previous], points_[neighbor], points_[beside.next]))
                reflex_.remove(neighbor);
        }
        first_ = link.next;
    }

    std::span<const PlanePoint> points_;
    std::span<const glm::dvec3> corners_;
    std::vector<Link> links_;
    ReflexTree reflex_;
    Index first_ = 0;
    std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> candidates_;
    std::vector<Triangle> triangles_;
};

/// Whether a polygon turns left at every corner and goes around only once.
bool is_convex(std::span<const PlanePoint> points) {
    const std::size_t count = points.size();
    int changes = 0;  // of the direction along x, in the second round; a convex polygon has two
    std::int64_t last = 0;
    for (std::size_t i = 0; i < 2 * count; ++i) {
        const PlanePoint& a = points[i % count];
        const PlanePoint& b = points[(i + 1) % count];
        if (i < count && orientation(a, b, points[(i + 2) % count]) <= 0) return false;
        const std::int64_t along = b.x - a.x;
        if (along == 0) continue;
        if (i >= count && last != 0 && (along > 0) != (last > 0)) ++changes;
        last = along;
    }
    return changes == 2;
}

/// Whether triangles are flipped by more than rounding errors.
bool are_turned_over(std::span<const Triangle> triangles, std::span<const PlanePoint> points) {
    constexpr double min_part = 1e-3;  // of the area
    constexpr double min_area = 1e-8 * static_cast<double>(plane_steps) * static_cast<double>(plane_steps);
    double whole = 0;
    double turned_over = 0;
    for (const auto& [a, b, c] : triangles) {
        const auto area = static_cast<double>(orientation(points[a], points[b], points[c]));
        whole += std::abs(area);
        if (area < 0) turned_over -= area;
    }
    return turned_over > std::max(min_part * whole, min_area);
}

std::vector<PlaneEdge> edges_of(std::span<const PlanePoint> corners) {
    std::vector<PlaneEdge> edges;
    edges.reserve(corners.size());
    for (std::size_t corner = 0; corner < corners.size(); ++corner)
        edges.push_back({corners[corner], corners[(corner + 1) % corners.size()]});
    return edges;
}

/// The edges of the triangles that have an area.
std::vector<PlaneEdge> edges_of(std::span<const Triangle> triangles, std::span<const PlanePoint> points) {
    std::vector<PlaneEdge> edges;
    edges.reserve(3 * triangles.size());
    for (const auto& [a, b, c] : triangles) {
        const std::array<PlaneEdge, 3> sides{
            {{points[a], points[b]}, {points[b], points[c]}, {points[c], points[a]}}};
        double longest = 0;
        for (const auto& [from, to] : sides) longest = std::max(longest, distance(from, to));
        const auto area = static_cast<double>(orientation(points[a], points[b], points[c]));
        if (area > min_depth * longest) edges.insert(edges.end(), sides.begin(), sides.end());
    }
    return edges;
}

/// The two ways to halve a quadrilateral; the way with the shorter diagonal comes first.
std::array<std::array<Triangle, 2>, 2> ways_to_halve(std::span<const glm::dvec3> corners) {
    const std::array<Triangle, 2> from_first{{{0, 1, 2}, {0, 2, 3}}};
    const std::array<Triangle, 2> from_second{{{0, 1, 3}, {1, 2, 3}}};
    const auto squared = [](const glm::dvec3& v) { return v.x * v.x + v.y * v.y + v.z * v.z; };
    if (squared(corners[2] - corners[0]) < squared(corners[3] - corners[1])) return {from_first, from_second};
    return {from_second, from_first};
}

}  // namespace

std::vector<Triangle> divide_polygon(std::span<const glm::dvec3> corners) {
    assert(corners.size() >= 3 && corners.size() <= max_polygon_corners);
    if (corners.size() == 3) return {{0, 1, 2}};
    const auto [points, bulge] = in_plane(corners);
    if (points.empty()) {
        std::vector<Triangle> fan;
        for (Index i = 2; i < corners.size(); ++i) fan.push_back({0, i - 1, i});
        return fan;
    }
    // A polygon far from flat may cross itself in the plane, but not in space.
    const bool is_flat = bulge < max_bulge;
    if (corners.size() == 4) {
        const auto ways = ways_to_halve(corners);
        const auto* const way = std::ranges::find_if(ways, [&](const std::array<Triangle, 2>& halves) {
            return std::ranges::all_of(halves, [&](const Triangle& half) {
                return orientation(points[half[0]], points[half[1]], points[half[2]]) > 0;
            });
        });
        if (way != ways.end()) return {way->begin(), way->end()};
        if (!is_flat) return {ways.front().begin(), ways.front().end()};
    }
    const bool may_cross = is_flat && !is_convex(points);
    if (may_cross && has_crossing(edges_of(points), RunningTogether::allowed)) return {};
    std::vector<Triangle> triangles = Ring(points, corners).clip();
    // A polygon may also cross itself at a corner. Only its triangles show this: they overlap.
    if (may_cross && (are_turned_over(triangles, points) ||
                      has_crossing(edges_of(triangles, points), RunningTogether::forbidden)))
        return {};
    return triangles;
}

}  // namespace interleaf
