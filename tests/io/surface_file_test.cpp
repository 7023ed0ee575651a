// Readers of surfaces: each form, colours, polygons, and files that are not what they say.
#include "io/surface_file.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "messages.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/scratch_folder.h"

namespace interleaf {

namespace {

constexpr std::string_view obj =
    "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 1 1 0 0 0 1\nv 0 1 0 0.5 0.5 0.5\nv 0.5 0.5 1 1 1 1\n"
    "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
constexpr std::string_view off =
    "OFF # a pyramid\n\n5 5 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0.5 0.5 1\n"
    "4 3 2 1 0\n3 0 1 4 0.1 0.2 0.3\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
constexpr std::string_view ply =
    "ply\nformat ascii 1.0\ncomment a pyramid\nelement vertex 5\nproperty float x\nproperty float y\n"
    "property double z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
    "element face 5\nproperty uchar flags\nproperty list uchar int vertex_indices\n"
    "element edge 1\nproperty int a\nend_header\n"
    "0 0 0 255 0 0\n1 0 0 0 255 0\n1 1 0 0 0 255\n0 1 0 51 51 51\n0.5 0.5 1 255 255 255\n"
    "7 4 3 2 1 0\n7 3 0 1 4\n7 3 1 2 4\n7 3 2 3 4\n7 3 3 0 4\n99\n";

const SurfaceFile& pyramid() {
    static const SurfaceFile surface{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 1}},
                                     {{3, 2, 1}, {3, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                                     {}};
    return surface;
}

template <typename Number>
void append(std::string& bytes, Number number, bool big_endian = false) {
    char raw[sizeof number];
    std::memcpy(raw, &number, sizeof number);
    if (big_endian) std::reverse(raw, raw + sizeof number);
    bytes.append(raw, sizeof number);
}

std::string binary_stl(const SurfaceFile& surface) {
    std::string bytes(80, ' ');
    append(bytes, static_cast<std::uint32_t>(surface.triangles.size()));
    for (const Triangle& triangle : surface.triangles) {
        for (int i = 0; i < 3; ++i) append(bytes, 0.0F);
        for (const Index vertex : triangle)
            for (int axis = 0; axis < 3; ++axis)
                append(bytes, static_cast<float>(surface.positions[vertex][axis]));
        append(bytes, std::uint16_t{0});
    }
    return bytes;
}

std::string text_stl(const SurfaceFile& surface) {
    std::string text = "solid pyramid\n";
    for (const Triangle& triangle : surface.triangles) {
        text += "facet normal 0 0 0\n outer loop\n";
        for (const Index vertex : triangle)
            text += fmt::format("  vertex {} {} {}\n", surface.positions[vertex].x,
                                surface.positions[vertex].y, surface.positions[vertex].z);
        text += " endloop\nendfacet\n";
    }
    return text + "endsolid\n";
}

std::string binary_ply(const SurfaceFile& surface, bool big_endian) {
    std::string bytes = fmt::format(
        "ply\nformat binary_{}_endian 1.0\nelement vertex {}\nproperty list char short skipped\n"
        "property double x\nproperty float y\nproperty float z\nelement face {}\n"
        "property list uchar uint vertex_index\nend_header\n",
        big_endian ? "big" : "little", surface.positions.size(), surface.triangles.size());
    for (const glm::dvec3& p : surface.positions) {
        append(bytes, std::int8_t{2}, big_endian);
        append(bytes, std::int16_t{-3}, big_endian);
        append(bytes, std::int16_t{300}, big_endian);
        append(bytes, p.x, big_endian);
        append(bytes, static_cast<float>(p.y), big_endian);
        append(bytes, static_cast<float>(p.z), big_endian);
    }
    for (const Triangle& triangle : surface.triangles) {
        append(bytes, std::uint8_t{3}, big_endian);
        for (const Index vertex : triangle) append(bytes, vertex, big_endian);
    }
    return bytes;
}

void check_pyramid(const SurfaceFile& surface) {
    CHECK(surface.positions == pyramid().positions);
    CHECK(surface.triangles == pyramid().triangles);
}

/// A triangle for three vertices of its own.
void check_loose_pyramid(const SurfaceFile& surface) {
    REQUIRE(surface.triangles.size() == pyramid().triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner)
            CHECK(surface.positions[surface.triangles[t][corner]] ==
                  pyramid().positions[pyramid().triangles[t][corner]]);
}

}  // namespace

TEST_CASE("the same surface is read from every form") {
    const ScratchFolder folder;
    put(folder / "p.OBJ", obj);
    put(folder / "p.off", off);
    put(folder / "p.ply", ply);
    put(folder / "p.stl", binary_stl(pyramid()));
    const SurfaceFile from_obj = read_surface(folder / "p.OBJ");
    CHECK(from_obj.positions == pyramid().positions);
    CHECK(from_obj.triangles.size() == 6);
    check_pyramid(read_surface(folder / "p.off"));
    check_pyramid(read_surface(folder / "p.ply"));
    check_loose_pyramid(read_surface(folder / "p.stl"));
    check_loose_pyramid(parse_stl(text_stl(pyramid()), "p"));
    check_pyramid(parse_ply(binary_ply(pyramid(), false), "p"));
    check_pyramid(parse_ply(binary_ply(pyramid(), true), "p"));
}

TEST_CASE("colours are read; in an OBJ a vertex without one is white") {
    const ScratchFolder folder;
    put(folder / "p.obj", obj);
    const std::vector<glm::vec3> expected = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.5F, 0.5F, 0.5F}, {1, 1, 1}};
    CHECK(read_surface(folder / "p.obj").colors == expected);
    const SurfaceFile from_ply = parse_ply(ply, "p");
    REQUIRE(from_ply.colors.size() == 5);
    CHECK(from_ply.colors[1] == glm::vec3(0, 1, 0));
    CHECK(from_ply.colors[3].x == doctest::Approx(0.2));
    const SurfaceFile coff =
        parse_off("COFF 3 1 0\n0 0 0 255 0 51\n1 0 0 0.5 1.0 0\n0 1 0 1. 0 0\n3 0 1 2\n", "p");
    REQUIRE(coff.colors.size() == 3);
    CHECK(coff.colors[0].z == doctest::Approx(0.2));
    CHECK(coff.colors[1] == glm::vec3(0.5F, 1, 0));
    put(folder / "some.obj", "v 0 0 0 1 0 0\nv 1 0 0\nv 0 1 0 1 1 1\nf 1 2 3\n");
    CHECK(read_surface(folder / "some.obj").colors ==
          std::vector<glm::vec3>{{1, 0, 0}, {1, 1, 1}, {1, 1, 1}});
    CHECK(parse_off(off, "p").colors.empty());
}

