// Reading keys whose roots are numbered differently: family.json with "roots", several .ilh, series of OBJ
// files.
#include <algorithm>
#include <cmath>
#include <string>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "hierarchy/random_surfaces.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/mesh/mesh_writer.h"
#include "io/mesh/obj_keys.h"
#include "io/read_files.h"
#include "io/samples.h"

namespace interleaf {

namespace fs = std::filesystem;

namespace {

/// Two keys over a random surface. b.ilh holds the second key with renumbered roots.
struct Shuffled {
    Hierarchy first, second;
    testing::Renumbering renumbering;
};

Shuffled shuffled_keys(std::uint64_t seed, const ScratchFolder& folder) {
    testing::Random random(seed);
    const RootComplex roots = testing::random_surface(static_cast<unsigned>(seed % 4), seed % 3 == 0, random);
    Shuffled keys;
    keys.first = testing::bisected_key(roots, random);
    keys.second = testing::bisected_key(roots, random);
    keys.renumbering = testing::random_renumbering(roots, random);
    for (Index v = 0; v < roots.vertex_count(); ++v)
        keys.second.positions[v] = keys.first.positions[v] + 0.001F * random.point();
    write_hierarchy(keys.first, folder / "a.ilh");
    write_hierarchy(testing::renumbered(keys.second, keys.renumbering), folder / "b.ilh");
    return keys;
}

std::string family_json(std::string_view first_member, std::string_view second_member) {
    return fmt::format(R"({{"format": "interleaf-family", "version": 1, "name": "f", "keys": [)"
                       R"({{"name": "a", "file": "a.ilh"{}}}, {{"name": "b", "file": "b.ilh"{}}}]}})",
                       first_member, second_member);
}

}  // namespace

TEST_CASE("keys are renumbered to match the roots of the first key, and are written that way") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        const ScratchFolder folder;
        const Shuffled keys = shuffled_keys(seed, folder);
        const std::vector<fs::path> files{folder / "a.ilh", folder / "b.ilh"};
        put(folder / "family.json", family_json("", ""));
        for (const bool is_family : {true, false}) {
            std::vector<std::string> changes;
            const Family family =
                is_family ? read_family(folder.path(), &changes) : read_keys(files, &changes);
            REQUIRE(changes == std::vector<std::string>{"key b: its roots were renumbered to match key a"});
            REQUIRE(is_same(*family.keys[0].hierarchy, keys.first));
            REQUIRE(is_same(*family.keys[1].hierarchy, keys.second));

            write_family(family, folder / "written");
            changes.clear();
            const Family again = read_family(folder / "written", &changes);
            REQUIRE(changes.empty());
            REQUIRE(is_same(*again.keys[1].hierarchy, keys.second));
        }
    }
}

TEST_CASE("root r of the family is the root of the key's file that the permutation gives") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        const ScratchFolder folder;
        const Shuffled keys = shuffled_keys(seed, folder);
        std::vector<Index> roots = keys.renumbering.roots;
        put(folder / "family.json", family_json("", R"(, "roots": )" + nlohmann::json(roots).dump()));
        std::vector<std::string> changes;
        const Family family = read_family(folder.path(), &changes);
        REQUIRE(changes == std::vector<std::string>{
                               "key b: its roots were renumbered to match key a, by the given permutation"});
        REQUIRE(is_same(*family.keys[1].hierarchy, keys.second));

        // A wrong permutation is rejected where it does not fit.
        std::rotate(roots.begin(), roots.begin() + 1, roots.end());
        put(folder / "family.json", family_json("", R"(, "roots": )" + nlohmann::json(roots).dump()));
        const std::string error = input_error_of([&] { read_family(folder.path()); });
        if (error.empty()) continue;  // another symmetry
        CAPTURE(error);
        REQUIRE(contains(error, "/family.json: keys[1]: key b: root "));
    }
}

