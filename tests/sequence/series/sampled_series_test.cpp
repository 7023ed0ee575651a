// The recovery to a tolerance.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <set>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "sequence/series/generated_series.h"
#include "sequence/series/series.h"

namespace interleaf {
namespace {

using namespace interleaf::testing;

/// Three corners in the plane with their values.
struct Piece {
    std::array<glm::dvec2, 3> corners;
    std::array<double, 3> values;

    /// The value at \p at; none outside.
    std::optional<double> value_at(const glm::dvec2& at) const {
        const auto cross = [](const glm::dvec2& p, const glm::dvec2& q) { return p.x * q.y - p.y * q.x; };
        const double whole = cross(corners[1] - corners[0], corners[2] - corners[0]);
        const double second = cross(at - corners[0], corners[2] - corners[0]) / whole;
        const double third = cross(corners[1] - corners[0], at - corners[0]) / whole;
        const double first = 1 - second - third;
        if (std::min({first, second, third}) < -1e-9) return std::nullopt;
        return first * values[0] + second * values[1] + third * values[2];
    }
};

std::vector<Piece> pieces_of(const FieldMesh& mesh) {
    std::vector<Piece> pieces;
    for (const auto& triangle : mesh.triangles) {
        Piece& piece = pieces.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            piece.corners[k] = glm::dvec2(mesh.points[triangle[k]]);
            piece.values[k] = mesh.point_fields[0].values[triangle[k]];
        }
    }
    return pieces;
}

std::vector<Piece> pieces_of(const Hierarchy& key) {
    std::vector<Piece> pieces;
    for (const Leaf& leaf : leaves_of(key)) {
        Piece& piece = pieces.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            piece.corners[k] = glm::dvec2(key.positions[leaf.vertices[k]]);
            piece.values[k] = key.fields[0].values[leaf.vertices[k]];
        }
    }
    return pieces;
}

double value_at(const std::vector<Piece>& pieces, const glm::dvec2& at) {
    for (const Piece& piece : pieces)
        if (const auto value = piece.value_at(at)) return *value;
    FAIL("no triangle at a point of the square");
    return 0;
}

/// The largest difference at random points and at the vertices of the step, by search through all triangles.
double literal_difference(const FieldMesh& step, const Hierarchy& key, std::mt19937& random) {
    const auto exact = pieces_of(step);
    const auto sampled = pieces_of(key);
    std::uniform_real_distribution<double> anywhere(0, 1);
    double largest = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const glm::dvec2 at(anywhere(random), anywhere(random));
        largest = std::max(largest, std::abs(value_at(exact, at) - value_at(sampled, at)));
    }
    for (std::size_t p = 0; p < step.points.size(); p += 1 + step.points.size() / 500)
        largest = std::max(largest, std::abs(step.point_fields[0].values[p] -
                                             value_at(sampled, glm::dvec2(step.points[p]))));
    return largest;
}

/// Meshes of one square that have nothing in common: random ones over different roots.
std::vector<FieldMesh> foreign_steps(std::mt19937& random) {
    std::vector<FieldMesh> steps;
    for (const unsigned cells : {5U, 7U, 6U}) {
        steps.push_back(random_steps(square_roots(cells), 1, random)[0]);
        steps.back() = disguised(steps.back(), {0, true, true, true, 0}, random);
    }
    return steps;
}

TEST_CASE("sampled keys differ by at most the tolerance, whatever the meshes") {
    for_each_trial(4, [](std::mt19937& random) {
        const auto steps = foreign_steps(random);
        const Hierarchy roots = square_roots(2);
        for (const double tolerance : {0.1, 0.02})
            for (const bool given : {false, true}) {
                CAPTURE(tolerance);
                SeriesOptions options;
                options.tolerance = tolerance;
                if (given) options.roots = &roots;
                const Recovered result = recovered(steps, options);
                REQUIRE(result.keys.size() == steps.size());
                CHECK(result.report.method == SeriesMethod::by_sampling);
                for (std::size_t step = 0; step < steps.size(); ++step) {
                    CHECK(check(result.keys[step]).empty());
                    CHECK(result.report.steps[step].largest_difference <= tolerance);
                    const double literal = literal_difference(steps[step], result.keys[step], random);
                    CHECK(literal <= result.report.steps[step].largest_difference + 1e-5);
                    CHECK(result.report.steps[step].integral_error < tolerance);
                }
            }
    });
}

