// Tests of the edits of a parameter domain: the region that the result covers, and its triangulation.
#include "family/domain_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "numbers.h"
#include "trials.h"
#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using interleaf::testing::Random;

namespace {

using Polygon = std::vector<glm::dvec2>;

double cross(glm::dvec2 a, glm::dvec2 b) {
    return a.x * b.y - a.y * b.x;
}

double area(const Polygon& polygon) {
    double sum = 0;
    for (std::size_t i = 2; i < polygon.size(); ++i)
        sum += cross(polygon[i - 1] - polygon[0], polygon[i] - polygon[0]) / 2;
    return sum;
}

/// The corners of \p triangle, counter-clockwise.
Polygon corners(const ParameterDomain& domain, const Triangle& triangle) {
    Polygon polygon;
    for (const Index corner : triangle) polygon.push_back(domain.vertices()[corner].at);
    if (area(polygon) < 0) std::swap(polygon[1], polygon[2]);
    return polygon;
}

double covered_area(const ParameterDomain& domain) {
    double sum = 0;
    for (const Triangle& triangle : domain.triangles()) sum += area(corners(domain, triangle));
    return sum;
}

double size_of(const ParameterDomain& domain) {
    glm::dvec2 low(infinity);
    glm::dvec2 high(-infinity);
    for (const DomainVertex& vertex : domain.vertices()) {
        low = glm::min(low, vertex.at);
        high = glm::max(high, vertex.at);
    }
    return glm::distance(low, high);
}

/// The part of \p polygon to the left of the line from \p a to \p b.
Polygon clipped(const Polygon& polygon, glm::dvec2 a, glm::dvec2 b) {
    Polygon left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec2 p = polygon[i];
        const glm::dvec2 q = polygon[(i + 1) % polygon.size()];
        const double side_p = cross(b - a, p - a);
        const double side_q = cross(b - a, q - a);
        if (side_p >= 0) left.push_back(p);
        if ((side_p > 0 && side_q < 0) || (side_p < 0 && side_q > 0))
            left.push_back(p + side_p / (side_p - side_q) * (q - p));
    }
    return left;
}

double common_area(Polygon a, const Polygon& b) {
    for (std::size_t i = 0; i < b.size(); ++i) a = clipped(a, b[i], b[(i + 1) % b.size()]);
    return area(a);
}

bool has_corner(const Triangle& triangle, Index vertex) {
    return std::ranges::find(triangle, vertex) != triangle.end();
}

/// Whether all triangles have an area, no two overlap, each vertex is used, and none lies inside an edge. The
/// test compares areas, unlike ParameterDomain.
bool is_triangulation(const ParameterDomain& domain) {
    const double size = size_of(domain);
    const auto triangles = domain.triangles();
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        const Polygon polygon = corners(domain, triangles[t]);
        if (!(area(polygon) > 0)) return false;
        for (std::size_t other = 0; other < t; ++other)
            if (common_area(polygon, corners(domain, triangles[other])) > 1e-9 * size * size) return false;
        for (Index v = 0; v < domain.vertices().size(); ++v) {
            if (has_corner(triangles[t], v)) continue;
            const glm::dvec2 at = domain.vertices()[v].at;
            for (std::size_t i = 0; i < 3; ++i) {
                const glm::dvec2 a = polygon[i];
                const glm::dvec2 b = polygon[(i + 1) % 3];
                if (glm::distance(a, at) + glm::distance(at, b) <= glm::distance(a, b)) return false;
            }
        }
    }
    for (Index v = 0; v < domain.vertices().size(); ++v)
        if (std::ranges::none_of(triangles, [&](const Triangle& t) { return has_corner(t, v); }))
            return false;
    return true;
}

/// The sum of the angles of all triangles at \p vertex: 2 pi inside, pi on a straight boundary.
double angle_at(const ParameterDomain& domain, Index vertex) {
    const glm::dvec2 at = domain.vertices()[vertex].at;
    double sum = 0;
    for (const Triangle& triangle : domain.triangles()) {
        if (!has_corner(triangle, vertex)) continue;
        std::vector<glm::dvec2> arms;
        for (const Index corner : triangle)
            if (corner != vertex) arms.push_back(glm::normalize(domain.vertices()[corner].at - at));
        sum += std::acos(std::clamp(glm::dot(arms[0], arms[1]), -1.0, 1.0));
    }
    return sum;
}