TEST_CASE("a hostile permutation is rejected with its place") {
    const ScratchFolder folder;
    const Shuffled keys = shuffled_keys(4, folder);
    const Index count = keys.first.roots.triangle_count();
    std::vector<Index> twice(count);
    twice[0] = 1;
    std::string huge = "0";
    for (int n = 0; n < 400'000; ++n) huge += ",0";
    std::string rest = "0";
    for (Index r = 2; r < count; ++r) rest += ", 0";
    struct Case {
        std::string roots;
        std::string expected;
    };
    const std::vector<Case> cases{
        {"[]", fmt::format("keys[1].roots: has 0 numbers, expected one for each of the {} roots", count)},
        {"[0]", "keys[1].roots: has 1 numbers, expected one for each"},
        {"[" + huge + "]", "keys[1].roots: has 400001 numbers, expected one for each"},
        {"{}", "keys[1].roots: is an object, expected an array"},
        {"null", "keys[1].roots: is null, expected an array"},
        {nlohmann::json(twice).dump(),
         "keys[1].roots[2]: is 0, the same as roots[1]; expected each root once"},
        {fmt::format("[{}, {}]", count, rest),
         fmt::format("keys[1].roots[0]: is {}, expected a whole", count)},
        {fmt::format("[-1, {}]", rest), "keys[1].roots[0]: is -1, expected a whole number from 0, below"},
        {fmt::format("[4294967296, {}]", rest), "keys[1].roots[0]: is 4294967296, expected"},
        {fmt::format("[0.5, {}]", rest), "keys[1].roots[0]: is 0.5, expected"},
        {fmt::format("[\"0\", {}]", rest), "keys[1].roots[0]: is \"0\", expected"}};
    for (const Case& hostile : cases) {
        put(folder / "family.json", family_json("", R"(, "roots": )" + hostile.roots));
        const std::string error = input_error_of([&] { read_family(folder.path()); });
        INFO("expected: ", hostile.expected, "   got: ", error);
        CHECK(contains(error, "family.json: " + hostile.expected));
    }
    put(folder / "family.json", family_json(R"(, "roots": [0])", ""));
    CHECK(contains(
        input_error_of([&] { read_family(folder.path()); }),
        "keys[0].roots: is present, expected none: the first key defines the numbering of the roots"));
}

TEST_CASE("keys over other roots are rejected, each with its file") {
    const ScratchFolder folder;
    testing::Random random(1);
    const auto write = [&](const RootComplex& roots, std::string_view name) {
        write_hierarchy(unrefined(roots, testing::random_points(random, roots.vertex_count())),
                        folder / name);
    };
    write(testing::octahedron(), "a.ilh");
    write(testing::torus(3, 3), "b.ilh");
    write(testing::sheet(2, 2), "c.ilh");
    const std::vector<fs::path> files{folder / "a.ilh", folder / "b.ilh", folder / "c.ilh"};
    const std::string error = input_error_of([&] { read_keys(files); });
    CHECK(contains(error, "/b.ilh: key b: 18 root triangles"));
    CHECK(contains(error, "; " + files[2].string() + ": key c: 8 root triangles, 9 root vertices"));
}

TEST_CASE(
    "OBJ files with the same faces are a family over one root complex, triangulated like the first file") {
    const ScratchFolder folder;
    // A quadrilateral beside a triangle and an unused vertex. Its shorter diagonal differs between the files.
    const std::string faces = "f 1 2 3 4\nf 5 4 3\n";
    put(folder / "m.1.obj", "v 0 0 0\nv 3 0 0\nv 1 1 0\nv 0 3 0\nv 4 4 0\nv 9 9 9\n" + faces);
    put(folder / "m.2.obj", "v -1 -1 0\nv 0.5 0.5 0\nv 1 1 0\nv 0.4 0.5 0\nv 4 4 1\n" + faces);
    put(folder / "m.3.obj",
        "v 0 0 0\nv 0.5 0.5 0\nv 1 1 0\nv 0.4 0.5 0\nv 4 4 1\nf 1/1 2/2 -3 -2\nf 5//1 4 3\n");
    const std::vector<fs::path> files{folder / "m.1.obj", folder / "m.2.obj", folder / "m.3.obj"};
    const Family family = read_keys(files);
    CHECK(family.name == "m.1 to m.3");
    REQUIRE(family.keys.size() == 3);
    CHECK(family.keys[1].name == "m.2");
    const Hierarchy alone = read_obj(files[0]);
    for (const Key& key : family.keys) {
        CHECK(key.hierarchy->roots == alone.roots);
        CHECK(key.hierarchy->roots.triangles().data() == family.keys[0].hierarchy->roots.triangles().data());
    }
    CHECK(family.keys[0].hierarchy->roots.triangle_count() == 3);
    CHECK(family.keys[1].hierarchy->positions[4] == glm::vec3(4, 4, 1));
    CHECK_FALSE(read_obj(files[1]).roots == alone.roots);

    const auto error_with = [&](std::string_view obj) {
        put(folder / "m.2.obj", obj);
        return input_error_of([&] { read_keys(files); });
    };
    const std::string vertices = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 4 4 0\n";
    const std::string first = files[0].string();
    CHECK(error_with(vertices + "f 1 2 3 4\nf 5 3 4\n") ==
          fmt::format("{}: line 7: a face of the vertices (5, 3, 4), expected (5, 4, 3) as in line 8 of {}; "
                      "`interleaf fit` makes keys of meshes with different faces",
                      files[1].string(), first));
    CHECK(contains(error_with(vertices + "f 1 2 3 4\n"), "m.2.obj: has 1 faces, expected 2 as in " + first));
    CHECK(contains(error_with(vertices + "f 1 2 3 4\nf 5 4 3\nf 1 2 5\n"),
                   "m.2.obj: has 3 faces, expected 2 as in " + first));
    CHECK(
        contains(error_with(vertices + "f 1 2 3 4\nf 5 4 9\n"), "m.2.obj: line 7: vertex 9 does not exist"));
}

TEST_CASE("meshes far from 0 share the origin of the first mesh, and files keep their millimeters") {
    const ScratchFolder folder;
    const std::string faces = "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    const std::string corners =
        "v 499990.001 5400000.002 250.003\nv 500010.004 5400000.005 250.006\nv 500000.007 5400010.008 "
        "250.009\n";
    put(folder / "m.1.obj", corners + "v 500000.01 5400003.011 260.012\n" + faces);
    put(folder / "m.2.obj", corners + "v 500001.013 5400003.014 270.015\n" + faces);
    const std::vector<fs::path> files{folder / "m.1.obj", folder / "m.2.obj"};
    std::vector<std::string> changes;
    const Family family = read_keys(files, &changes);
    const glm::dvec3 origin(500'000, 5'400'005, 255);
    CHECK(family.origin == origin);
    CHECK(mentions(changes, "Far from 0: (500000, 5400005, 255) was subtracted from all positions."));

    write_family(family, folder / "f");
    const Family again = read_family(folder / "f");
    CHECK(again.origin == origin);
    const auto check_place = [&](const glm::dvec3& place, const glm::dvec3& expected) {
        for (int axis = 0; axis < 3; ++axis) CHECK(std::abs(place[axis] - expected[axis]) < 1e-5);
    };
    const glm::dvec3 expected(500'001.013, 5'400'003.014, 270.015);
    const Hierarchy& key = *again.keys[1].hierarchy;
    check_place(glm::dvec3(key.positions[3]) + origin, expected);
    put(folder / "out.obj", obj_text(key.roots.triangles(), key.positions, {}, again.origin));
    put(folder / "out.ply", ply_bytes(key.roots.triangles(), key.positions, {}, again.origin));
    for (const std::string_view name : {"out.obj", "out.ply"}) {
        const SurfaceFile out = read_surface(folder / name);
        check_place(out.positions[0], {499'990.001, 5'400'000.002, 250.003});
        check_place(out.positions[3], expected);
        CHECK(out.triangles.size() == 4);
    }
    // An exported blend is read back with the same origin.
    const std::vector<fs::path> written{folder / "out.obj"};
    const Family read = read_keys(written);
    CHECK(read.origin == glm::dvec3(500'000, 5'400'005, 260));

    // A mesh near 0 has the origin of the first mesh, too.
    put(folder / "m.2.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + faces);
    CHECK(read_keys(files).keys[1].hierarchy->positions[1] == glm::vec3(-499'999, -5'400'005, -255));
    put(folder / "m.1.obj", "v 3e38 0 0\nv 3.0001e38 0 0\nv 3e38 1e34 0\nv 3e38 0 1e34\n" + faces);
    put(folder / "m.2.obj", "v -3e38 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n" + faces);
    CHECK(contains(input_error_of([&] { read_keys(files); }),
                   "m.2.obj: vertex 1 (counted from 1): is too far"));
}

TEST_CASE("meshes near 0, or so large that 0 is not far, have no origin") {
    const ScratchFolder folder;
    put(folder / "m.obj", "v 100 0 0\nv 102 0 0\nv 100 2 0\nf 1 2 3\n");
    const std::vector<fs::path> files{folder / "m.obj"};
    std::vector<std::string> changes;
    CHECK(read_keys(files, &changes).origin == glm::dvec3(0));
    CHECK(changes.empty());
}

TEST_CASE("a mesh among keys is a key without bisections and takes the marking of the keys") {
    const ScratchFolder folder;
    const Shuffled keys = shuffled_keys(5, folder);
    std::vector<Triangle> triangles(keys.first.roots.triangles().begin(), keys.first.roots.triangles().end());
    for (Triangle& triangle : triangles) std::rotate(triangle.begin(), triangle.begin() + 1, triangle.end());
    const std::span<const glm::vec3> positions =
        std::span(keys.first.positions).first(keys.first.roots.vertex_count());
    put(folder / "base.obj", obj_text(triangles, positions));
    const std::vector<fs::path> files{folder / "base.obj", folder / "a.ilh", folder / "b.ilh"};
    std::vector<std::string> changes;
    const Family family = read_keys(files, &changes);
    CHECK(changes.size() == 2);
    CHECK(changes[0] == "key base: it has no bisections, so its roots took the refinement edges of key a");
    CHECK(family.keys[0].hierarchy->roots == keys.first.roots);
    CHECK(is_same(*family.keys[1].hierarchy, keys.first));
    CHECK(is_same(*family.keys[2].hierarchy, keys.second));
}

TEST_CASE("among several files, the message names the file that is not a key") {
    const ScratchFolder folder;
    shuffled_keys(1, folder);
    put(folder / "family.json", family_json("", ""));
    const std::vector<fs::path> files{folder / "a.ilh", folder / "family.json"};
    CHECK(input_error_of([&] { read_keys(files); }) ==
          files[1].string() +
              ": expected a file that ends in .ilh, .obj, .glb or .gltf; `interleaf fit` makes keys of other "
              "meshes");
}

}  // namespace interleaf
