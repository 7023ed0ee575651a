// The alternative without a common hierarchy. To blend two surfaces with different meshes, the vertices of
// one mesh are located on the other by closest point, with CGAL's AABB tree (Alliez, Tayeb, Wormser), and
// carry the blend on their own mesh. The comparison with the union covers time and distance from the true
// blend.
//
// There are two pairs of keys, each with N leaves (the argument; 20,000 by default), and two ways to locate.
// One is on the unit sphere, where both keys have the points that their vertices were made from, a common
// parametrization that is rarely available. The other is in space, from surface to surface. The true blend is
// that of the two formulas, over the sphere.
//
// Prints one line of JSON. Errors are fractions of the diagonal of the true blend's box.
#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <exception>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "closest_surface.h"
#include <CGAL/version.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "hierarchy/union_mesh.h"
#include "shapes/shapes.h"
#include "text/parsed_number.h"

namespace {

using namespace interleaf;
using namespace interleaf::bench;
using Json = nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

/// A plain surface with one that has features, and two surfaces with features in different places.
constexpr std::array<std::pair<const char*, const char*>, 2> pairs_of_shapes = {
    {{"sphere", "star"}, {"star", "bone"}}};
constexpr int repetitions = 5;
constexpr Index truth_leaves = 200000;

/// A key as a plain mesh, and the points of the unit sphere that its vertices were made from.
struct KeyMesh {
    Mesh surface;
    Points sphere;
};

double median_seconds(const std::function<void()>& measured) {
    std::array<double, repetitions> seconds{};
    for (double& each : seconds) {
        const Clock::time_point start = Clock::now();
        measured();
        each = std::chrono::duration<double>(Clock::now() - start).count();
    }
    std::sort(seconds.begin(), seconds.end());
    return seconds[repetitions / 2];
}

/// The points of the sphere for the vertices of a union, as make_key() makes them: midpoints of edges,
/// projected.
Points sphere_points(const UnionMesh& mesh) {
    const Hierarchy roots = unit_sphere.roots();
    Points points;
    for (Index vertex = 0; vertex < mesh.vertex_count(); ++vertex) {
        const auto [a, b] = mesh.vertices[vertex].edge;
        const glm::dvec3 near = a == no_index ? glm::dvec3(roots.positions[vertex]) : points[a] + points[b];
        points.push_back(glm::normalize(near));
    }
    return points;
}

KeyMesh key_mesh(const Hierarchy& key) {
    const UnionMesh mesh = unite(std::array{&key});
    const auto& positions = mesh.positions[0];
    return {{{mesh.triangles.begin(), mesh.triangles.end()}, {positions.begin(), positions.end()}},
            sphere_points(mesh)};
}

/// For each of \p queries, the point of \p surface at the place of its location on \p located_on; both have
/// the same triangles.
Points carried_over(const Points& queries, const ClosestSurface& located_on, const Mesh& surface) {
    Points carried;
    carried.reserve(queries.size());
    for (const glm::dvec3& query : queries) {
        const auto [triangle, b] = located_on.locate(query);
        const auto& [i, j, k] = surface.triangles[triangle];
        carried.push_back(b[0] * surface.points[i] + b[1] * surface.points[j] + b[2] * surface.points[k]);
    }
    return carried;
}

Mesh blended(const std::vector<Triangle>& triangles, const Points& first, const Points& second, double t) {
    Mesh mesh{triangles, {}};
    for (std::size_t i = 0; i < first.size(); ++i) mesh.points.push_back((1 - t) * first[i] + t * second[i]);
    return mesh;
}

/// The blend of the two formulas, on the union of keys with many leaves.
class Truth {
  public:
    Truth(const Shape& first, const Shape& second) {
        const Hierarchy fine_first = make_key(first, {truth_leaves, {}});
        const Hierarchy fine_second = make_key(second, {truth_leaves, {}});
        const UnionMesh mesh = unite(std::array{&fine_first, &fine_second});
        triangles_.assign(mesh.triangles.begin(), mesh.triangles.end());
        for (const glm::dvec3& u : sphere_points(mesh)) {
            first_.push_back(first.surface(u));
            second_.push_back(second.surface(u));
        }
    }

    Reference at(double t) const { return Reference(blended(triangles_, first_, second_, t)); }