bool is_interior(const ParameterDomain& domain, Index vertex) {
    return angle_at(domain, vertex) > 2 * std::numbers::pi - 1e-6;
}

double distance_to(const ParameterDomain& domain, glm::dvec2 at) {
    return glm::distance(domain.locate(at).at, at);
}

bool is_inside(const ParameterDomain& domain, glm::dvec2 at) {
    return domain.locate(at).at == at;
}

glm::dvec2 random_point(Random& random) {
    const double x = random.unit();
    return {x, random.unit()};
}

/// Whether \p outer contains all of \p inner, as tested with random points.
bool seems_within(const ParameterDomain& inner, const ParameterDomain& outer, Random& random) {
    const double slack = 1e-9 * size_of(outer);
    for (const Triangle& triangle : inner.triangles()) {
        const Polygon polygon = corners(inner, triangle);
        for (int i = 0; i < 5; ++i) {
            const double s = std::sqrt(random.unit());
            const double t = random.unit();
            const glm::dvec2 at = (1 - s) * polygon[0] + s * ((1 - t) * polygon[1] + t * polygon[2]);
            if (distance_to(outer, at) > slack) return false;
        }
    }
    return true;
}

/// The corners of the triangles, so that domains with different numbering can be compared.
std::vector<std::array<double, 6>> positions_of(const ParameterDomain& domain, Index without = no_index) {
    std::vector<std::array<double, 6>> positions;
    for (const Triangle& triangle : domain.triangles()) {
        if (has_corner(triangle, without)) continue;
        Polygon polygon = corners(domain, triangle);
        std::ranges::rotate(polygon, std::ranges::min_element(polygon, [](glm::dvec2 a, glm::dvec2 b) {
                                return std::pair(a.x, a.y) < std::pair(b.x, b.y);
                            }));
        positions.push_back(
            {polygon[0].x, polygon[0].y, polygon[1].x, polygon[1].y, polygon[2].x, polygon[2].y});
    }
    std::ranges::sort(positions);
    return positions;
}

ParameterDomain triangle() {
    return {{{{0, 0}, 0}, {{1, 0}, 1}, {{0.25, 1}, 2}}, {{0, 1, 2}}};
}

ParameterDomain unit_square() {
    return {{{{0, 0}, 0}, {{1, 0}, 1}, {{1, 1}, 2}, {{0, 1}, 3}, {{0.5, 0.5}, 4}},
            {{0, 1, 4}, {2, 1, 4}, {2, 3, 4}, {3, 0, 4}}};
}

/// A square ring: it has a hole and is not convex.
ParameterDomain ring() {
    return {{{{0, 0}, 0},
             {{1, 0}, 1},
             {{1, 1}, 2},
             {{0, 1}, 3},
             {{0.3, 0.3}, 4},
             {{0.7, 0.3}, 5},
             {{0.7, 0.7}, 6},
             {{0.3, 0.7}, 7}},
            {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}}};
}

/// An L whose reflex corner, vertex 0, is a vertex of four triangles.
ParameterDomain angle() {
    return {{{{0.5, 0.5}, 0}, {{0.5, 1}, 1}, {{0, 1}, 2}, {{0, 0}, 3}, {{1, 0}, 4}, {{1, 0.5}, 5}},
            {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}}};
}

/// Two fans that touch at vertex 0 only, of two triangles and of one.
ParameterDomain butterfly() {
    return {{{{0.5, 0.5}, 0}, {{0, 0}, 1}, {{0.25, 0.5}, 2}, {{0, 1}, 3}, {{1, 0.2}, 4}, {{1, 0.8}, 5}},
            {{0, 1, 2}, {0, 2, 3}, {0, 4, 5}}};
}

/// A strip of triangles a thousand times as long as high.
ParameterDomain strip() {
    std::vector<DomainVertex> vertices;
    std::vector<Triangle> triangles;
    for (Index i = 0; i < 8; ++i) {
        vertices.push_back({{i / 7.0, i % 2 == 0 ? 0.5 : 0.501}, i});
        if (i >= 2) triangles.push_back({i - 2, i - 1, i});
    }
    return {std::move(vertices), std::move(triangles)};
}

