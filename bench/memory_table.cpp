// The table of the paper's appendix, "Space Requirements", compared with the same hierarchies here. Prints
// one line of JSON.
//
// Memory depends only on the numbers of roots, leaves and vertices. So each hierarchy has the paper's numbers
// of roots and leaves, over any surface: sphere and brezel are the generated ones, and a star over a globe
// replaces the bunnies, with as many triangles as the bunny has roots. (Compressed files depend on the
// surface as well.) The comparison uses leaves and bytes, not vertices, because the printed numbers of
// vertices do not satisfy Euler's formula.
//
// A megabyte is 10^6 bytes. The paper does not say which unit it means, but its printed figures for the
// non-hierarchical mesh agree with this unit: 32 bytes per vertex for coordinates, normal and texture
// coordinates, 24 bytes per triangle for vertices and neighbors.
#include <array>
#include <cmath>
#include <iostream>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "hierarchy/marking.h"
#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "io/hierarchy/hierarchy_file.h"
#include "shapes/brezel.h"
#include "shapes/shapes.h"

namespace {

using namespace interleaf;
using Json = nlohmann::ordered_json;

/// A sphere of 400 triangles: 20 meridians cross 10 circles of latitude, and meet at two poles.
Hierarchy globe() {
    constexpr Index meridians = 20;
    constexpr Index rings = 10;
    constexpr Index south = meridians * rings;
    constexpr Index north = south + 1;
    const double pi = std::acos(-1.0);
    std::vector<glm::vec3> positions;
    for (Index ring = 0; ring < rings; ++ring) {
        const double latitude = pi * ((ring + 1.0) / (rings + 1) - 0.5);
        for (Index meridian = 0; meridian < meridians; ++meridian) {
            const double longitude = 2 * pi * meridian / meridians;
            positions.emplace_back(std::cos(latitude) * std::cos(longitude),
                                   std::cos(latitude) * std::sin(longitude), std::sin(latitude));
        }
    }
    positions.emplace_back(0, 0, -1);
    positions.emplace_back(0, 0, 1);

    std::vector<Triangle> triangles;
    for (Index west = 0; west < meridians; ++west) {
        const Index east = (west + 1) % meridians;
        triangles.push_back({south, east, west});
        for (Index ring = 0; ring + 1 < rings; ++ring) {
            const Index below = ring * meridians;
            const Index above = below + meridians;
            triangles.push_back({below + west, below + east, above + east});
            triangles.push_back({below + west, above + east, above + west});
        }
        triangles.push_back({north, south - meridians + west, south - meridians + east});
    }
    return unrefined(mark_compatibly(RootComplex(north + 1, std::move(triangles))), std::move(positions));
}

/// A row of the paper's table, and the shape that replaces its model.
struct Row {
    std::string_view model;
    Index roots;
    Index leaves;
    int hierarchy;  ///< megabytes, as printed: "Mem."
    int optimized;  ///< "Mem. opt.": vertex information is stored once for each refined root
    int flat;       ///< "size of non-hier. rep.", the mesh of the leaves
    BaseSurface base;
    PlainSurface surface;
};

constexpr std::array<Row, 4> table = {{
    {"bunny1", 400, 127000, 17, 13, 5, {globe, project_to_unit_sphere}, star_surface},
    {"bunny2", 400, 611340, 80, 60, 24, {globe, project_to_unit_sphere}, star_surface},
    {"sphere", 20, 204800, 27, 20, 8, unit_sphere, sphere_surface},
    {"brezel", 144, 128280, 17, 13, 5, brezel, brezel_surface},
}};

/// Bytes of the normal products of a single key.
std::size_t normal_bytes(const Hierarchy& key) {
    const std::array<const Hierarchy*, 1> keys = {&key};
    return normal_form(unite(keys)).products.size() * sizeof(glm::vec3);
}

double megabytes(std::size_t bytes) {
    return std::round(static_cast<double>(bytes) / 1e3) / 1e3;
}

Json compare(const Row& row) {
    const Hierarchy key = make_key({row.model, "", row.base, row.surface}, {row.leaves, {}});
    const std::size_t leaves = key.leaf_count();
    const std::size_t vertices = key.vertex_count();
    const std::size_t flat = leaves * sizeof(Triangle) + vertices * sizeof(glm::vec3);
    return {{"model", row.model},
            {"paper",
             {{"roots", row.roots},
              {"leaves", row.leaves},
              {"hierarchy", row.hierarchy},
              {"optimized_hierarchy", row.optimized},
              {"flat", row.flat}}},
            {"ours",
             {{"roots", key.roots.triangle_count()},
              {"leaves", leaves},
              {"vertices", vertices},
              {"hierarchy", megabytes(key.byte_count())},
              {"hierarchy_with_normals", megabytes(key.byte_count() + normal_bytes(key))},
              {"file", megabytes(serialize_hierarchy(key).size())},
              {"flat", megabytes(flat)},
              {"flat_with_normals", megabytes(flat + vertices * sizeof(glm::vec3))},
              {"flat_as_in_paper", megabytes(leaves * 24 + vertices * 32)}}}};
}

}  // namespace

int main() {
    Json rows = Json::array();
    for (const Row& row : table) rows.push_back(compare(row));
    std::cout << Json{{"megabyte", 1000000}, {"rows", rows}} << '\n';
}