  private:
    std::vector<Triangle> triangles_;
    Points first_;
    Points second_;
};

/// A way to blend: a mesh with the positions of both keys at its vertices.
struct Method {
    const char* name;
    std::vector<Triangle> triangles;
    Points first;
    Points second;
};

struct Located {
    Json seconds;
    std::array<Method, 2> methods;  ///< the blend on the first key's mesh, and on the second's
};

/// Locates the vertices of each key on the other key.
/// \param place  the points of a key to use
Located locate(const KeyMesh& first, const KeyMesh& second, const Points& (*place)(const KeyMesh&),
               std::array<const char*, 2> names) {
    std::optional<ClosestSurface> on_first;
    std::optional<ClosestSurface> on_second;
    Points first_on_second;
    Points second_on_first;
    Json seconds = {
        {"trees", median_seconds([&] {
             on_first.emplace(first.surface.triangles, place(first));
             on_second.emplace(second.surface.triangles, place(second));
         })},
        {"first_on_second",
         median_seconds([&] { first_on_second = carried_over(place(first), *on_second, second.surface); })},
        {"second_on_first",
         median_seconds([&] { second_on_first = carried_over(place(second), *on_first, first.surface); })}};
    return {std::move(seconds),
            {{{names[0], first.surface.triangles, first.surface.points, first_on_second},
              {names[1], second.surface.triangles, second_on_first, second.surface.points}}}};
}

Json to_json(const Error& error) {
    return {{"largest", error.largest}, {"root_mean_square", error.root_mean_square}};
}

/// The union of the keys; writes its time to \p figures.
Method united(const Hierarchy& first, const Hierarchy& second, Json& figures) {
    const std::array keys = {&first, &second};
    UnionMesh mesh;
    figures["seconds"]["union"] = median_seconds([&] { mesh = unite(keys); });
    figures["seconds"]["union_memory_reused"] = median_seconds([&] { unite(keys, mesh); });
    const auto points = [&](std::size_t key) {
        return Points(mesh.positions[key].begin(), mesh.positions[key].end());
    };
    return {"union", {mesh.triangles.begin(), mesh.triangles.end()}, points(0), points(1)};
}

Json errors_of(std::span<const Method> methods, const Truth& truth, const KeyMesh& first,
               const KeyMesh& second) {
    Json errors;
    const auto add = [&](const Method& method, const char* what, const Reference& reference, double t) {
        const Mesh result = blended(method.triangles, method.first, method.second, t);
        errors[method.name][what] = to_json(reference.error_of(result));
    };
    for (const Method& method : methods) errors[method.name]["leaves"] = method.triangles.size();
    const std::array truths = {std::pair("from_truth_at_0", 0.0), std::pair("from_truth_at_0.5", 0.5),
                               std::pair("from_truth_at_1", 1.0)};
    for (const auto& [what, t] : truths) {
        const Reference reference = truth.at(t);
        for (const Method& method : methods) add(method, what, reference, t);
    }
    const Reference first_key(first.surface);
    const Reference second_key(second.surface);
    for (const Method& method : methods) {
        add(method, "from_first_key_at_0", first_key, 0);
        add(method, "from_second_key_at_1", second_key, 1);
    }
    return errors;
}

Json measure(const Shape& first_shape, const Shape& second_shape, Index leaves) {
    const Hierarchy first = make_key(first_shape, {leaves, {}});
    const Hierarchy second = make_key(second_shape, {leaves, {}});
    const KeyMesh first_mesh = key_mesh(first);
    const KeyMesh second_mesh = key_mesh(second);

    Json figures = {{"first", first_shape.name}, {"second", second_shape.name}};
    figures["leaves"] = {first.leaf_count(), second.leaf_count()};
    std::vector<Method> methods = {united(first, second, figures)};
    const auto on_sphere = [](const KeyMesh& key) -> const Points& { return key.sphere; };
    const auto in_space = [](const KeyMesh& key) -> const Points& { return key.surface.points; };
    const Located by_sphere =
        locate(first_mesh, second_mesh, on_sphere, {"on_sphere_first_mesh", "on_sphere_second_mesh"});
    const Located by_space =
        locate(first_mesh, second_mesh, in_space, {"in_space_first_mesh", "in_space_second_mesh"});
    figures["seconds"]["on_sphere"] = by_sphere.seconds;
    figures["seconds"]["in_space"] = by_space.seconds;
    methods.insert(methods.end(), by_sphere.methods.begin(), by_sphere.methods.end());
    methods.insert(methods.end(), by_space.methods.begin(), by_space.methods.end());
    figures["results"] = errors_of(methods, Truth(first_shape, second_shape), first_mesh, second_mesh);
    return figures;
}

}  // namespace

int main(int argument_count, char** arguments) {
    Index leaves = 20000;
    if (argument_count > 1) {
        if (argument_count > 2 || parse_all(arguments[1], leaves) != std::errc()) {
            std::fputs("usage: peer_closest_point [LEAVES]\n", stderr);
            return 2;
        }
    }
    try {
        Json pairs = Json::array();
        for (const auto& [first, second] : pairs_of_shapes)
            pairs.push_back(measure(*find_shape(first), *find_shape(second), leaves));
        std::puts(Json{{"peer", "CGAL " CGAL_VERSION_STR}, {"pairs", pairs}}.dump().c_str());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "peer_closest_point: %s\n", error.what());
        return 1;
    }
    return 0;
}