std::vector<ParameterDomain> samples() {
    return {triangle(), unit_square(), ring(), angle(), butterfly(), strip()};
}

ParameterDomain transformed(const ParameterDomain& domain, double scale, glm::dvec2 offset) {
    std::vector<DomainVertex> vertices(domain.vertices().begin(), domain.vertices().end());
    for (DomainVertex& vertex : vertices) vertex.at = scale * (vertex.at + offset);
    return {std::move(vertices), {domain.triangles().begin(), domain.triangles().end()}};
}

/// The placement of a domain: its unit square begins at `offset`, and its unit is `scale`.
struct Place {
    double scale;
    glm::dvec2 offset;
};

/// A grid of \p side x \p side vertices at distances of about one unit. It is bent, and each square is split
/// along one of its diagonals.
ParameterDomain bent_grid(unsigned side, Random& random) {
    std::vector<DomainVertex> vertices;
    std::vector<Triangle> triangles;
    for (unsigned y = 0; y < side; ++y)
        for (unsigned x = 0; x < side; ++x) {
            vertices.push_back({glm::dvec2(x, y) + 0.3 * random_point(random), 0});
            if (x + 1 == side || y + 1 == side) continue;
            const Index a = y * side + x;
            triangles.push_back({a, a + 1, a + side + 1});
            triangles.push_back({a, a + side + 1, a + side});
            if (random.below(2) == 0) {
                triangles.end()[-2] = {a, a + 1, a + side};
                triangles.end()[-1] = {a + 1, a + side + 1, a + side};
            }
        }
    return {std::move(vertices), std::move(triangles)};
}

/// The guarantee of ParameterDomain for triangles, tested by comparing all pairs by their areas.
bool has_no_overlap(const std::vector<DomainVertex>& vertices, const std::vector<Triangle>& triangles) {
    const double flat = 1e-9;
    std::vector<Polygon> polygons;
    for (const Triangle& triangle : triangles) {
        Polygon polygon;
        for (const Index corner : triangle) polygon.push_back(vertices[corner].at);
        if (area(polygon) < 0) std::swap(polygon[1], polygon[2]);
        if (area(polygon) < flat) return false;
        for (const Polygon& other : polygons)
            if (common_area(polygon, other) > flat) return false;
        for (Index v = 0; v < vertices.size(); ++v) {
            if (has_corner(triangle, v)) continue;
            const glm::dvec2 at = vertices[v].at;
            if (area({polygon[0], polygon[1], at}) > -flat && area({polygon[1], polygon[2], at}) > -flat &&
                area({polygon[2], polygon[0], at}) > -flat)
                return false;
        }
        polygons.push_back(std::move(polygon));
    }
    return true;
}

