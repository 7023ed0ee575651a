// Readers of surfaces: every format, colors, polygons, and damaged files.
#include "io/mesh/surface_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <string>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "io/mesh/obj_keys.h"
#include "io/polygons.h"
#include "io/read_files.h"

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
                                     {{3, 2, 0}, {2, 1, 0}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}},
                                     {},
                                     {},
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

/// Triangles that share no vertices.
void check_loose_pyramid(const SurfaceFile& surface) {
    REQUIRE(surface.triangles.size() == pyramid().triangles.size());
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
        for (std::size_t corner = 0; corner < 3; ++corner)
            CHECK(surface.positions[surface.triangles[t][corner]] ==
                  pyramid().positions[pyramid().triangles[t][corner]]);
}

std::string with_count(std::string stl, std::uint32_t count) {
    std::memcpy(&stl[80], &count, sizeof count);
    return stl;
}

std::string without(std::string text, std::string_view part) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
        text.erase(at, part.size());
    return text;
}

std::string replaced(std::string text, std::string_view part, std::string_view by) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
    return text;
}

double area_of(const SurfaceFile& surface) {
    double sum = 0;
    for (const auto& [a, b, c] : surface.triangles)
        sum += glm::length(glm::cross(surface.positions[b] - surface.positions[a],
                                      surface.positions[c] - surface.positions[a]));
    return sum / 2;
}

double volume_of(const SurfaceFile& surface) {
    double sum = 0;
    for (const auto& [a, b, c] : surface.triangles)
        sum += glm::dot(surface.positions[a], glm::cross(surface.positions[b], surface.positions[c]));
    return sum / 6;
}

SurfaceFile surface_of_obj(std::string_view content, std::string_view) {
    const ScratchFolder folder;
    put(folder / "p.obj", content);
    return read_surface(folder / "p.obj");
}

/// A polygon in the plane z = 0 as OBJ, OFF and PLY.
class PolygonFiles {
  public:
    explicit PolygonFiles(const Polygon& polygon) {
        off_ = fmt::format("OFF\n{} 1 0\n", polygon.size());
        ply_ = fmt::format(
            "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double "
            "z\n"
            "element face 1\nproperty list uint uint vertex_indices\nend_header\n",
            polygon.size());
        std::string one_based = "f";
        std::string counted = fmt::format("{}", polygon.size());
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            const std::string place = fmt::format("{} {} 0\n", polygon[i].x, polygon[i].y);
            obj_ += "v " + place;
            off_ += place;
            ply_ += place;
            one_based += fmt::format(" {}", i + 1);
            counted += fmt::format(" {}", i);
        }
        obj_ += one_based + "\n";
        off_ += counted + "\n";
        ply_ += counted + "\n";
    }
    std::array<SurfaceFile, 3> surfaces() const {
        return {surface_of_obj(obj_, "p"), parse_off(off_, "p"), parse_ply(ply_, "p")};
    }
    std::array<std::string, 3> messages() const {
        return {input_error_of([&] { surface_of_obj(obj_, "p"); }),
                input_error_of([&] { parse_off(off_, "p"); }), input_error_of([&] { parse_ply(ply_, "p"); })};
    }

  private:
    std::string obj_;
    std::string off_;
    std::string ply_;
};

}  // namespace