TEST_CASE("what is wrong is said with the file, the place and what was expected") {
    struct Case {
        SurfaceFile (*parse)(std::string_view, std::string_view);
        std::string content;
        std::string_view message;
    };
    const std::string header =
        "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n";
    std::string infinite = binary_stl(pyramid());
    const float infinity = std::numeric_limits<float>::infinity();
    std::memcpy(&infinite[84 + 50 + 16], &infinity, 4);
    const Case cases[] = {
        {parse_off, "", "line 0: the file ends"},
        {parse_off, "ply\n", "line 1: \"ply\" begins the file, expected OFF"},
        {parse_off, "OFF\n3 1\n0 0 0\n1 0 0\n", "line 4: the file ends"},
        {parse_off, "OFF\n4294967295 1\n0 0 0\n", "line 3: the file ends"},
        {parse_off, "OFF\n3 1\n0 0 nan\n", "line 3: \"nan\" found, expected three finite coordinates"},
        {parse_off, "OFF\n3 1\n0 0 1e999\n", "line 3: \"1e999\" found"},
        {parse_off, "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
         "line 6: vertex 3 does not exist, there are 3"},
        {parse_off, "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n",
         "line 6: a face of 2 corners, expected 3 to 1000"},
        {parse_off, "OFF\n3 0\n0 0 0\n1 0 0\n0 1 0\n", "has no faces"},
        {parse_off, "OFF BINARY\n", "line 1: \"BINARY\" found"},
        {parse_stl, "", "size: 0 bytes, expected at least 84"},
        {parse_stl, std::string(83, 'x'), "size: 83 bytes"},
        {parse_stl, binary_stl(pyramid()) + "x", "expected 84 + 50 for each of the 6 triangles"},
        {parse_stl, infinite, "triangle 1 (counted from 0): a coordinate is not a finite number"},
        {parse_stl, std::string(84, '\0'), "has no triangles"},
        {parse_stl, "solid\nvertex 0 0\n", "line 2: \"\" is not a coordinate"},
        {parse_stl, "solid\nvertex 0 0 1\nendloop\n", "line 3: a loop of 1 vertices ends, expected 3"},
        {parse_stl, "solid\nvertex 0 0 1\n", "ends within a loop"},
        {parse_ply, "plx\n", "line 1: expected ply"},
        {parse_ply, "ply\n", "line 2: the file ends, expected end_header"},
        {parse_ply, "ply\nend_header\n", "line 2: the header ends, expected a format"},
        {parse_ply, "ply\nformat binary\n", "line 2: format \"binary\", expected ascii"},
        {parse_ply, "ply\nelement vertex -1\n", "line 2: \"-1\" found"},
        {parse_ply, "ply\nelement vertex 1\nproperty quad x\n", "line 3: \"quad\" is not a type"},
        {parse_ply, header + "end_header\n0 0\n",
         "vertex 0 (counted from 0): expected the properties x, y and z"},
        {parse_ply, header + "property float z\nend_header\n0 nan 0\n",
         "vertex 0 (counted from 0): \"nan\" found"},
        {parse_ply, header + "property float z\nend_header\n0 0\n",
         "vertex 0 (counted from 0): the file ends"},
        {parse_ply, header + "property float z\nend_header\n0 0 0\n", "has no faces"},
        {parse_ply,
         header + "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                  "0 0 0\n3 0 0 1\n",
         "a face has vertex 1, there are 1"},
        {parse_ply,
         header + "property float z\nelement face 1\nproperty list int int vertex_indices\nend_header\n"
                  "0 0 0\n2000000000 0 0 1\n",
         "face 0 (counted from 0): 2000000000 corners, expected 3 to 1000"},
        {parse_ply,
         header + "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                  "0 0 0\n3 0 0 -1\n",
         "face 0 (counted from 0): -1 found, expected a vertex"},
        {parse_ply, "ply\nformat ascii 1.0\nelement x 18446744073709551615\nend_header\n", "has no faces"},
    };
    for (const Case& each : cases) {
        CAPTURE(each.content);
        const std::string message = input_error_of([&] { each.parse(each.content, "some file"); });
        CAPTURE(message);
        CHECK(message.starts_with("some file: "));
        CHECK(contains(message, each.message));
        CHECK_FALSE(contains(message, "\n"));
    }
    const ScratchFolder folder;
    put(folder / "m.txt", "OFF");
    CHECK(contains(input_error_of([&] { read_surface(folder / "m.txt"); }), "expected a mesh called .obj"));
}