/// One random edit of \p domain; checks that the covered area changes as the edit promises.
ParameterDomain randomly_edited(const ParameterDomain& domain, const Place& place, Random& random) {
    const double unit = place.scale * place.scale;
    const double before = covered_area(domain) / unit;
    const double slack = 1e-9;
    const auto count = domain.vertices().size();
    const auto vertex = static_cast<Index>(random.below(count));
    const glm::dvec2 point = place.scale * (1.4 * random_point(random) - 0.2 + place.offset);
    const std::size_t choice = count > 24 ? 1 : random.below(4);

    if (choice == 0) {
        const bool interior = is_interior(domain, vertex);
        ParameterDomain after = with_vertex_moved(domain, vertex, point);
        if (interior) CHECK(std::abs(covered_area(after) / unit - before) < slack);
        REQUIRE(after.vertices().size() == count);
        REQUIRE(std::ranges::equal(after.triangles(), domain.triangles()));
        return after;
    }
    if (choice == 1) {
        const bool interior = is_interior(domain, vertex);
        const bool straight = std::abs(angle_at(domain, vertex) - std::numbers::pi) < 1e-13;
        const auto after = without_vertex(domain, vertex);
        if (!after) {
            CHECK_FALSE((interior || straight));
            return domain;
        }
        const double area_after = covered_area(*after) / unit;
        CHECK(area_after < before + slack);
        if (interior || straight) {
            CHECK(std::abs(area_after - before) < slack);
            CHECK(after->vertices().size() == count - 1);
        }
        CHECK(seems_within(*after, domain, random));
        const auto kept = positions_of(domain, vertex);
        CHECK(std::ranges::includes(positions_of(*after), kept));
        return *after;
    }
    if (choice == 2) {
        const ParameterDomain after = with_vertex_key(domain, vertex, random.below(9));
        CHECK(positions_of(after) == positions_of(domain));
        return after;
    }
    const double snap = 0.02 * place.scale;
    const std::size_t key = random.below(9);
    try {
        const double distance = distance_to(domain, point);
        ParameterDomain after = with_vertex_added(domain, point, key, snap);
        const double growth = covered_area(after) / unit - before;
        REQUIRE(after.vertices().size() == count + 1);
        CHECK(after.vertices().back().key == key);
        if (distance <= snap) {
            CHECK(std::abs(growth) < slack);
            CHECK(glm::distance(after.vertices().back().at, point) <= snap);
        } else {
            CHECK(growth > 0);
            CHECK(after.triangles().size() == domain.triangles().size() + 1);
            CHECK(after.vertices().back().at == point);
        }
        return after;
    } catch (const InputError&) {
        return domain;
    }
}

}  // namespace

TEST_CASE(
    "after any edits a domain is a triangulation, and only edits of its boundary change the covered region") {
    for (const Place& place :
         {Place{1, {0, 0}}, Place{1e-60, {0, 0}}, Place{1e60, {-3, 5}}, Place{1, {400, -700}}}) {
        CAPTURE(place.scale);
        for (std::uint64_t seed = 1; seed <= trials(25); ++seed) {
            CAPTURE(seed);
            Random random(seed);
            for (const ParameterDomain& sample : samples()) {
                ParameterDomain domain = transformed(sample, place.scale, place.offset);
                std::size_t refused = 0;
                for (int step = 0; step < 150; ++step) {
                    CAPTURE(step);
                    try {
                        domain = randomly_edited(domain, place, random);
                    } catch (const InputError& error) {
                        MESSAGE(std::string(error.what()));
                        ++refused;
                    }
                    REQUIRE(is_triangulation(domain));
                }
                CHECK(refused == 0);
            }
        }
    }
}

TEST_CASE("with_vertex_at agrees with the constructor: an equal domain, or the same error") {
    const unsigned side = 7;
    std::size_t accepted = 0;
    std::size_t refused = 0;
    for (std::uint64_t seed = 1; seed <= trials(60); ++seed) {
        CAPTURE(seed);
        Random random(seed);
        ParameterDomain domain = bent_grid(side, random);
        for (int step = 0; step < 40; ++step) {
            CAPTURE(step);
            const auto vertex = static_cast<Index>(random.below(domain.vertices().size()));
            // Usually near, so that many moves are valid; some moves end on another vertex or an edge.
            const glm::dvec2 from = domain.vertices()[vertex].at;
            const glm::dvec2 other = domain.vertices()[random.below(domain.vertices().size())].at;
            const double reach = random.below(3) == 0 ? 8 : 1;
            glm::dvec2 to = from + reach * (2.0 * random_point(random) - 1.0);
            if (random.below(8) == 0) to = other;
            if (random.below(8) == 0) to = (from + other) / 2.0;

            std::vector<DomainVertex> vertices(domain.vertices().begin(), domain.vertices().end());
            vertices[vertex].at = to;
            const std::vector<Triangle> triangles(domain.triangles().begin(), domain.triangles().end());
            std::optional<ParameterDomain> whole;
            std::string fault;
            try {
                whole.emplace(vertices, triangles);
            } catch (const InputError& error) {
                fault = error.what();
            }
            CHECK(whole.has_value() == has_no_overlap(vertices, triangles));
            try {
                const ParameterDomain moved = domain.with_vertex_at(vertex, to);
                REQUIRE(whole);
                REQUIRE(moved == *whole);
                domain = moved;
                ++accepted;
            } catch (const InputError& error) {
                REQUIRE(error.what() == fault);
                ++refused;
            }
        }
    }
    MESSAGE(accepted, " moves accepted, ", refused, " refused");
    CHECK(accepted > trials(300));
    CHECK(refused > trials(300));
}