TEST_CASE("the same surface is read from every format") {
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

TEST_CASE("an OBJ near 0 gives the same floats as a surface and as a key") {
    const ScratchFolder folder;
    put(folder / "p.obj", "v 0.1 0.2 0.3\nv 1.1 0.7 -0.3\nv 0.123456789 1.3 0.9\nf 1 2 3\n");
    const SurfaceFile surface = read_surface(folder / "p.obj");
    const Hierarchy key = read_obj(folder / "p.obj");
    REQUIRE(surface.positions.size() == 3);
    for (std::size_t i = 0; i < 3; ++i)
        for (int axis = 0; axis < 3; ++axis)
            CHECK(surface.positions[i][axis] == double{key.positions[i][axis]});
}

TEST_CASE("floats of the vertices of a PLY file become scalars, except for places, directions and colors") {
    const auto file = [](const std::string& values) {
        return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float heat\nproperty "
               "float y\n"
               "property float nx\nproperty int flag\nproperty double u\nproperty float heat\nproperty float "
               "z\n"
               "element face 1\nproperty list uchar int vertex_indices\nend_header\n" +
               values + "3 0 1 2\n";
    };
    const SurfaceFile surface =
        parse_ply(file("0 300 0 1 7 0.5 9 0\n1 301 0 1 7 0.25 9 0\n0 302 1 1 7 0.125 9 0\n"), "p");
    REQUIRE(surface.scalars.size() == 2);
    CHECK(surface.scalars[0] == MeshField{"heat", 1, {300, 301, 302}});
    CHECK(surface.scalars[1] == MeshField{"u", 1, {0.5, 0.25, 0.125}});
    const SurfaceFile broken =
        parse_ply(file("0 300 0 1 7 nan 9 0\n1 301 0 1 7 1 9 0\n0 302 1 1 7 1 9 0\n"), "p");
    CHECK(broken.scalars.size() == 1);
    CHECK(broken.remarks ==
          std::vector<std::string>{"The values \"u\" of the vertices are not all finite: left out."});
}

TEST_CASE("colors are read; in an OBJ a vertex without a color is white") {
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

TEST_CASE("an error names the file, the place and what was expected") {
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
        {parse_off, "", "is empty, expected OFF"},
        {parse_off, "OFF\n", "line 1: the file ends"},
        {parse_off, "ply\n", "line 1: \"ply\" begins the file, expected OFF"},
        {parse_off, "OFF\n3 1\n0 0 0\n1 0 0\n", "line 4: the file ends"},
        {parse_off, "OFF\n4294967295 1\n0 0 0\n", "line 3: the file ends"},
        {parse_off, "OFF\n3 1\n0 0 nan\n", "line 3: the file ends"},
        {parse_off, "OFF\n3 1\n0 0 x\n", "line 3: \"x\" found, expected three finite coordinates"},
        {parse_off, "OFF\n3 1\n0 0 1e999\n", "line 3: \"1e999\" found"},
        {parse_off, "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n",
         "line 6: vertex 3 does not exist, there are 3"},
        {parse_off, "OFF\n3 1\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n",
         "line 6: a face of 2 corners, expected 3 to 100000"},
        {parse_off, "OFF\n3 0\n0 0 0\n1 0 0\n0 1 0\n", "is a point cloud: it has 3 vertices, but no faces"},
        {parse_off, "OFF\n0 0\n", "has no faces"},
        {parse_off, "OFF BINARY\n", "count 0 (counted from 0): the file ends within it"},
        {parse_off, "NOFF\n3 1\n0 0 0 0 0\n", "line 3: \"\" found, expected a normal's"},
        {parse_off, "4OFF\n3 1 0\n", "line 1: \"4OFF\" begins the file, expected OFF"},
        {parse_off, "NNOFF\n3 1 0\n", "line 1: \"NNOFF\" begins the file"},
        {parse_off, std::string("\x7f\x45\x4c\x46\0\0\0", 7), "is not text, expected OFF"},
        {parse_off, "OFF\n4 1\n0 0 0\n1 1 0\n1 0 0\n0 1 0\n\n4 0 1 2 3\n",
         "line 8: a face of 4 corners that crosses itself"},
        {parse_off, "OFF\n3 1\n0 0 0\n1 0 inf\n0 1 0\n3 0 1 2\n",
         "line 4: a coordinate is not a finite number within the range of floats, and faces use the vertex"},
        {parse_stl, "", "size: 0 bytes, expected at least 84"},
        {parse_stl, std::string(83, '\0'), "size: 83 bytes"},
        {parse_stl, std::string(83, 'x'), "begins with \"xxx"},
        {parse_stl, "ply\nformat ascii 1.0\n" + std::string(200, '\n'),
         "begins with \"ply\", expected solid, or a binary STL"},
        {parse_stl, binary_stl(pyramid()).substr(0, 380), "expected 84 + 50 for each of the 6 triangles"},
        {parse_stl, with_count(binary_stl(pyramid()), 0) + "x", "has no triangles"},
        {parse_stl, with_count(binary_stl(pyramid()), 0xffffffff) + "x",
         "expected 84 + 50 for each of the 4294967295 triangles"},
        {parse_stl, infinite, "triangle 1 (counted from 0): a coordinate is not a finite number"},
        {parse_stl, std::string(84, '\0'), "has no triangles"},
        {parse_stl, "solid\nvertex 0 0\n", "line 2: \"\" is not a coordinate"},
        {parse_stl, "solid\nvertex 0 0 1\nendloop\n", "line 3: a loop of 1 vertices ends, expected 3"},
        {parse_stl, "solid\nvertex 0 0 1\n", "ends within a loop"},
        {parse_stl, "solid\nvertex 0 0 1e39\n", "line 2: \"1e39\" is not a coordinate"},
        {parse_stl, "solid\nvertex 0 0 nan\n", "line 2: \"nan\" is not a coordinate"},
        {parse_stl, "solid x\nendsolid x\n", "has no triangles"},
        {parse_ply, "plx\n", "line 1: expected ply"},
        {parse_ply, "ply\n", "line 2: the file ends, expected end_header"},
        {parse_ply, "ply\nend_header\n", "line 2: the header ends, expected a format"},
        {parse_ply, "ply\nformat binary\n", "line 2: format \"binary\", expected ascii"},
        {parse_ply, "ply\nelement vertex -1\n", "line 2: \"-1\" found"},
        {parse_ply, "ply\nelement vertex 1\nproperty quad x\n", "line 3: \"quad\" is not a type"},
        {parse_ply, header + "end_header\n0 0\n",
         "vertex 0 (counted from 0): expected the properties x, y and z"},
        {parse_ply, header + "property float z\nend_header\n0 nan 0\n",
         "is a point cloud: it has 1 vertex, but no faces"},
        {parse_ply, header + "property float z\nend_header\n0 x 0\n",
         "vertex 0 (counted from 0): \"x\" found"},
        {parse_ply, header + "property float z\nend_header\n0 0\n",
         "vertex 0 (counted from 0): the file ends"},
        {parse_ply, header + "property float z\nend_header\n0 0 0\n", "is a point cloud: it has 1 vertex"},
        {parse_ply,
         header + "property float z\nelement edge 2\nproperty int vertex1\nend_header\n0 0 0\n0\n0\n",
         "is a wire frame: it has 2 lines, but no faces"},
        {parse_ply,
         header + "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                  "0 nan 0\n3 0 0 0\n",
         "vertex 0 (counted from 0): a coordinate is not a finite number"},
        {parse_ply,
         header + "property float z\nelement tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                  "0 0 0\n3 0 -2 0\n",
         "tristrips 0 (counted from 0): -2 found, expected a vertex or -1"},
        {parse_ply, header + "prperty float z\nend_header\n0 0 0\n", "expected the properties x, y and z"},
        {parse_ply, header + "property float z\nelment face 1\nend_header\n0 0 0\n3 0 0 0\n",
         "more follows than the header declares, of which a line says \"elment face 1\""},
        {parse_ply, std::string("ply\nformat ascii 1.0\n\0\1\2\n", 26),
         "line 3: is not text, expected end_header"},
        {parse_ply,
         header + "property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n"
                  "0 0 0\n3 0 0 1\n",
         "a face has vertex 1, there are 1"},
        {parse_ply,
         header + "property float z\nelement face 1\nproperty list int int vertex_indices\nend_header\n"
                  "0 0 0\n2000000000 0 0 1\n",
         "face 0 (counted from 0): 2000000000 corners, expected 3 to 100000"},
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
    CHECK(contains(input_error_of([&] { read_surface(folder / "m.txt"); }),
                   "expected a file that ends in .obj"));
}

TEST_CASE("an OFF is read as Geomview reads it, and as other programs write it") {
    const std::string text(off);
    check_pyramid(parse_off(replaced(text, "OFF # a pyramid\n\n5", "OFF 5"), "p"));
    check_pyramid(parse_off(replaced(text, "OFF # a pyramid\n\n5", "OFF5"), "p"));
    check_pyramid(parse_off(replaced(text, "OFF # a pyramid\n\n", ""), "p"));
    check_pyramid(parse_off(replaced(text, "OFF # a pyramid\n\n", "# a pyramid\n# no header\n"), "p"));
    check_pyramid(parse_off(replaced(text, "5 5 0", "5 5"), "p"));
    check_pyramid(parse_off("\xef\xbb\xbf" + text, "p"));
    check_pyramid(parse_off(replaced(text, "\n", "\r"), "p"));
    check_pyramid(parse_off(replaced(text, "\n", "\r\n"), "p"));
    check_pyramid(parse_off(replaced(text, "4 3 2 1 0", "4 3\n2 # two\n\n1 0"), "p"));
    check_pyramid(parse_off(text.substr(0, text.size() - 1), "p"));

    // Normals, colors and texture coordinates in any order; the letters are read from right to left.
    struct Variant {
        std::string header;
        std::string behind;  // a vertex
        glm::vec3 color;
    };
    const Variant variants[] = {{"NOFF", " 0 0 1", {}},
                                {"STOFF", " 0.5 0.25", {}},
                                {"STNOFF", " 0 0 1 0.5 0.25", {}},
                                {"NSTOFF", " 0.5 0.25 0 0 1", {}},
                                {"COFF", " 255 0 51", {1, 0, 0.2F}},
                                {"COFF", " 255 0 51 255", {1, 0, 0.2F}},
                                {"COFF", " 1 0.5 0.0 0.25", {1, 0.5F, 0}},
                                {"NCOFF", " 255 0 51 0 0 1", {1, 0, 0.2F}},
                                {"NCOFF", " 255 0 51 255 0 0 1", {1, 0, 0.2F}},
                                {"CNOFF", " 0 0 1 255 0 51 255", {1, 0, 0.2F}},
                                {"STCNOFF", " 0 0 1 1.0 0.5 0 1 0.5 0.25", {1, 0.5F, 0}},
                                {"STCOFF", " 1.0 0.5 0 0.5 0.25", {1, 0.5F, 0}},
                                {"CSTOFF", " 0.5 0.25 1.0 0.5 0", {1, 0.5F, 0}}};
    for (const auto& [header, behind, color] : variants) {
        CAPTURE(header);
        CAPTURE(behind);
        std::string variant = replaced(text, "OFF # a pyramid", header);
        for (const std::string vertex : {"0 0 0\n", "1 0 0\n", "1 1 0\n", "0 1 0\n", "0.5 0.5 1\n"})
            variant = replaced(variant, "\n" + vertex, "\n" + replaced(vertex, "\n", behind + "\n"));
        const SurfaceFile surface = parse_off(variant, "p");
        check_pyramid(surface);
        CHECK(surface.colors.size() == (contains(header, "C") ? 5 : 0));
        for (const glm::vec3& each : surface.colors)
            for (int c = 0; c < 3; ++c) CHECK(each[c] == doctest::Approx(color[c]));
    }
}

TEST_CASE("a binary OFF is read") {
    for (const bool has_colors : {false, true}) {
        std::string bytes = has_colors ? "CNOFF BINARY\n" : "OFF BINARY\r\n";
        for (const std::uint32_t count : {5U, 6U, 0U}) append(bytes, count, true);
        for (const glm::dvec3& p : pyramid().positions) {
            for (int axis = 0; axis < 3; ++axis) append(bytes, static_cast<float>(p[axis]), true);
            if (has_colors)
                for (const float number : {0.0F, 0.0F, 1.0F, 1.0F, 0.5F, 0.0F, 1.0F})
                    append(bytes, number, true);
        }
        for (const Triangle& triangle : pyramid().triangles) {
            append(bytes, std::uint32_t{3}, true);
            for (const Index vertex : triangle) append(bytes, vertex, true);
            append(bytes, std::uint32_t{has_colors ? 4U : 0U}, true);
            for (int i = 0; has_colors && i < 4; ++i) append(bytes, 1.0F, true);
        }
        const SurfaceFile surface = parse_off(bytes, "p");
        check_pyramid(surface);
        CHECK(surface.colors == std::vector<glm::vec3>(has_colors ? 5 : 0, {1, 0.5F, 0}));
        for (std::size_t size = 14; size < bytes.size(); ++size)
            CHECK_THROWS_AS(parse_off(bytes.substr(0, size), "p"), InputError);
    }
}

TEST_CASE("a binary STL with a wrong count or header is read by its size") {
    const std::string stl = binary_stl(pyramid());
    std::string solid = stl;
    solid.replace(0, 13, "solid pyramid");
    check_loose_pyramid(parse_stl(solid, "p"));
    struct Variant {
        std::string bytes;
        std::string_view remark;
    };
    const Variant variants[] = {
        {with_count(stl, 0), "The count says 0 triangles, but the size of the file says 6."},
        {with_count(stl, 0xffffffff),
         "The count says 4294967295 triangles, but the size of the file says 6."},
        {stl + "x", "1 bytes after the last triangle were ignored."},
        {stl + std::string(92, '\0'), "92 bytes after the last triangle were ignored."},
        {solid + std::string(46, '\0'), "46 bytes after the last triangle were ignored."},
    };
    for (const auto& [bytes, remark] : variants) {
        CAPTURE(remark);
        const SurfaceFile surface = parse_stl(bytes, "p");
        check_loose_pyramid(surface);
        CHECK(surface.remarks == std::vector<std::string>{std::string(remark)});
    }
}

TEST_CASE("a text STL is read in any case, on any lines, with any name") {
    const std::string stl = text_stl(pyramid());
    std::string upper = stl;
    for (char& c : upper)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    for (const std::string& variant :
         {upper, " \t" + stl, "\n\n" + stl, "\xef\xbb\xbf" + stl, replaced(stl, "\n", " "),
          replaced(stl, "\n", "\r"), replaced(stl, "\n", "\r\n"), replaced(stl, "solid pyramid", "solid"),
          replaced(stl, "solid pyramid", "solid a facet of a vertex"),
          replaced(stl, "solid pyramid", "solid vertex 1 endloop"),
          replaced(stl, "endsolid\n", "endsolid vertex\nsolid\nendsolid"),
          replaced(stl, " 1 ", " +1.0e0 ")}) {
        CAPTURE(variant);
        const SurfaceFile surface = parse_stl(variant, "p");
        check_loose_pyramid(surface);
        CHECK(surface.remarks.empty());
    }
    const SurfaceFile open = parse_stl(without(stl, "endsolid\n"), "p");
    check_loose_pyramid(open);
    CHECK(mentions(open.remarks, "without endsolid: it may be cut off"));
}

TEST_CASE("a PLY with lines of all kinds is read") {
    const std::string text(ply);
    check_pyramid(parse_ply(replaced(text, "\n", "\r"), "p"));
    check_pyramid(parse_ply(replaced(text, "\n", "\r\n"), "p"));
    check_pyramid(parse_ply(replaced(text, "vertex_indices", "vertex_index"), "p"));
    check_pyramid(parse_ply("\xef\xbb\xbf" + text, "p"));
    std::string utf16 = "\xff\xfe";
    for (const char c : text) utf16 += {c, '\0'};
    const SurfaceFile converted = parse_ply(utf16, "p");
    check_pyramid(converted);
    CHECK(mentions(converted.remarks, "The text was converted from UTF-16."));
    const SurfaceFile remarked = parse_ply(replaced(text, "comment a", "made by a"), "p");
    check_pyramid(remarked);
    CHECK(mentions(remarked.remarks, "Line 3 of the header, \"made by a pyramid\", was ignored."));
    for (const std::string end : {"\r", "\r\n"}) {
        const std::string binary = binary_ply(pyramid(), false);
        const std::size_t body = binary.find("end_header\n") + 11;
        check_pyramid(parse_ply(replaced(binary.substr(0, body), "\n", end) + binary.substr(body), "p"));
    }
}

TEST_CASE("a text PLY whose lines have more values than its header declares is read by lines") {
    // MeshLab once wrote the colors of faces as lists, but declared them as single values.
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
        "property float z\nelement face 4\nproperty list uchar int vertex_indices\n"
        "property uchar red\nend_header\n";
    const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n0 0 1\n";
    const std::string declared = "3 0 2 1 9\n3 0 1 3 9\n\n3 1 2 3 9\n3 2 0 3 9\n";
    const SurfaceFile expected = parse_ply(head + vertices + declared, "p");
    CHECK(expected.remarks.empty());
    const std::string more = "3 0 2 1 9\n3 0 1 3 9 1 1 1\n\n3 1 2 3 9 1 1\n3 2 0 3 9\n";
    const SurfaceFile read = parse_ply(head + vertices + more, "p");
    CHECK(read.triangles == expected.triangles);
    CHECK(read.positions == expected.positions);
    REQUIRE(read.remarks.size() == 1);
    CHECK(read.remarks[0] ==
          "Values that the header does not declare, first of face 1 (counted from 0), were ignored.");
    // The same values on other lines are read as they come.
    const SurfaceFile on_one = parse_ply(head + "0 0 0 1 0 0 0 1 0 0 0 1 " + declared, "p");
    CHECK(on_one.triangles == expected.triangles);
    CHECK(on_one.positions == expected.positions);
    CHECK(on_one.remarks.empty());
    CHECK_THROWS_AS(parse_ply(head + vertices + "3 0 2 1 9 3 0\n1 3 9 3 1 2\n3 9 3 2 0 3\n9 9\n", "p"),
                    InputError);
}

TEST_CASE("triangle strips of a PLY are read, as text and binary") {
    // Around the pyramid, then over its base. One strip ends, another continues after a repeated corner.
    constexpr std::int32_t strip[] = {0, 1, 4, 2, -1, 2, 3, 4, 0, -1, 3, 2, 0, 1, 1};
    const std::vector<Triangle> expected{{0, 1, 4}, {4, 1, 2}, {2, 3, 4}, {4, 3, 0}, {3, 2, 0}, {0, 2, 1}};
    for (const std::string form : {"ascii", "binary_little_endian", "binary_big_endian"}) {
        CAPTURE(form);
        const bool is_text = form == "ascii";
        const bool is_big = form == "binary_big_endian";
        std::string bytes = fmt::format(
            "ply\nformat {} 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
            "element tristrips 1\nproperty list int int vertex_indices\nend_header\n",
            form);
        for (const glm::dvec3& p : pyramid().positions)
            for (int axis = 0; axis < 3; ++axis)
                is_text ? void(bytes += fmt::format("{} ", p[axis]))
                        : append(bytes, static_cast<float>(p[axis]), is_big);
        constexpr auto count = static_cast<std::int32_t>(std::size(strip));
        is_text ? void(bytes += fmt::format("{}", count)) : append(bytes, count, is_big);
        for (const std::int32_t corner : strip)
            is_text ? void(bytes += fmt::format(" {}", corner)) : append(bytes, corner, is_big);
        const SurfaceFile surface = parse_ply(bytes, "p");
        CHECK(surface.positions == pyramid().positions);
        CHECK(surface.triangles == expected);
    }
}

TEST_CASE("polygons that are not convex, or have many corners, are divided in every format") {
    for (const auto& [name, polygon, area] : outlines())
        for (std::size_t corner = 0; corner < polygon.size(); ++corner) {
            CAPTURE(name);
            CAPTURE(corner);
            const PolygonFiles files(begun_at(polygon, corner));
            for (const SurfaceFile& surface : files.surfaces()) {
                CHECK(surface.triangles.size() == polygon.size() - 2);
                CHECK(area_of(surface) == doctest::Approx(area));
            }
        }
    for (const std::size_t corners : {std::size_t{1001}, std::size_t{20'000}}) {
        const PolygonFiles files(comb(corners));
        for (const SurfaceFile& surface : files.surfaces()) {
            CHECK(surface.triangles.size() == corners - 2);
            CHECK(area_of(surface) == doctest::Approx(doubled_area(comb(corners)) / 2));
        }
    }
}

TEST_CASE(
    "a prism over any outline, started at any corner, in either direction and any plane, has its volume") {
    std::mt19937 random(1);
    for (const auto& [name, polygon, area] : outlines())
        for (std::size_t corner = 0; corner < polygon.size(); ++corner) {
            CAPTURE(name);
            CAPTURE(corner);
            const auto count = static_cast<Index>(polygon.size());
            std::vector<glm::dvec3> places = in_space(polygon);
            for (const glm::dvec2& p : polygon) places.emplace_back(p, 2);
            // Rotated by a symmetry of the cube, or by any angle; both keep the size.
            const double angle = static_cast<double>(random() % 360);
            std::string text;
            for (const glm::dvec3& p : places) {
                const double x = std::cos(angle) * p.x - std::sin(angle) * p.z;
                const double z = std::sin(angle) * p.x + std::cos(angle) * p.z;
                text += fmt::format("v {} {} {}\n", x, p.y, z);
            }
            std::string below = "f";
            std::string above = "f";
            for (Index i = 0; i < count; ++i) {
                below += fmt::format(" {}", (corner + count - i) % count + 1);
                above += fmt::format(" {}", (corner + i) % count + count + 1);
            }
            text += below + "\n" + above + "\n";
            for (Index i = 0; i < count; ++i) {
                const Index j = (i + 1) % count;
                text += fmt::format("f {} {} {} {}\n", i + 1, j + 1, j + count + 1, i + count + 1);
            }
            const SurfaceFile surface = surface_of_obj(text, "");
            CHECK(surface.triangles.size() == 4 * count - 4);
            CHECK(volume_of(surface) == doctest::Approx(2 * area));
            double outline = 0;
            for (Index i = 0; i < count; ++i) outline += glm::distance(polygon[i], polygon[(i + 1) % count]);
            CHECK(area_of(surface) == doctest::Approx(2 * area + 2 * outline));
        }
}

TEST_CASE("a polygon that crosses itself is rejected in every format, with its place") {
    const PolygonFiles files({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    const auto messages = files.messages();
    CHECK(messages[0].ends_with("p.obj: line 5: a face of 4 corners that crosses itself"));
    CHECK(messages[1].ends_with("p: line 7: a face of 4 corners that crosses itself"));
    CHECK(messages[2].ends_with("p: face 0 (counted from 0): a face of 4 corners that crosses itself"));
}

TEST_CASE("odd colors are read, and remarks say what was changed") {
    const auto with = [](std::string_view color) {
        return surface_of_obj(fmt::format("v 0 0 0 {}\nv 1 0 0 0 0 1\nv 0 1 0 1 1 1\nf 1 2 3\n", color), "");
    };
    CHECK(with("0.5 0 1").remarks.empty());
    const SurfaceFile bytes = with("255 0 51");
    CHECK(bytes.colors[0] == glm::vec3(1, 0, 0.2F));
    CHECK(mentions(bytes.remarks, "Colors from 0 to 255 were divided by 255."));
    const SurfaceFile more = with("1.000001 -1e-6 0.5");
    CHECK(more.colors[0] == glm::vec3(1, 0, 0.5F));
    CHECK(mentions(more.remarks, "1 color was outside 0 to 1, by at most 1e-06, and clamped."));
    const SurfaceFile undefined = with("nan 0 0");
    CHECK(undefined.colors[0] == glm::vec3(1));
    CHECK(undefined.colors[1] == glm::vec3(0, 0, 1));
    CHECK(mentions(undefined.remarks, "1 color had no finite numbers and became white."));
    const SurfaceFile large = with("300 0 0");
    CHECK(large.colors[0] == glm::vec3(1, 0, 0));
    CHECK(mentions(large.remarks, "clamped"));
}

TEST_CASE("a vertex that is not finite is ignored if no face uses it") {
    const std::string text = "v 1 2 3\nv nan 0 0\nv 0 inf 0\nv 0 0 -1.#IND\nv 1 0 0\nv 0 1 0\nf 1 5 6\n";
    const SurfaceFile surface = surface_of_obj(text, "");
    CHECK(surface.positions.size() == 6);
    CHECK(surface.positions[1] == glm::dvec3(1, 2, 3));
    CHECK(mentions(surface.remarks, "3 vertices are not finite and not used by faces: ignored."));
    std::string many = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    for (int i = 0; i < 1001; ++i) many += "v nan 0 0\n";
    CHECK(contains(input_error_of([&] { surface_of_obj(many, ""); }), "line 1005: more than 1000 vertices"));
    std::string far = binary_ply(pyramid(), false);
    const double beyond = 1e200;
    std::memcpy(&far[far.find("end_header\n") + 11 + 5], &beyond, sizeof beyond);
    CHECK(contains(input_error_of([&] { parse_ply(far, "p"); }),
                   "vertex 0 (counted from 0): a coordinate is not a finite number within the range"));
}

TEST_CASE("map coordinates keep their digits") {
    const std::string text =
        "v 500000.123456789 5400000.987654321 300\nv 500001 5400000 300\nv 500000 5400001 300\nf 1 2 3\n";
    CHECK(surface_of_obj(text, "").positions[0] == glm::dvec3(500000.123456789, 5400000.987654321, 300));
    CHECK(
        parse_off("OFF 3 1 0\n500000.123456789 0 0\n500001 0 0\n500000 1 0\n3 0 1 2\n", "p").positions[0].x ==
        500000.123456789);
}

TEST_CASE("randomly changed files are read or rejected") {
    const std::uint32_t seed = std::random_device{}();
    CAPTURE(seed);
    std::mt19937 random(seed);
    struct Form {
        SurfaceFile (*parse)(std::string_view, std::string_view);
        std::string content;
    };
    std::string strips =
        "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\nproperty float z\n"
        "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
        "0 0 0 1 0 0 1 1 0 0 1 0 0.5 0.5 1 10 0 1 4 2 -1 2 3 4 0 1\n";
    const Form forms[] = {{parse_off, std::string(off)},
                          {parse_off, replaced(std::string(off), "\n0", "\n\n0")},
                          {parse_ply, strips},
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
