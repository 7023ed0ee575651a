#include "shapes/shapes.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <doctest/doctest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/measure.h"
#include "io/hierarchy/hierarchy_file.h"
#include "shapes/bisection_of_sphere.h"
#include "shapes/icosahedron.h"
#include "shapes/leaf_fit.h"
#include "shapes/leaf_triangles.h"

using namespace interleaf;

namespace {

ShapeBudget leaves(Index count) {
    return {count, std::nullopt};
}

ShapeBudget tolerance(double value) {
    return {std::nullopt, value};
}

Hierarchy make(std::string_view name, const ShapeBudget& budget) {
    const Shape* shape = find_shape(name);
    REQUIRE(shape != nullptr);
    return make_key(*shape, budget);
}

/// All shapes except the brezel, which has its own tests.
std::vector<Shape> shapes_over_the_icosahedron() {
    std::vector<Shape> found;
    for (const Shape& shape : shapes())
        if (shape.base.roots == icosahedron) found.push_back(shape);
    return found;
}

Measures measure_key(const Hierarchy& key) {
    return measure(leaf_triangles(key), key.positions);
}

void check_is_closed_key(const Hierarchy& key) {
    CHECK(check(key).empty());
    CHECK(key.roots == icosahedron().roots);
    const auto triangles = leaf_triangles(key);
    CHECK(is_closed_manifold(triangles));
    CHECK(euler_number(triangles) == 2);
    CHECK(measure(triangles, key.positions).volume > 0);
}

/// The surface's normal at the point over \p u by central differences; not normalized.
glm::dvec3 normal_over(Surface surface, const glm::dvec3& u) {
    constexpr double step = 1e-5;
    const glm::dvec3 across = std::abs(u.x) < 0.7 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 s = step * glm::normalize(glm::cross(across, u));
    const glm::dvec3 t = glm::cross(u, s);
    const auto at = [&](const glm::dvec3& v) { return surface(glm::normalize(v)); };
    return glm::cross(at(u + s) - at(u - s), at(u + t) - at(u - t));
}

/// Largest distance of the surface from the key, as a fraction of the diagonal of the samples' box. Samples
/// leaf by leaf; the sampling grid shares only corners with the generator's grid.
double sampled_deviation(const Hierarchy& key, Surface surface) {
    glm::dvec3 low(std::numeric_limits<double>::infinity());
    glm::dvec3 high = -low;
    double distance = 0;
    for (const SphereLeaf& leaf : sphere_leaves(key)) {
        for (const glm::dvec3& u : base_grid(unit_sphere, leaf.on_sphere, 13)) {
            const glm::dvec3 point = surface(u);
            low = glm::min(low, point);
            high = glm::max(high, point);
            distance = std::max(distance, distance_to_triangle(point, leaf.on_key));
        }
    }
    return distance / glm::distance(low, high);
}

}  // namespace

TEST_CASE("shapes are found by name, each once") {
    std::set<std::string_view> names;
    for (const Shape& shape : shapes()) {
        CHECK(find_shape(shape.name) == &shape);
        CHECK_FALSE(shape.description.empty());
        names.insert(shape.name);
    }
    CHECK(names == std::set<std::string_view>{"icosahedron", "bone", "cushion", "star", "sphere", "brezel"});
    CHECK(find_shape("Star") == nullptr);
    CHECK(find_shape("") == nullptr);
}

TEST_CASE(
    "every key over the icosahedron is sound, closed, of Euler number 2, faces out, and meets its budget of "
    "leaves") {
    for (const Shape& shape : shapes_over_the_icosahedron()) {
        CAPTURE(shape.name);
        for (const Index budget : {20U, 21U, 100U, 1001U, 6000U}) {
            CAPTURE(budget);
            const Hierarchy key = make_key(shape, leaves(budget));
            check_is_closed_key(key);
            if (shape.surface == nullptr) {
                CHECK(key.leaf_count() == 20);
                continue;
            }
            CHECK(key.leaf_count() <= budget);
            CHECK(key.leaf_count() + 2 >= budget);
        }
    }
}

TEST_CASE("a key has 20,000 leaves if the budget sets neither leaves nor tolerance") {
    const std::size_t count = make("sphere", {}).leaf_count();
    CHECK(count <= 20000);
    CHECK(count + 2 >= 20000);
}

TEST_CASE("positions are on the surface, to the precision of floats") {
    for (const Shape& shape : shapes_over_the_icosahedron()) {
        if (shape.surface == nullptr) continue;
        CAPTURE(shape.name);
        for (const SphereLeaf& leaf : sphere_leaves(make_key(shape, leaves(2000)))) {
            for (unsigned i = 0; i < 3; ++i) {
                CHECK(glm::distance(shape.surface(leaf.on_sphere[i]), leaf.on_key[i]) < 2.5e-7);
            }
        }
    }
}