TEST_CASE("a vertex is moved exactly if no triangle turns over") {
    const ParameterDomain after = with_vertex_moved(unit_square(), 4, {0.3, 0.8});
    CHECK(after.vertices()[4] == DomainVertex{{0.3, 0.8}, 4});
    CHECK(std::ranges::equal(after.triangles(), unit_square().triangles()));
}

TEST_CASE(
    "a vertex stops on its straight path before a triangle turns over, even in a domain of one triangle") {
    for (Index vertex = 0; vertex < 3; ++vertex) {
        CAPTURE(vertex);
        const glm::dvec2 from = triangle().vertices()[vertex].at;
        const glm::dvec2 middle =
            (triangle().vertices()[(vertex + 1) % 3].at + triangle().vertices()[(vertex + 2) % 3].at) / 2.0;
        const ParameterDomain after = with_vertex_moved(triangle(), vertex, middle + 2.0 * (middle - from));
        const double part = glm::distance(after.vertices()[vertex].at, from) / glm::distance(middle, from);
        CHECK(part > 0.99);
        CHECK(part < 1);
        CHECK(glm::distance(after.vertices()[vertex].at, from + part * (middle - from)) < 1e-12);
    }
    // At the end of the move, both of its triangles would be turned over without overlapping each other.
    const ParameterDomain kite({{{0, 0}, 0}, {{1, 0}, 1}, {{2, 0.5}, 2}, {{1, 1}, 3}},
                               {{0, 1, 2}, {0, 2, 3}});
    const ParameterDomain after = with_vertex_moved(kite, 0, {4, 0.5});
    CHECK(after.vertices()[0].at.x < 4.0 / 3);
    CHECK(after.vertices()[0].at.x > 1.33);
}

TEST_CASE("a vertex moved towards another triangle stops before it overlaps") {
    const ParameterDomain after = with_vertex_moved(butterfly(), 2, {0.9, 0.5});
    CHECK(after.vertices()[2].at.x < 0.5);
    CHECK(after.vertices()[2].at.x > 0.49);
    CHECK(after.vertices()[2].at.y == 0.5);
}

TEST_CASE("a vertex that cannot move stays") {
    for (const glm::dvec2 to :
         {glm::dvec2(std::nan(""), 0), glm::dvec2(0, infinity), glm::dvec2(-infinity, 0)})
        CHECK(with_vertex_moved(unit_square(), 4, to) == unit_square());
}

TEST_CASE("a vertex added inside a triangle splits it into three and changes no other") {
    const ParameterDomain after = with_vertex_added(unit_square(), {0.5, 0.2}, 7, 0.01);
    CHECK(after.triangles().size() == 6);
    CHECK(after.vertices().back() == DomainVertex{{0.5, 0.2}, 7});
    CHECK(covered_area(after) == doctest::Approx(1).epsilon(1e-14));
    CHECK(std::ranges::includes(
        positions_of(after),
        positions_of(ParameterDomain({{{1, 0}, 1}, {{1, 1}, 2}, {{0, 1}, 3}, {{0, 0}, 0}, {{0.5, 0.5}, 4}},
                                     {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}}))));
}

TEST_CASE("a vertex added near an edge lies on it and splits both of its triangles") {
    const ParameterDomain after = with_vertex_added(unit_square(), {0.25, 0.26}, 7, 0.01);
    CHECK(after.triangles().size() == 6);
    CHECK(glm::distance(after.vertices().back().at, {0.255, 0.255}) < 1e-15);
    CHECK(covered_area(after) == doctest::Approx(1).epsilon(1e-14));
}

TEST_CASE("a vertex added near the boundary, on either side, lies on it and splits one triangle") {
    for (const double y : {-0.005, 0.0, 0.005}) {
        const ParameterDomain after = with_vertex_added(unit_square(), {0.4, y}, 7, 0.01);
        CHECK(after.triangles().size() == 5);
        CHECK(glm::distance(after.vertices().back().at, {0.4, 0}) < 1e-15);
        CHECK(covered_area(after) == doctest::Approx(1).epsilon(1e-14));
    }
}