TEST_CASE("with tolerance 0, a key over the roots of a bisected mesh has exactly its triangles") {
    for_each_trial(4, [](std::mt19937& random) {
        const Hierarchy roots = square_roots(4);
        const auto steps = random_steps(roots, 2, random);
        SeriesOptions options;
        options.tolerance = 0;
        options.roots = &roots;
        const Recovered result = recovered(steps, options);
        for (std::size_t step = 0; step < steps.size(); ++step) {
            CHECK(result.keys[step].leaf_count() == steps[step].triangles.size());
            CHECK(corner_sets(result.keys[step]) == corner_sets(steps[step]));
            CHECK(result.report.steps[step].largest_difference < 1e-9);
        }
    });
}

TEST_CASE("a larger tolerance never needs more leaves") {
    std::mt19937 random(9);
    const auto steps = foreign_steps(random);
    std::size_t last = 0;
    for (const double tolerance : {0.2, 0.05, 0.01}) {
        SeriesOptions options;
        options.tolerance = tolerance;
        const Recovered result = recovered(steps, options);
        CHECK(result.report.steps[0].leaves >= last);
        last = result.report.steps[0].leaves;
    }
}

/// Squares of a quadtree with hanging vertices, each of two triangles that are one cell. The field is linear.
FieldMesh quadtree(double x, double y, double size, unsigned levels, FieldMesh mesh) {
    if (levels > 0) {
        const double half = size / 2;
        mesh = quadtree(x, y, half, levels - 1, std::move(mesh));
        for (const auto& [dx, dy] : {std::pair(half, 0.0), std::pair(0.0, half), std::pair(half, half)})
            mesh = quadtree(x + dx, y + dy, half, 0, std::move(mesh));
        return mesh;
    }
    const auto first = static_cast<Index>(mesh.points.size());
    for (const auto& [dx, dy] :
         {std::pair(0.0, 0.0), std::pair(size, 0.0), std::pair(size, size), std::pair(0.0, size)}) {
        mesh.points.emplace_back(x + dx, y + dy, 0);
        mesh.point_fields[0].values.push_back(x + dx + 2 * (y + dy));
    }
    const Index cell = mesh.cell_of.empty() ? 0 : mesh.cell_of.back() + 1;
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
    mesh.cell_of.insert(mesh.cell_of.end(), {cell, cell});
    return mesh;
}

TEST_CASE("with tolerance 0, each leaf lies in one cell of a quadtree with hanging vertices") {
    FieldMesh empty;
    empty.point_fields.push_back({"u", 1, {}});
    const std::vector<FieldMesh> steps = {quadtree(0, 0, 1, 1, empty), quadtree(0, 0, 1, 5, empty)};
    const FieldMesh whole = quadtree(0, 0, 1, 0, empty);
    const Hierarchy roots = square_roots(1);
    SeriesOptions options;
    options.tolerance = 0;
    options.roots = &roots;
    const Recovered result = recovered(steps, options);
    const Hierarchy& key = result.keys[1];
    CHECK(check(key).empty());
    CHECK(result.report.steps[1].largest_difference < 1e-9);
    // The places of all corners of cells are vertices.
    std::set<std::pair<float, float>> vertices;
    for (const glm::vec3& position : key.positions) vertices.emplace(position.x, position.y);
    for (const glm::dvec3& point : steps[1].points)
        CHECK(vertices.contains({static_cast<float>(point.x), static_cast<float>(point.y)}));
    CHECK(whole.triangles.size() == 2);

    options.tolerance.reset();
    CHECK_THROWS_WITH_AS(recovered({steps[1]}, options), doctest::Contains("hanging vertex"), InputError);
}

TEST_CASE("a displacement is sampled, too") {
    std::mt19937 random(5);
    auto steps = foreign_steps(random);
    for (FieldMesh& step : steps) {
        MeshField field{"d", 3, {}};
        for (const glm::dvec3& point : step.points) field.values.insert(field.values.end(), {0, 0, point.x});
        step.point_fields.push_back(field);
    }
    SeriesOptions options;
    options.tolerance = 0.05;
    options.displacement = "d";
    for (const Hierarchy& key : recovered(steps, options).keys)
        for (const glm::vec3& position : key.positions)
            CHECK(position.z == doctest::Approx(position.x).epsilon(1e-6));
}

TEST_CASE("a tolerance that no reasonable key can meet is refused") {
    // Two triangles with a jump between them, because their common edge hangs.
    FieldMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}},
                   {{1, 2, 0}, {4, 2, 3}, {4, 3, 0}},
                   {},
                   {{"u", 1, {0, 0, 0, 0, 1}}},
                   {}};
    const Hierarchy roots = square_roots(3);
    SeriesOptions options;
    options.tolerance = 0.01;
    options.roots = &roots;
    CHECK_THROWS_WITH_AS(recovered({mesh}, options), doctest::Contains("larger tolerance"), InputError);
}

}  // namespace
}  // namespace interleaf
