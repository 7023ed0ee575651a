// Writes the hierarchy files of the corpus into the folders plain/ and compressed/ of a given folder, and
// meshes of odd forms into obj/ and surface/. All other files are text, kept as they are.
#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "hierarchy/adaptive_mesh.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/samples.h"
#include "shapes/brezel.h"
#include "shapes/shapes.h"

namespace {

using namespace interleaf;

/// Two triangles that share an edge. The first leaf is bisected until the key has the largest possible depth.
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

/// A closed surface and a separate open surface.
Hierarchy two_components() {
    return unrefined(RootComplex(7, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}, {4, 5, 6}}),
                     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}, {3, 0, 0}, {2, 1, 0}});
}

/// Coordinates that lie on no grid: the extremes and both zeros.
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

/// The bytes of a tetrahedron in all formats.
constexpr std::array<std::array<float, 3>, 4> corners{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr std::array<Triangle, 4> faces{{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};

template <typename Number>
void append(std::string& bytes, Number number, bool big_endian) {
    auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    if (big_endian) std::reverse(raw.begin(), raw.end());
    bytes.append(raw.data(), raw.size());
}

std::string binary_off(bool has_colors) {
    std::string bytes = has_colors ? "NCOFF BINARY\n" : "OFF BINARY\n";
    for (const std::uint32_t count : {4U, 4U, 6U}) append(bytes, count, true);
    for (const auto& corner : corners) {
        for (const float coordinate : corner) append(bytes, coordinate, true);
        for (int i = 0; has_colors && i < 7; ++i) append(bytes, 0.5F, true);
    }
    for (const Triangle& face : faces) {
        append(bytes, std::uint32_t{3}, true);
        for (const Index corner : face) append(bytes, corner, true);
        append(bytes, std::uint32_t{1}, true);
        append(bytes, std::uint32_t{7}, true);
    }
    return bytes;
}

/// A binary STL whose header begins with "solid", with \p more bytes after the last triangle.
std::string binary_stl(std::uint32_t count, std::size_t more) {
    std::string bytes = "solid tetrahedron" + std::string(63, '\0');
    append(bytes, count, false);
    for (const Triangle& face : faces) {
        bytes.append(12, '\0');
        for (const Index corner : face)
            for (const float coordinate : corners.at(corner)) append(bytes, coordinate, false);
        bytes.append(2, '\0');
    }
    return bytes + std::string(more, '\x01');
}

std::string binary_strips(bool big_endian) {
    std::string bytes = fmt::format(
        "ply\nformat binary_{}_endian 1.0\nelement vertex 4\nproperty double x\nproperty float y\n"
        "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n",
        big_endian ? "big" : "little");
    for (const auto& corner : corners) {
        append(bytes, double{corner[0]}, big_endian);
        append(bytes, corner[1], big_endian);
        append(bytes, corner[2], big_endian);
    }
    for (const std::int32_t number : {11, 0, 2, 1, 3, -1, 0, 1, 3, 3, 2, 0})
        append(bytes, number, big_endian);
    return bytes;
}

std::string utf16(std::string_view text) {
    std::string bytes = "\xff\xfe";
    for (const char c : text) bytes += {c, '\0'};
    return bytes;
}

std::map<std::string, std::string> odd_meshes() {
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
    const std::string obj = vertices + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    std::string cr = obj;
    std::ranges::replace(cr, '\n', '\r');
    const std::string off = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1\n2 3\n3 2 0 3\n";
    std::string comb = "v 40 -1 0\nv 0 -1 0\n";
    std::string corners_of_comb = "f 1 2";
    for (int i = 0; i <= 40; ++i) {
        comb += fmt::format("v {} {} 0\n", i, i % 2 == 0 ? 0 : 9);
        corners_of_comb += fmt::format(" {}", i + 3);
    }
    const std::string strips =
        "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement tristrips 1\n"
        "property list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
        "11 0 2 1 3 -1 0 1 3 3 2 0\n";
    std::string cr_strips = "ply\nformat ascii 1.0\n" + strips;
    std::ranges::replace(cr_strips, '\n', '\r');
    return {
        {"obj/continued.obj", vertices + "f 1 \\\n3 2\nf 1 2\\\n 4\nusemtl a\\\nf 2 3 4 # \\\nf 3 1 4\n"},
        {"obj/commas.obj", "v 0, 0, 0,\nv 1, 0, 0\nv 0, 1, 0\nf 1, 2, 3\n"},
        {"obj/colors.obj", "v 0 0 0 255 0 0\nv 1 0 0 0 1.5 nan\nv 0 1 0 -0.1 0 0\nf 1 2 3\n"},
        {"obj/nan.obj", vertices + "v nan -inf 1.#QNAN\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"},
        {"obj/mark.obj", "\xef\xbb\xbf" + obj},
        {"obj/cr.obj", cr},
        {"obj/utf-16.obj", utf16(obj)},
        {"obj/far.obj", "v 500000.125 5400000.5 300\nv 500001 5400000 300\nv 500000 5400001 300\nf 1 2 3\n"},
        {"obj/keyhole.obj",
         "v 0 0 0\nv 6 0 0\nv 6 6 0\nv 0 6 0\nv 2 2 0\nv 2 4 0\nv 4 4 0\nv 4 2 0\nf 1 2 3 4 1 5 6 7 8 5\n"},
        {"obj/slit.obj", "v 0 0 0\nv 6 0 0\nv 6 3 0\nv 3 3 0\nv 6 6 0\nv 0 6 0\nf 1 2 3 4 3 5 6\n"},
        {"obj/comb.obj", comb + corners_of_comb + "\n"},
        {"surface/binary.off", binary_off(false)},
        {"surface/binary-ncoff.off", binary_off(true)},
        {"surface/glued.off", "OFF4 4 6\n" + off},
        {"surface/no-header.off", "4 4 6\n" + off},
        {"surface/stncoff.off",
         "STNCOFF\n3 1 0\n0 0 0 255 0 51 255 0 0 1 0.5 0.5\n1 0 0 1 0.5 0 0 0 1 0 0\n0 1 0 9 9 9 0 0 1 0 "
         "0\n3 0 1 2 1 0 0\n"},
        {"surface/star.off",
         "OFF\n8 1 0\n3 0 0\n1 1 0\n0 3 0\n-1 1 0\n-3 0 0\n-1 -1 0\n0 -3 0\n1 -1 0\n8 0 1 2 3 4 5 6 7\n"},
        {"surface/zero.stl", binary_stl(0, 0)},
        {"surface/unknown.stl", binary_stl(0xffffffff, 0)},
        {"surface/trailing.stl", binary_stl(4, 46)},
        {"surface/one-line.stl",
         " SOLID a FACET NORMAL 0 0 1 OUTER LOOP VERTEX 0 0 0 VERTEX 1 0 0 VERTEX 0 1 0 ENDLOOP ENDFACET "
         "ENDSOLID"},
        {"surface/utf-16.stl",
         utf16("solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendsolid\n")},
        {"surface/strips.ply", "ply\nformat ascii 1.0\nmade by hand\n" + strips},
        {"surface/cr-strips.ply", cr_strips},
        {"surface/strips-little.ply", binary_strips(false)},
        {"surface/strips-big.ply", binary_strips(true)},
        {"surface/points.ply",
         "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float "
         "z\nend_header\n0 0 nan\n"},
    };
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
    for (const auto& [name, bytes] : odd_meshes()) {
        std::filesystem::create_directories((folder / name).parent_path());
        std::ofstream(folder / name, std::ios::binary) << bytes;
    }
    return 0;
}