TEST_CASE(
    "a vertex added outside or in a hole gets one triangle, over the nearest boundary edge that faces it") {
    const ParameterDomain below = with_vertex_added(unit_square(), {0.4, -0.5}, 7, 0.01);
    CHECK(below.triangles().size() == 5);
    CHECK(covered_area(below) == doctest::Approx(1.25));
    CHECK(has_corner(below.triangles().back(), 0));
    CHECK(has_corner(below.triangles().back(), 1));

    const ParameterDomain filled = with_vertex_added(ring(), {0.5, 0.65}, 7, 0.01);
    CHECK(filled.triangles().size() == 9);
    CHECK(covered_area(filled) == doctest::Approx(covered_area(ring()) + 0.4 * 0.05 / 2).epsilon(1e-12));
    CHECK(has_corner(filled.triangles().back(), 6));
    CHECK(has_corner(filled.triangles().back(), 7));
}

TEST_CASE(
    "a new vertex is rejected on another vertex, if it is not finite, and if a triangle would be flat") {
    const auto refused = [](const ParameterDomain& domain, glm::dvec2 at, double snap) {
        CHECK_THROWS_AS(with_vertex_added(domain, at, 0, snap), InputError);
    };
    refused(unit_square(), {0.505, 0.5}, 0.01);
    refused(unit_square(), {1.005, 1}, 0.01);
    refused(unit_square(), {std::nan(""), 0}, 0.01);
    refused(unit_square(), {infinity, 0}, 0.01);
    refused(unit_square(), {1e300, 1e300}, 0.01);
    refused(unit_square(), {0.5, 1e-13}, 1e-15);
}

TEST_CASE("adding a vertex and removing it keeps the covered region") {
    const std::uint64_t seed = 7;
    CAPTURE(seed);
    Random random(seed);
    for (const ParameterDomain& domain : samples()) {
        for (int i = 0; i < 300; ++i) {
            // Half of the points are on an edge of the domain.
            const Polygon polygon =
                corners(domain, domain.triangles()[random.below(domain.triangles().size())]);
            const double t = 0.1 + 0.8 * random.unit();
            const glm::dvec2 at =
                random.chance(0.5) ? 1.6 * random_point(random) - 0.3 : (1 - t) * polygon[0] + t * polygon[1];
            CAPTURE(at.x);
            CAPTURE(at.y);
            std::optional<ParameterDomain> added;
            try {
                added = with_vertex_added(domain, at, 8, 1e-4);
            } catch (const InputError&) {
                continue;
            }
            const auto back = without_vertex(*added, static_cast<Index>(domain.vertices().size()));
            REQUIRE(back);
            CHECK(covered_area(*back) == doctest::Approx(covered_area(domain)).epsilon(1e-9));
            CHECK(is_triangulation(*back));
            CHECK(back->vertices().size() == domain.vertices().size());
        }
    }
}

TEST_CASE("removing a vertex on a straight boundary keeps the covered region, for any neighbors") {
    const std::uint64_t seed = 3;
    CAPTURE(seed);
    Random random(seed);
    for (int i = 0; i < 200; ++i) {
        CAPTURE(i);
        // A triangle in any direction, with its first side split several times and some vertices inside.
        const double turn = 2 * std::numbers::pi * random.unit();
        const auto at = [&](double x, double y) {
            return glm::dvec2(std::cos(turn) * x - std::sin(turn) * y,
                              std::sin(turn) * x + std::cos(turn) * y);
        };
        ParameterDomain domain({{at(0, 0), 0}, {at(1, 0), 1}, {at(random.unit(), 1), 2}}, {{0, 1, 2}});
        for (const double x : {0.5, 0.25, 0.75, 0.6}) domain = with_vertex_added(domain, at(x, 0), 0, 1e-6);
        for (int inside = 0; inside < 4; ++inside) {
            const glm::dvec2 point = at(random.unit(), random.unit());
            if (!is_inside(domain, point)) continue;
            try {
                domain = with_vertex_added(domain, point, 1, 1e-6);
            } catch (const InputError&) {
                continue;
            }
        }
        const double before = covered_area(domain);
        while (domain.vertices().size() > 3) {
            const auto vertex = static_cast<Index>(3 + random.below(domain.vertices().size() - 3));
            const auto after = without_vertex(domain, vertex);
            REQUIRE(after);
            CHECK(covered_area(*after) == doctest::Approx(before).epsilon(1e-9));
            CHECK(after->vertices().size() == domain.vertices().size() - 1);
            domain = *after;
        }
    }
}

