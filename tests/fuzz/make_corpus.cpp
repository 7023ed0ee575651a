// Writes the hierarchy files of the corpus into the folders plain/ and compressed/ of a given folder. The
// files of other targets are text, kept as they are.
#include <filesystem>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "hierarchy/adaptive_mesh.h"
#include "io/hierarchy_file.h"
#include "io/samples.h"
#include "shapes/brezel.h"
#include "shapes/shapes.h"

namespace {

using namespace interleaf;

/// Two triangles that share an edge, the first leaf bisected again and again: as deep as a key can be.
Hierarchy deep_key() {
    const std::vector<glm::vec3> corners{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    std::vector<glm::vec3> positions = corners;
    const auto midpoint = [&](Index a, Index b, Index) {
        positions.push_back(0.5F * (positions[a] + positions[b]));
        return positions.back();
    };
    AdaptiveMesh mesh(RootComplex(4, {{1, 2, 0}, {3, 0, 2}}), corners, midpoint);
    for (unsigned level = 0; level + 1 < max_level; ++level) mesh.refine({{Index{0}}});
    return mesh.freeze();
}

/// A closed surface and an open one, apart.
Hierarchy two_components() {
    return unrefined(RootComplex(7, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}, {4, 5, 6}}),
                     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}});
}

/// Coordinates that lie on no grid: the extremes, and both zeros.
Hierarchy odd_floats() {
    using Limits = std::numeric_limits<float>;
    Hierarchy key = two_components();
    key.positions[0] = {Limits::max(), Limits::lowest(), -0.0F};
    key.positions[1] = {Limits::denorm_min(), -Limits::denorm_min(), Limits::min()};
    return key;
}

std::map<std::string, Hierarchy> keys() {
    std::mt19937 random(1);
    std::map<std::string, Hierarchy> result;
    result["triangle"] = unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    result["two-components"] = two_components();
    result["odd-floats"] = odd_floats();
    result["deep"] = deep_key();
    for (const int rounds : {0, 1, 5, 20, 60}) {
        result[fmt::format("closed-{}", rounds)] = random_hierarchy(random, false, rounds);
        result[fmt::format("open-{}", rounds)] = random_hierarchy(random, true, rounds);
    }
    result["star"] = make_key(*find_shape("star"), {.leaves = 200, .tolerance = {}});
    result["brezel"] = make_key(*find_shape("brezel"), {.leaves = 144, .tolerance = {}});
    return result;
}

}  // namespace

int main(int argument_count, char** arguments) {
    if (argument_count != 2) {
        fmt::print(stderr, "usage: {} FOLDER\n", arguments[0]);
        return 2;
    }
    const std::filesystem::path folder = arguments[1];
    std::filesystem::create_directories(folder / "plain");
    std::filesystem::create_directories(folder / "compressed");
    for (const auto& [name, key] : keys()) {
        write_hierarchy(key, folder / "plain" / (name + ".ilh"));
        for (const unsigned bits : {0U, 10U})
            write_hierarchy(key, folder / "compressed" / fmt::format("{}-{}.ilh", name, bits),
                            {.compressed = true, .rounding_bits = bits});
    }
    return 0;
}
