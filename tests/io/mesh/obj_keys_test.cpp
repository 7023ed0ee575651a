#include "io/mesh/obj_keys.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "hierarchy/checker.h"
#include "io/mesh/mesh_writer.h"
#include "io/samples.h"

namespace interleaf {

namespace {

std::string obj_error(const ScratchFolder& folder, std::string_view obj) {
    put(folder / "m.obj", obj);
    return input_error_of([&] { read_obj(folder / "m.obj"); });
}

Hierarchy obj_hierarchy(const ScratchFolder& folder, std::string_view obj) {
    put(folder / "m.obj", obj);
    return read_obj(folder / "m.obj");
}

/// A finite float with random bits, so that all magnitudes are equally likely.
float random_float(std::mt19937& random) {
    for (;;) {
        const auto number = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (std::isfinite(number)) return number;
    }
}

bool is_same(std::span<const glm::vec3> a, std::span<const glm::vec3> b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

constexpr std::string_view tetrahedron_vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";

}  // namespace

TEST_CASE("an OBJ gives back the same floats, vertices and face order") {
    const ScratchFolder folder;
    using Limits = std::numeric_limits<float>;
    for (unsigned seed = 0; seed < 200; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::vector<glm::vec3> positions;
        std::vector<Triangle> triangles;
        for (Index strip = 0; strip < 50; ++strip) {
            for (int corner = 0; corner < 3; ++corner)
                positions.emplace_back(random_float(random), random_float(random), random_float(random));
            triangles.push_back({3 * strip + 2, 3 * strip, 3 * strip + 1});
        }
        positions[0] = {-0.0f, Limits::denorm_min(), Limits::max()};
        positions[1] = {0.1f, -Limits::min(), Limits::lowest()};
        put(folder / "m.obj", obj_text(triangles, positions));
        const Hierarchy read = read_obj(folder / "m.obj");
        CHECK(is_same(read.positions, positions));
        CHECK(std::ranges::equal(read.roots.triangles(), triangles));
        CHECK(read.midpoints.empty());
    }
}

TEST_CASE(
    "an OBJ of another program is read: polygons, groups, texture and normal numbers, relative numbers") {
    const ScratchFolder folder;
    const Hierarchy cube =
        obj_hierarchy(folder,
                      "# cube\r\nmtllib none.mtl\r\no cube\r\n"
                      "v -1 -1 -1\r\nv 1 -1 -1 1.0\r\nv 1 1 -1 0.5 0.5 0.5\r\nv +1e2 7 7\r\n"
                      "v -1 1 -1\r\nv -1 -1 1\r\nv 1 -1 1\r\nv 1 1 1\r\nv -1 1 1\r\n"
                      "vt 0 0\r\nvn 0 0 1\r\ng sides\r\nusemtl red\r\ns off\r\n"
                      "f 1/1/1 5/1/1 3/1/1 2/1/1\r\nf 6//1 7//1 8//1 9//1\r\nf 1/1 2/1 7/1 6/1\r\n"
                      "g more\r\nf 2 3 8 7\r\nf 3 5 9 8\r\n\tf -5 -9 -4 -1");
    CHECK(cube.positions.size() == 8);
    CHECK(cube.roots.triangle_count() == 12);
    CHECK(cube.roots.boundary_edge_count() == 0);
    CHECK(cube.roots.euler_number() == 2);
    CHECK(cube.positions[3] == glm::vec3(-1, 1, -1));
    CHECK(check(cube).empty());
}

TEST_CASE("a backslash continues a line, a comment may end any line, and a comma may follow a number") {
    const ScratchFolder folder;
    const std::string vertices = "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 0 1 0\n";
    const Hierarchy expected = obj_hierarchy(folder, vertices + "f 1 2 3\nf 1 3 4\n");
    for (const std::string& variant : std::initializer_list<std::string>{
             vertices + "f 1 2 \\\n3\nf 1 3 4\n", vertices + "f 1 2\\\n3\nf 1 3 4\n",
             vertices + "f \\\n1 \\\n2 \\\n3 \\\n\nf 1 3 4\\", vertices + "f 1 2\\\r\n3\r\nf 1 3 4\r\n",
             vertices + "f 1 2 \\ \n3\nf 1 3 4\n",
             "v 0 0 \\\n0\n" + vertices.substr(8) + "f 1 2 3\nf 1 3 4\n",
             "# C:\\meshes\\\n" + vertices + "f 1 2 3 # \\\nf 1 3 4 #\\\n",
             vertices + "usemtl wood\\\nf 1 2 3\ng a b\\\nf 1 3 4\n",
             vertices + "f 1 2 3 # first\nf 1 3 4#second\n", vertices + "f 1 2 3# 4\nf 1/1 3/1# /\\\n4/1\n",
             vertices + "f 1, 2, 3\nf 1/1, 3/2, 4/3,\n",
             "v 0, 0, 0\nv 2, 0, 0\nv 2, 1, 0\nv 0, 1, 0,\nf 1 2 3\nf 1 3 4\n",
             "\xef\xbb\xbf" + vertices + "f 1 2 3\nf 1 3 4\n",
             "v 0 0 0\rv 2 0 0\rv 2 1 0\rv 0 1 0\rf 1 2 \\\r3\rf 1 3 4\r"}) {
        CAPTURE(variant);
        if (contains(variant, "# /")) {  // a comment is not part of the face
            CHECK(contains(obj_error(folder, variant), "line 6: a face of 2 vertices"));
            continue;
        }
        const Hierarchy read = obj_hierarchy(folder, variant);
        CHECK(read.roots == expected.roots);
        CHECK(read.positions == expected.positions);
        CHECK(read.fields.empty());
    }
}

TEST_CASE("an OBJ in UTF-16 is read, with a remark") {
    const ScratchFolder folder;
    std::string text = "\xff\xfe";
    for (const char c : std::string("v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf 1 2 3\r\n")) text += {c, '\0'};
    put(folder / "m.obj", text);
    const std::vector<std::filesystem::path> files{folder / "m.obj"};
    const FileKeys keys = read_obj_series(files);
    CHECK(keys.keys.front().positions.size() == 3);
    CHECK(keys.remarks ==
          std::vector<std::string>{files[0].string() + ": The text was converted from UTF-16."});
}

TEST_CASE("free-form surfaces of an OBJ are left out with a remark, lines without one") {
    const ScratchFolder folder;
    put(folder / "m.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nl 1 2\ncstype bezier\nsurf 0 1 0 1 1 2 3 1\nend\n");
    const std::vector<std::filesystem::path> files{folder / "m.obj"};
    CHECK(read_obj_series(files).remarks ==
          std::vector<std::string>{files[0].string() +
                                   ": 1 free-form surface was left out: only faces are read."});
}

TEST_CASE("colors of other ranges become colors of the key, and remarks name the file") {
    const ScratchFolder folder;
    put(folder / "m.obj", "v 0 0 0 255 0 0\nv 1 0 0 0 51 0\nv 0 1 0 0 0 nan\nf 1 2 3\n");
    const std::vector<std::filesystem::path> files{folder / "m.obj"};
    const FileKeys keys = read_obj_series(files);
    CHECK(keys.keys.front().fields.at(0).values == Buffer<float>{1, 0, 0, 0, 0.2F, 0, 1, 1, 1});
    const std::string name = files[0].string();
    CHECK(keys.remarks ==
          std::vector<std::string>{name + ": Colors from 0 to 255 were divided by 255.",
                                   name + ": 1 color had no finite numbers and became white."});
}

TEST_CASE("an OBJ far from 0 is a key with an integer origin") {
    const ScratchFolder folder;
    put(folder / "m.obj",
        "v 500000.25 5400000.5 0\nv 500001.25 5400000.5 0\nv 500000.25 5400001.5 0\nf 1 2 3\n");
    const std::vector<std::filesystem::path> files{folder / "m.obj"};
    const FileKeys keys = read_obj_series(files);
    CHECK(keys.origin == glm::dvec3(500'001, 5'400'001, 0));
    CHECK(keys.keys.front().positions ==
          Buffer<glm::vec3>{{-0.75F, -0.5F, 0}, {0.25F, -0.5F, 0}, {-0.75F, 0.5F, 0}});
    const glm::dvec3 other(500'000, 5'400'000, 1);
    CHECK(read_obj_series(files, other).keys.front().positions[0] == glm::vec3(0.25F, 0.5F, -1));
}

TEST_CASE("OBJ and PLY have the origin added in double precision") {
    const std::vector<glm::vec3> positions{{0.001F, 0, 0}, {1, 0.5F, 0}, {0, 1, -2}};
    const std::vector<Triangle> triangles{{2, 0, 1}};
    const glm::dvec3 origin(500'000, 5'400'000, 300);
    const std::string obj = obj_text(triangles, positions, {}, origin);
    CHECK(obj.starts_with("v 500000.00100000005 5400000 300\n"));
    CHECK(contains(obj, "\nv 500001 5400000.5 300\nv 500000 5400001 298\nf 3 1 2\n"));
    const std::string ply = ply_bytes(triangles, positions, {}, origin);
    const std::size_t body = ply.find("end_header\n") + 11;
    CHECK(contains(ply, "property double x\nproperty double y\nproperty double z\n"));
    REQUIRE(ply.size() == body + 3 * 24 + 13);
    double y = 0;
    std::memcpy(&y, &ply[body + 24 + 8], sizeof y);
    CHECK(y == 5'400'000.5);
}

TEST_CASE("a polygon of many corners becomes triangles inside it") {
    const ScratchFolder folder;
    const Hierarchy pentagon =
        obj_hierarchy(folder, "v 0 0 0\nv 2 0 0\nv 3 1 0\nv 1 3 0\nv -1 1 0\nf 1 2 3 4 5\n");
    CHECK(pentagon.roots.triangle_count() == 3);
    CHECK(pentagon.roots.boundary_edge_count() == 5);
}

TEST_CASE("numbers too small for a float are 0, numbers too large are rejected") {
    const ScratchFolder folder;
    const Hierarchy triangle = obj_hierarchy(folder, "v 1e-99 -1e-46 0\nv 1 0 0\nv 0 1 1e-300\nf 1 2 3\n");
    CHECK(triangle.positions[0] == glm::vec3(0));
    CHECK(triangle.positions[2] == glm::vec3(0, 1, 0));
    CHECK(obj_error(folder, "v 1e39 0 0\n").find("line 1: \"1e39\" is not a coordinate") !=
          std::string::npos);
    CHECK(obj_error(folder, "v 1e999 0 0\n").find("line 1: \"1e999\" is not a coordinate") !=
          std::string::npos);
}

TEST_CASE("a hostile OBJ is rejected with the line and what was expected") {
    struct Case {
        std::string obj;
        std::string_view expected;
    };
    const std::string v(tetrahedron_vertices);
    std::string many_corners = v + "f";
    for (int corner = 0; corner < 100'001; ++corner) many_corners += " 1";
    const std::vector<Case> cases{
        {"", "m.obj: has no faces"},
        {"# nothing\n", "m.obj: has no faces"},
        {v, "m.obj: is a point cloud: it has 4 vertices, but no faces"},
        {v + "l 1 2 3\nl 3 4\n", "m.obj: is a wire frame: it has 2 lines, but no faces"},
        {v + "cstype bezier\nsurf 0 1 0 1 1 2 3 4\nend\n",
         "m.obj: has 1 free-form surface, but no faces: only faces are read"},
        {std::string(1000, '\0'), "m.obj: is not text, expected lines that begin with v and f"},
        {std::string("\x7f") + std::string("ELF\2\1\1\0\nv\0", 10), "m.obj: is not text"},
        {"v 0 0\nf 1 1 1\n", "line 1: a vertex of 2 coordinates, expected three"},
        {"v 0 0 nan\nv 0 0 0\nf 1 2 2\n",
         "line 1: a coordinate is not a finite number within the range of floats"},
        {v + "v 0 -inf 0\nf 1 2 3\nf 1 2 5\n", "line 5: a coordinate is not a finite number"},
        {"v 1,2,3\n", "line 1: \"1,2,3\" is not a coordinate"},
        {"v 1,5 2 3\n", "line 1: \"1,5\" is not a coordinate"},
        {"v 1,5 2,5 3,5\n", "line 1: \"1,5\" is not a coordinate"},
        {"v , 0 0\n", "line 1: \",\" is not a coordinate"},
        {"v 0 0 \\\n", "line 1: a vertex of 2 coordinates, expected three"},
        {v + "f 1 2 3 \\\nf 1 2 4\n", "line 5: \"f\" is not a corner"},
        {v + "# \\\nf 1 2 \\\n9\n", "line 6: vertex 9 does not exist"},
        {"v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\n\nf 1 2 3 4\n",
         "line 6: a face of 4 corners that crosses itself"},
        {"v 0 0x10 0\n", "\"0x10\" is not a coordinate"},
        {"v 0 1,5 0\n", "\"1,5\" is not a coordinate"},
        {"v 0 \x1b[2J 0\n", "\"\\u001b[2J\" is not a coordinate"},
        {v + "f 1 2\n", "line 5: a face of 2 vertices, expected 3 to 100000"},
        {many_corners, "line 5: a face of 100001 vertices"},
        {v + "f 1 2 0\n", "line 5: vertex 0 does not exist"},
        {v + "f 1 2 -5\n", "line 5: vertex -5 does not exist, there are 4"},
        {v + "f 1 2 5\nf 1 2 3\n", "line 5: vertex 5 does not exist, there are 4"},
        {v + "f 1 2 2147483648\n", "line 5: vertex 2147483648 does not exist"},
        {v + "f 1 2 99999999999999999999\n", "line 5: \"99999999999999999999\" is not a corner"},
        {v + "f 1 2 x\n", "line 5: \"x\" is not a corner"},
        {v + "f 1 2 3x\n", "line 5: \"3x\" is not a corner"},
        {v + "f 1 1 2\n", "m.obj: faces"},
        {v + "f 1 2 3\nf 1 2 4\n", "m.obj: faces"},
        {v + "f 1 2 3\nf 2 1 4\nf 1 2 4\n", "m.obj: faces"},
    };
    const ScratchFolder folder;
    for (const Case& hostile : cases) {
        const std::string error = obj_error(folder, hostile.obj);
        INFO("expected: ", hostile.expected, "   got: ", error);
        CHECK(error.find(hostile.expected) != std::string::npos);
    }
}

TEST_CASE("random damage to an OBJ gives an error or a sound hierarchy") {
    const ScratchFolder folder;
    const std::string whole =
        fmt::format("{}f 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\nf 1 2 3 4\n", tetrahedron_vertices);
    constexpr std::string_view pieces = "0123456789-+.e/ \nfvgtlp#\r";
    int sound = 0;
    for (unsigned seed = 0; seed < 2000; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::string obj(std::string_view(whole).substr(0, whole.size() - (seed % 2 == 0 ? 0 : 10)));
        for (auto changes = 1 + random() % 3; changes > 0; --changes)
            obj[random() % obj.size()] = pieces[random() % pieces.size()];
        put(folder / "m.obj", obj);
        const std::string error = input_error_of([&] {
            const Hierarchy read = read_obj(folder / "m.obj");
            CHECK(check(read).empty());
            ++sound;
        });
        if (!error.empty()) CHECK(error.starts_with((folder / "m.obj").string() + ": "));
    }
    CHECK(sound > 100);
    CHECK(sound < 1900);
}

TEST_CASE("colors of vertices become a color field, white for vertices without a color") {
    const ScratchFolder folder;
    const Hierarchy triangle =
        obj_hierarchy(folder, "v 9 9 9 0 0 0\nv 0 0 0\nv 1 0 0 1 0.5 0.25\nv 0 1 0 0 1e-3 1 0.5\nf 2 3 4\n");
    REQUIRE(triangle.fields.size() == 1);
    CHECK(triangle.fields[0].label() == FieldName{"color", FieldKind::color});
    CHECK(triangle.fields[0].values == Buffer<float>{1, 1, 1, 1, 0.5F, 0.25F, 0, 1e-3F, 1});
    CHECK(check(triangle).empty());
    CHECK(obj_hierarchy(folder, "v 0 0 0 1\nv 1 0 0 # a red one\nv 0 1 0 1 1\nf 1 2 3\n").fields.empty());
    for (const std::string wrong : {"0 x 0", "0 0 1,5", "0 0 0x1"}) {
        CAPTURE(wrong);
        const std::string error = obj_error(folder, "v 0 0 0\nv 1 0 0 " + wrong + "\nv 0 1 0\nf 1 2 3\n");
        CHECK(error.find("line 2: ") != std::string::npos);
        CHECK(error.find("is not a part of a color, expected three numbers") != std::string::npos);
    }
}

TEST_CASE("an OBJ gives back the same colors") {
    const ScratchFolder folder;
    for (unsigned seed = 0; seed < 50; ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        const Hierarchy key = with_fields(random_hierarchy(random, false, 0), random, 4);
        const auto first_color = std::ranges::find(key.fields, FieldKind::color, &Field::kind);
        put(folder / "m.obj", obj_text(key.roots.triangles(), key.positions, key.fields));
        const Hierarchy read = read_obj(folder / "m.obj");
        REQUIRE(read.fields.size() == (first_color == key.fields.end() ? 0 : 1));
        if (!read.fields.empty()) CHECK(read.fields[0].values == first_color->values);
    }
    std::mt19937 random(2);
    Hierarchy key = random_hierarchy(random, false, 0);
    const Buffer<float> zeros(3 * key.vertex_count(), 0);
    const Buffer<float> halves(3 * key.vertex_count(), 0.5F);
    key.fields = {{"other", FieldKind::color, zeros}, {"color", FieldKind::color, halves}};
    put(folder / "m.obj", obj_text(key.roots.triangles(), key.positions, key.fields));
    CHECK(read_obj(folder / "m.obj").fields.at(0).values == halves);
}

}  // namespace interleaf