TEST_CASE("removing a corner uncovers the region that only its triangles covered") {
    const auto after = without_vertex(unit_square(), 0);
    REQUIRE(after);
    CHECK(covered_area(*after) == doctest::Approx(0.5));
    CHECK(after->vertices().size() == 4);
    CHECK(after->vertices()[0] == DomainVertex{{1, 0}, 1});
}

TEST_CASE("removing a reflex corner keeps the region that its neighbors can cover without going outside") {
    const auto after = without_vertex(angle(), 0);
    REQUIRE(after);
    CHECK(is_triangulation(*after));
    Random random(1);
    CHECK(seems_within(*after, angle(), random));
    CHECK(covered_area(*after) > 0);
    const auto ring_after = without_vertex(ring(), 4);
    REQUIRE(ring_after);
    CHECK(is_triangulation(*ring_after));
    CHECK(seems_within(*ring_after, ring(), random));
}

TEST_CASE("removing the vertex where two fans touch keeps the region that both sides can cover") {
    const auto after = without_vertex(butterfly(), 0);
    CHECK_FALSE(after);  // neither side has a triangle of its own
    const ParameterDomain two(
        {{{0, 0}, 0}, {{-1, -1}, 1}, {{-2, 0}, 2}, {{-1, 1}, 3}, {{1, -1}, 4}, {{2, 0}, 5}, {{1, 1}, 6}},
        {{0, 2, 1}, {0, 3, 2}, {0, 4, 5}, {0, 5, 6}});
    const auto both = without_vertex(two, 0);
    REQUIRE(both);
    CHECK(both->triangles().size() == 2);
    CHECK(covered_area(*both) == doctest::Approx(2));
}

TEST_CASE("removing any vertex of the last triangle removes it") {
    for (Index vertex = 0; vertex < 3; ++vertex) CHECK_FALSE(without_vertex(triangle(), vertex));
}

TEST_CASE("a vertex whose neighbors lie partly on a line can be removed, although rounding bends the line") {
    for (int i = 0; i < 100; ++i) {
        CAPTURE(i);
        // A triangle around a middle vertex, whose sides are each split into three parts at rounded points.
        const double turn = 0.1 * i;
        Polygon row;
        for (int corner = 0; corner < 3; ++corner) {
            const auto at = [&](int c) {
                const double angle_of = turn + c * 2 * std::numbers::pi / 3;
                return glm::dvec2(std::cos(angle_of), std::sin(angle_of));
            };
            for (const double t : {0.0, 1.0 / 3, 0.6})
                row.push_back((1 - t) * at(corner) + t * at(corner + 1));
        }
        std::vector<DomainVertex> vertices{{{0.05, 0.02}, 0}};
        std::vector<Triangle> triangles;
        for (Index v = 0; v < 9; ++v) {
            vertices.push_back({row[v], v});
            triangles.push_back({0, 1 + v, 1 + (v + 1) % 9});
        }
        const ParameterDomain domain(std::move(vertices), std::move(triangles));
        std::optional<ParameterDomain> after;
        CHECK_NOTHROW(after = without_vertex(domain, 0));
        if (!after) continue;
        CHECK(covered_area(*after) == doctest::Approx(covered_area(domain)).epsilon(1e-12));
        CHECK(after->triangles().size() == 7);
    }
}

TEST_CASE("assigning another key to a vertex changes nothing else") {
    const ParameterDomain after = with_vertex_key(unit_square(), 4, 2);
    CHECK(after.vertices()[4] == DomainVertex{{0.5, 0.5}, 2});
    CHECK(with_vertex_key(after, 4, 4) == unit_square());
}
