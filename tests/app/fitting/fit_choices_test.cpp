// Tests of the conversion of the user's choices in the fit dialog.
#include "app/fitting/fit_choices.h"

#include <algorithm>
#include <string>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "app/sample_family.h"
#include "fit/sphere_map/alignment.h"
#include "hierarchy/error.h"
#include "shapes/icosahedron.h"

using namespace interleaf;

namespace {

const SphereRoots& roots_called(const char* name) {
    return find_roots(name)->roots;
}

std::vector<double> distances_from(const SphereRoots& roots, const glm::dvec3& point) {
    std::vector<double> distances;
    for (const glm::dvec3& root : roots.points) distances.push_back(glm::distance(root, point));
    return distances;
}

std::string fault_with(const std::string& leaves, const std::string& degrees = "0") {
    FitChoices choices;
    choices.leaves = leaves;
    choices.turns = {{.axis = 0, .degrees = degrees}};
    return fault_of(choices, roots_called("cube"), {"cow.off"});
}

}  // namespace

TEST_CASE("what cannot be fitted is named with what was expected") {
    CHECK(fault_with("12").empty());
    CHECK(fault_with("20000", "-90.5").empty());
    CHECK(fault_with("1e6").empty());
    for (const char* leaves : {"", "11", "-20", "1e-4", "1.5", "1e8", "20000 ", "10000001", "many"})
        CHECK(fault_with(leaves) == "Leaves: expected 12, the number of roots, to 10000000");
    for (const char* degrees : {"", "x", "361", "nan", "-360.5", "90,"})
        CHECK(fault_with("20000", degrees) == "Turn: expected -360 to 360 degrees for cow.off");

    FitChoices choices;
    choices.by_tolerance = true;
    choices.leaves = "none of its business";
    CHECK(fault_of(choices, roots_called("cube"), {}).empty());
    for (const char* percent : {"0", "", "0.0001", "nan", "101"}) {
        choices.tolerance = percent;
        CHECK(fault_of(choices, roots_called("cube"), {}) ==
              "Tolerance: expected 0.001 to 100 % of the box diagonal");
    }
}

TEST_CASE("choices become the options of the fit, the tolerance as a part instead of percent") {
    FitChoices choices;
    choices.leaves = "1.5e5";
    CHECK(fit_options(choices, roots_called("octahedron")).leaves == 150'000);
    choices.leaves = "321";
    const FitOptions by_leaves = fit_options(choices, roots_called("octahedron"));
    CHECK(by_leaves.leaves == Index{321});
    CHECK_FALSE(by_leaves.tolerance);
    CHECK(by_leaves.roots.complex == interleaf::octahedron().roots);

    choices.by_tolerance = true;
    choices.tolerance = "0.25";
    const FitOptions by_tolerance = fit_options(choices, roots_called("cube"));
    CHECK_FALSE(by_tolerance.leaves);
    CHECK(*by_tolerance.tolerance == doctest::Approx(0.0025));
}

TEST_CASE("edges over a mesh lie where the turned map takes the mesh to the edges of the roots") {
    const FitChoices::Turn turn{.axis = 2, .degrees = "35"};
    const SphereRoots& roots = roots_called("cube");
    const auto edges = edges_over_mesh(roots, turn);
    CHECK(edges.size() == 18);
    for (const auto& ends : edges)
        for (const glm::vec3& end : ends) {
            // What fit() does with a point of the sphere that is aligned with the mesh.
            std::vector<glm::dvec3> points{end};
            rotate(points, rotation_of(turn));
            const double least = std::ranges::min(distances_from(roots, points.front()));
            CHECK(least < 1e-6);
        }
}

TEST_CASE("meshes are fitted over the roots that the family has") {
    Family family{
        .name = "two", .keys = {{"a", icosahedron()}, {"b", icosahedron()}}, .timeline = {}, .domain = {}};
    CHECK(roots_of(family).name == "icosahedron");

    // In another order they are roots of their own, called as the key is.
    Hierarchy other = interleaf::octahedron();
    std::vector<Triangle> triangles(other.roots.triangles().begin(), other.roots.triangles().end());
    std::ranges::rotate(triangles, triangles.begin() + 1);
    family.keys = {
        {"mine", unrefined(RootComplex(6, triangles), {other.positions.begin(), other.positions.end()})}};
    const NamedRoots mine = roots_of(family);
    CHECK(mine.name == "mine");
    CHECK(mine.roots.complex == family.keys[0].hierarchy->roots);

    // An open surface covers no sphere.
    family = sample_family();
    CHECK_THROWS_AS(roots_of(family), InputError);
}
