// `interleaf fit`: keys and families from mesh files, and all inputs that the command rejects.
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <sys/wait.h>

#include "hierarchy/checker.h"
#include "hierarchy/measure.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/mesh/obj_keys.h"

namespace interleaf {
namespace {

/// Writes the key of a shape as an OBJ file: a closed mesh of genus 0.
std::string shape_obj(const ScratchFolder& folder, const std::string& shape, int leaves) {
    const std::string key = folder / (shape + "-made.ilh");
    const std::string mesh = folder / (shape + ".obj");
    REQUIRE(run_interleaf({"make", shape, "--leaves", std::to_string(leaves), "-o", key}).status == 0);
    REQUIRE(run_interleaf({"export", key, "-o", mesh}).status == 0);
    return mesh;
}

std::string off_text(const std::vector<std::array<double, 3>>& points,
                     const std::vector<Triangle>& triangles) {
    std::string text = fmt::format("OFF\n{} {} 0\n", points.size(), triangles.size());
    for (const auto& [x, y, z] : points) text += fmt::format("{} {} {}\n", x, y, z);
    for (const auto& [a, b, c] : triangles) text += fmt::format("3 {} {} {}\n", a, b, c);
    return text;
}

std::string torus_off() {
    std::vector<std::array<double, 3>> points;
    std::vector<Triangle> triangles;
    constexpr Index around = 12;
    for (Index i = 0; i < around; ++i)
        for (Index j = 0; j < around; ++j) {
            const double u = 2 * 3.14159265 * i / around;
            const double v = 2 * 3.14159265 * j / around;
            const double r = 2 + std::cos(v);
            points.push_back({r * std::cos(u), r * std::sin(u), std::sin(v)});
            const Index a = i * around + j;
            const Index b = (i + 1) % around * around + j;
            const Index c = (i + 1) % around * around + (j + 1) % around;
            const Index d = i * around + (j + 1) % around;
            triangles.push_back({a, b, c});
            triangles.push_back({a, c, d});
        }
    return off_text(points, triangles);
}

TEST_CASE(
    "a mesh becomes a key over the cube's roots, with a report, and the same bytes on standard output") {
    const ScratchFolder folder;
    const std::string mesh = shape_obj(folder, "cushion", 800);
    const Outcome outcome =
        run_interleaf({"fit", mesh, "-o", folder / "key.ilh", "--leaves", "4000", "--report", "json"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(outcome.errors.empty());
    const Hierarchy key = read_hierarchy(folder / "key.ilh");
    CHECK(check(key).empty());
    CHECK(key.roots.triangle_count() == 12);
    CHECK(key.leaf_count() <= 4000);
    CHECK(key.leaf_count() > 3980);
    const Box wanted = bounding_box(read_obj(mesh).positions);
    CHECK(bounding_box(key.positions).diagonal() == doctest::Approx(wanted.diagonal()).epsilon(0.01));

    const auto report = nlohmann::json::parse(outcome.output)["meshes"][0];
    CHECK(report["file"] == mesh);
    CHECK(report["key"]["leaves"] == key.leaf_count());
    CHECK(report["quality"]["hausdorff"].get<double>() < 0.005);
    CHECK(report["quality"]["euler"] == 2);
    CHECK(report["seconds"]["clean-up"].get<double>() > 0);
    CHECK(report["seconds"]["whole"].get<double>() > report["seconds"]["clean-up"].get<double>());

    const Outcome again = run_interleaf({"fit", mesh, "-o", "-", "--leaves", "4000"});
    CHECK(again.status == 0);
    CHECK(again.output == content(folder / "key.ilh"));
}

TEST_CASE("fit keeps a tolerance, and takes roots from a file") {
    const ScratchFolder folder;
    const std::string mesh = shape_obj(folder, "cushion", 2500);
    for (const std::string& roots :
         std::vector<std::string>{"icosahedron", "octahedron", folder / "roots.obj"}) {
        CAPTURE(roots);
        put(folder / "roots.obj",
            "v 1 1 1\nv -1 -1 1\nv 1 -1 -1\nv -1 1 -1\n"
            "f 1 2 3\nf 1 4 2\nf 1 3 4\nf 2 4 3\n");
        const Outcome outcome = run_interleaf({"fit", mesh, "-o", folder / "key.ilh", "--tolerance", "0.002",
                                               "--roots", roots, "--report", "json"});
        REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
        CHECK(nlohmann::json::parse(outcome.output)["meshes"][0]["quality"]["hausdorff"].get<double>() <=
              0.002);
        const Index count = roots == "icosahedron" ? 20 : (roots == "octahedron" ? 8 : 4);
        CHECK(read_hierarchy(folder / "key.ilh").roots.triangle_count() == count);
    }
}

TEST_CASE("several meshes become a family over the same roots, and three meshes get a domain") {
    const ScratchFolder folder;
    const std::string star = shape_obj(folder, "star", 2500);
    const std::string cushion = shape_obj(folder, "cushion", 2500);
    const Outcome outcome =
        run_interleaf({"fit", star, cushion, star, "-o", folder / "three", "--leaves", "500", "--rotate",
                       "x,0", "--rotate", "y,90", "--rotate", "z,-20.5", "--match", "none", "--compress"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    const Family three = read_family(folder / "three");
    CHECK(check(three).empty());
    REQUIRE(three.keys.size() == 3);
    CHECK(three.keys[1].name == "cushion");
    CHECK(three.keys[2].name == "star 2");
    CHECK(is_compressed_hierarchy(folder / "three/star.ilh"));
    CHECK(three.timeline->keys().size() == 3);
    CHECK(three.domain->triangles().size() == 1);
}

/// The text of an OBJ file with a box of quads.
/// \param before  number of vertices that stand before the box in the file
/// \param faces   number of faces to write
std::string box_obj(const glm::dvec3& least, const glm::dvec3& most, int before = 0, int faces = 6) {
    std::string text;
    for (int i = 0; i < 8; ++i)
        text += fmt::format("v {} {} {}\n", i & 1 ? most.x : least.x, i & 2 ? most.y : least.y,
                            i & 4 ? most.z : least.z);
    constexpr int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (int face = 0; face < faces; ++face) {
        text += "f";
        for (const int corner : quads[face]) text += fmt::format(" {}", corner + 1 + before);
        text += "\n";
    }
    return text;
}

nlohmann::json fit_report(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "fit");
    arguments.insert(arguments.end(), {"--leaves", "500", "--report", "json"});
    const Outcome outcome = run_interleaf(arguments);
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    return nlohmann::json::parse(outcome.output)["meshes"];
}

TEST_CASE("fit refuses large parts and holes with a description, unless an option accepts them") {
    const ScratchFolder folder;
    const std::string two = folder / "two.obj";
    put(two, box_obj({0, 0, 0}, {2, 2, 2}) + box_obj({5, 0, 0}, {6, 1, 1}, 8));
    Outcome refused = run_interleaf({"fit", two, "-o", folder / "key.ilh"});
    CHECK(refused.status == 1);
    CHECK(is_one_message(refused.errors));
    CHECK(contains(refused.errors, "has 2 parts"));
    CHECK(contains(refused.errors, "20 % of the area would be lost, 20 % (12 triangles)"));
    CHECK(contains(refused.errors, "--keep-largest"));
    const auto kept = fit_report({two, "-o", folder / "key.ilh", "--keep-largest"})[0];
    CHECK(kept["area"]["dropped"].get<double>() == doctest::Approx(0.2));
    CHECK(kept["area"]["made"] == 0);
    CHECK(kept["hausdorff_as_brought"].get<double>() > 10 * kept["quality"]["hausdorff"].get<double>());

    const std::string open = folder / "open.obj";
    put(open, box_obj({0, 0, 0}, {2, 2, 2}, 0, 5));
    refused = run_interleaf({"fit", open, "-o", folder / "key2.ilh"});
    CHECK(refused.status == 1);
    CHECK(contains(refused.errors, "has 1 hole"));
    CHECK(contains(refused.errors, "would add 20 % to its area"));
    CHECK(contains(refused.errors, "--fill-holes"));
    CHECK_FALSE(std::filesystem::exists(folder / "key2.ilh"));
    const auto filled = fit_report({open, "-o", folder / "key2.ilh", "--fill-holes"})[0];
    CHECK(filled["area"]["made"].get<double>() == doctest::Approx(0.2));
}

TEST_CASE("fit reports meshes of different sizes and places, and matches them if an option asks for it") {
    const ScratchFolder folder;
    const std::string first = folder / "first.obj";
    const std::string second = folder / "second.obj";
    put(first, box_obj({0, 0, 0}, {1, 1, 1}));
    put(second, box_obj({90, 0, 0}, {110, 10, 10}));
    const Outcome apart =
        run_interleaf({"fit", first, second, "-o", folder / "apart", "--leaves", "500", "--match", "none"});
    REQUIRE_MESSAGE(apart.status == 0, apart.errors);
    CHECK_FALSE(read_family(folder / "apart").domain);  // of two keys
    CHECK(contains(apart.errors, "second.obj: warning: is 12.9 times as large as the first"));

    const Outcome together =
        run_interleaf({"fit", first, second, "-o", folder / "together", "--leaves", "500", "--same-size",
                       "--same-center", "--up", "Y", "--up", "X", "--match", "none"});
    REQUIRE_MESSAGE(together.status == 0, together.errors);
    CHECK(together.errors.empty());
    const Family family = read_family(folder / "together");
    const Box box = bounding_box(family.keys[1].hierarchy->positions);
    // The second box is 10 x 10 x 20. Each of its two small faces is a tenth of its area, 1000. The first is
    // the unit box, whose area is 6.
    const double side = std::sqrt(6.0 / 10);
    CHECK((box.max - box.min).y == doctest::Approx(2 * side).epsilon(0.02));
    CHECK((box.max - box.min).x == doctest::Approx(side).epsilon(0.02));
    CHECK(box.center().x == doctest::Approx(0.5).epsilon(0.02));
    CHECK(run_interleaf({"fit", first, second, "-o", folder / "x", "--up", "X"}).status == 2);
    CHECK(run_interleaf({"fit", first, "-o", folder / "x.ilh", "--up", "W"}).status == 2);
}

TEST_CASE("meshes far from 0 keep their digits through family and export") {
    const ScratchFolder folder;
    const glm::dvec3 corner(512358.286, 5412347.178, 311.5);
    for (const char* name : {"a.obj", "b.obj"})
        put(folder / name, box_obj(corner, corner + glm::dvec3(2, 3, 4)));
    const auto report =
        fit_report({folder / "a.obj", folder / "b.obj", "-o", folder / "far", "--match", "none"});
    CHECK(contains(report[0]["remarks"][0].get<std::string>(), "was subtracted from all positions"));
    const Family family = read_family(folder / "far");
    CHECK(family.origin == glm::dvec3(512359, 5412349, 314));
    for (const char* name : {"out.obj", "out.ply"}) {
        CAPTURE(name);
        REQUIRE(run_interleaf({"export", folder / "far", "--time", "0.5", "-o", folder / name}).status == 0);
        const auto info = nlohmann::json::parse(run_interleaf({"info", folder / name, "--json"}).output);
        CHECK(info["box"][0][0].get<double>() == doctest::Approx(corner.x).epsilon(1e-8));
        CHECK(info["box"][1][1].get<double>() == doctest::Approx(corner.y + 3).epsilon(1e-9));
        CHECK(info["volume"].get<double>() == doctest::Approx(24).epsilon(0.03));
    }
    const Outcome key = run_interleaf({"export", folder / "far", "--time", "0", "-o", folder / "out.ilh"});
    CHECK(key.status == 0);
    CHECK(contains(key.errors, "(512359, 5412349, 314) was subtracted from all positions"));
}

TEST_CASE("a message about a mesh that has lost digits says so") {
    const ScratchFolder folder;
    std::string stl(80, ' ');
    const auto append = [&](const auto& value) {
        stl.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    append(std::uint32_t{4});
    constexpr float far = 5e6F;
    const std::array<std::array<float, 3>, 4> points{
        {{far, far, 0}, {far + 1, far, 0}, {far, far + 1, 0}, {far, far, 1}}};
    for (const std::array<int, 3>& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) {
        append(std::array<float, 3>{});
        for (const int corner : face) append(points[static_cast<std::size_t>(corner)]);
        append(std::uint16_t{0});
    }
    put(folder / "far.stl", stl);
    const auto info = nlohmann::json::parse(run_interleaf({"info", folder / "far.stl", "--json"}).output);
    REQUIRE(info["remarks"].size() == 1);
    CHECK(contains(info["remarks"][0].get<std::string>(), "digits were lost"));
    CHECK(info["volume"].get<double>() == doctest::Approx(1.0 / 6));
}

TEST_CASE("a mesh that no key can represent exits with 1, and the message names the file and the reason") {
    const ScratchFolder folder;
    const std::vector<std::array<double, 3>> tetrahedron = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    struct Case {
        std::string name;
        std::string content;
        std::string reason;
    };
    const Case cases[] = {
        {"torus.off", torus_off(), "Euler number"},
        {"empty.off", "", "is empty, expected OFF"},
        {"no-faces.off", off_text(tetrahedron, {}), "is a point cloud: it has 4 vertices, but no faces"},
        {"nan.off", "OFF\n3 1 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n", "finite"},
        {"one-triangle.off", off_text(tetrahedron, {{0, 1, 2}}), ""},
        {"flat.off",
         off_text({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}),
         ""},
    };
    for (const Case& each : cases) {
        CAPTURE(each.name);
        put(folder / each.name, each.content);
        const Outcome outcome = run_interleaf({"fit", folder / each.name, "-o", folder / "key.ilh"});
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 1);
        CHECK(is_one_message(outcome.errors));
        CHECK(contains(outcome.errors, each.name));
        CHECK(contains(outcome.errors, each.reason));
        CHECK_FALSE(std::filesystem::exists(folder / "key.ilh"));
    }
}

TEST_CASE("roots that do not cover the sphere are refused, and the message names their file") {
    const ScratchFolder folder;
    const std::string mesh = shape_obj(folder, "sphere", 500);
    put(folder / "roots.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    const Outcome outcome =
        run_interleaf({"fit", mesh, "-o", folder / "key.ilh", "--roots", folder / "roots.obj"});
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "roots.obj: the roots have 3 boundary edges"));
}

TEST_CASE("a command line that makes no sense exits with 2") {
    const ScratchFolder folder;
    const std::string mesh = shape_obj(folder, "sphere", 500);
    const std::string key = folder / "key.ilh";
    const std::vector<std::vector<std::string>> lines = {
        {"fit"},
        {"fit", mesh},
        {"fit", mesh, "-o", folder / "key.obj"},
        {"fit", mesh, "-o", key, "--leaves", "100", "--tolerance", "0.1"},
        {"fit", mesh, "-o", key, "--leaves", "11"},
        {"fit", mesh, "-o", key, "--tolerance", "0"},
        {"fit", mesh, "-o", key, "--match", "sometimes"},
        {"fit", mesh, "-o", key, "--roots", "dodecahedron"},
        {"fit", mesh, "-o", key, "--rotate", "w,90"},
        {"fit", mesh, "-o", key, "--rotate", "x,90", "--rotate", "x,90"},
        {"fit", mesh, mesh, "-o", "-"},
        {"fit", mesh, "-o", "-", "--report", "json"},
        {"fit", mesh, "-o", key, "--report", "xml"},
    };
    for (const std::vector<std::string>& line : lines) {
        CAPTURE(line.size());
        const Outcome outcome = run_interleaf(line);
        CAPTURE(outcome.errors);
        CHECK(outcome.status == 2);
        CHECK(is_one_message(outcome.errors));
        CHECK_FALSE(std::filesystem::exists(key));
    }
}

TEST_CASE("an interrupt ends the work, and leaves no file behind") {
    const ScratchFolder folder;
    const std::string mesh = shape_obj(folder, "star", 60000);
    const std::string key = folder / "key.ilh";
    const auto entries = [&] {
        return std::distance(std::filesystem::directory_iterator(folder.path()), {});
    };
    const auto before = entries();
    // timeout(1) sends the interrupt and waits. Status 124 means that it had to interrupt the program.
    const std::string line =
        fmt::format("timeout --signal=INT 0.3 {} fit {} -o {}", INTERLEAF_PROGRAM, mesh, key);
    const int status = std::system(line.c_str());
    CHECK(WEXITSTATUS(status) == 124);
    CHECK(entries() == before);
}

}  // namespace
}  // namespace interleaf