TEST_CASE("files that were changed at random are read, or refused, and nothing else") {
    const std::uint32_t seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    struct Form {
        SurfaceFile (*parse)(std::string_view, std::string_view);
        std::string content;
    };
    const Form forms[] = {{parse_off, std::string(off)},
                          {parse_ply, std::string(ply)},
                          {parse_ply, binary_ply(pyramid(), false)},
                          {parse_ply, binary_ply(pyramid(), true)},
                          {parse_stl, binary_stl(pyramid())},
                          {parse_stl, text_stl(pyramid())}};
    for (const Form& form : forms) {
        int read = 0;
        for (int trial = 0; trial < 3000; ++trial) {
            std::string content = form.content;
            for (unsigned changes = 1 + random() % 4; changes > 0 && !content.empty(); --changes) {
                const std::size_t at = random() % content.size();
                switch (random() % 4) {
                    case 0:
                        content[at] = static_cast<char>(random());
                        break;
                    case 1:
                        content.insert(at, std::to_string(random()));
                        break;
                    case 2:
                        content.erase(at, 1 + random() % 20);
                        break;
                    default:
                        content[at] = static_cast<char>('0' + random() % 10);
                }
            }
            try {
                const SurfaceFile surface = form.parse(content, "file");
                ++read;
                bool sound = surface.colors.empty() || surface.colors.size() == surface.positions.size();
                for (const Triangle& triangle : surface.triangles)
                    for (const Index vertex : triangle) sound = sound && vertex < surface.positions.size();
                for (const glm::dvec3& p : surface.positions)
                    sound = sound && std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
                CHECK(sound);
            } catch (const InputError&) {
            }
        }
        CHECK(read > 0);
        CHECK(read < 3000);
    }
}

}  // namespace interleaf