TEST_CASE("no leaf is flipped against the surface, and each shape reaches its possible minimum angle") {
    const auto check_quality = [](std::string_view name, double min_angle) {
        CAPTURE(name);
        const Hierarchy key = make(name, leaves(12000));
        CHECK(measure_key(key).min_angle > min_angle);
        const Surface surface = find_shape(name)->surface;
        std::size_t flipped = 0;
        for (const auto& [on_sphere, on_key] : sphere_leaves(key)) {
            const glm::dvec3 normal = glm::cross(on_key[1] - on_key[0], on_key[2] - on_key[0]);
            const glm::dvec3 middle = glm::normalize(on_sphere[0] + on_sphere[1] + on_sphere[2]);
            if (glm::dot(normal, normal_over(surface, middle)) <= 0) ++flipped;
        }
        CHECK(flipped == 0);
    };
    check_quality("sphere", 24.5);
    check_quality("cushion", 15.5);
    check_quality("star", 12);
    check_quality("bone", 3.5);
}

TEST_CASE("area and volume of the sphere key are near those of the unit sphere") {
    const Measures measures = measure_key(make("sphere", leaves(20000)));
    const double pi = std::acos(-1.0);
    CHECK(measures.area == doctest::Approx(4 * pi).epsilon(5e-4));
    CHECK(measures.area < 4 * pi);
    CHECK(measures.volume == doctest::Approx(4 * pi / 3).epsilon(1e-3));
    CHECK(measures.volume < 4 * pi / 3);
}

TEST_CASE("a tolerance holds on dense samples of the surface, without far too many leaves") {
    for (const Shape& shape : shapes_over_the_icosahedron()) {
        if (shape.surface == nullptr) continue;
        CAPTURE(shape.name);
        for (const double value : {0.1, 0.02, 0.005, 0.001}) {
            CAPTURE(value);
            const Hierarchy key = make_key(shape, tolerance(value));
            check_is_closed_key(key);
            const double deviation = sampled_deviation(key, shape.surface);
            CHECK(deviation <= value);
            CHECK(deviation >= value / 4);
        }
    }
}

TEST_CASE("more leaves lie nearer to the surface") {
    for (const Shape& shape : shapes_over_the_icosahedron()) {
        if (shape.surface == nullptr) continue;
        CAPTURE(shape.name);
        const double coarse = sampled_deviation(make_key(shape, leaves(500)), shape.surface);
        const double fine = sampled_deviation(make_key(shape, leaves(5000)), shape.surface);
        CHECK(fine < coarse / 4);
    }
}

TEST_CASE("the star key has twelve arms, even with few leaves") {
    for (const Index budget : {500U, 5000U}) {
        CAPTURE(budget);
        const Hierarchy key = make("star", leaves(budget));
        std::vector<bool> is_tip(key.vertex_count(), true);
        for (const Triangle& triangle : leaf_triangles(key)) {
            for (unsigned i = 0; i < 3; ++i) {
                const Index a = triangle[i];
                const Index b = triangle[(i + 1) % 3];
                const bool rises = glm::length(key.positions[a]) < glm::length(key.positions[b]);
                is_tip[rises ? a : b] = false;
            }
        }
        CHECK(std::count(is_tip.begin(), is_tip.end(), true) == 12);
        CHECK(bounding_box(key.positions).diagonal() > 4);
    }
}

TEST_CASE("a key has the same bytes every time") {
    for (const Shape& shape : shapes()) {
        CAPTURE(shape.name);
        CHECK(serialize_hierarchy(make_key(shape, leaves(3000))) ==
              serialize_hierarchy(make_key(shape, leaves(3000))));
    }
}

TEST_CASE("two budgets at once, and budgets out of range, are rejected") {
    const Shape& star = *find_shape("star");
    CHECK_THROWS_WITH_AS(make_key(star, {100, 0.1}), doctest::Contains("exclude each other"), UsageError);
    CHECK_THROWS_WITH_AS(make_key(star, leaves(19)), doctest::Contains("20 roots"), UsageError);
    CHECK_THROWS_WITH_AS(make_key(star, tolerance(0)), doctest::Contains("at least"), UsageError);
    CHECK_THROWS_AS(make_key(star, tolerance(-1)), UsageError);
    CHECK_THROWS_AS(make_key(star, tolerance(std::nan(""))), UsageError);
    CHECK_THROWS_AS(make_key(*find_shape("icosahedron"), {100, 0.1}), UsageError);
}
