// `interleaf export`: the written file is the morphed union.
#include <algorithm>
#include <filesystem>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>

#include "hierarchy/measure.h"
#include "hierarchy/morph.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/mesh/obj_keys.h"

namespace interleaf {
namespace {

/// The triangles of a hierarchy's leaves.
std::vector<Triangle> triangles_of(const Hierarchy& hierarchy) {
    std::vector<Triangle> triangles;
    for (const Leaf& leaf : leaves_of(hierarchy)) triangles.push_back(leaf.vertices);
    return triangles;
}

/// The same triangles with their corners as points, so that the numbering of vertices does not matter.
std::vector<std::array<glm::vec3, 3>> corners_of(const Hierarchy& hierarchy) {
    std::vector<std::array<glm::vec3, 3>> corners;
    for (const auto& [i, j, k] : triangles_of(hierarchy)) {
        corners.push_back({hierarchy.positions[i], hierarchy.positions[j], hierarchy.positions[k]});
    }
    return corners;
}

Outcome export_to(const std::string& file, std::vector<std::string> choice) {
    choice.insert(choice.begin(), {"export", "-o", file});
    return run_interleaf(choice);
}

TEST_CASE("an exported OBJ is the morphed union, closed, each refinement edge opposite the first vertex") {
    const ScratchFolder folder;
    const Outcome outcome = export_to(folder / "u.obj", {"--at", "0.3,0.4"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(outcome.output.empty());
    CHECK(outcome.errors.empty());

    const Family family = read_family(INTERLEAF_FIVE_KEYS);
    const Weights weights = family.domain->weights(family.domain->locate({0.3, 0.4}));
    REQUIRE(weights.size() == 3);
    const UnionMesh mesh = unite(family, weights);

    const Hierarchy obj = read_obj(folder / "u.obj");
    const auto triangles = obj.roots.triangles();
    CHECK(is_closed_manifold(triangles));
    CHECK(euler_number(triangles) == 2);
    CHECK(std::ranges::equal(triangles, mesh.triangles));
    CHECK(std::ranges::equal(obj.positions, morph(mesh, weight_values(weights))));
}

TEST_CASE("at each corner of the domain the exported surface has the key's area and volume") {
    const ScratchFolder folder;
    const Family family = read_family(INTERLEAF_FIVE_KEYS);
    for (const DomainVertex& vertex : family.domain->vertices()) {
        const Key& key = family.keys[vertex.key];
        CAPTURE(key.name);
        const std::string at = std::to_string(vertex.at.x) + "," + std::to_string(vertex.at.y);
        REQUIRE(export_to(folder / "corner.obj", {"--at", at}).status == 0);

        const Hierarchy obj = read_obj(folder / "corner.obj");
        CHECK(obj.roots.triangle_count() > key.hierarchy->leaf_count());
        const Measures exported = measure(obj.roots.triangles(), obj.positions);
        const Measures own = measure(triangles_of(*key.hierarchy), key.hierarchy->positions);
        CHECK(exported.area == doctest::Approx(own.area).epsilon(1e-6));
        CHECK(exported.volume == doctest::Approx(own.volume).epsilon(1e-6));
    }
}

TEST_CASE("an exported key has the faces of the exported OBJ, in their order") {
    const ScratchFolder folder;
    REQUIRE(export_to(folder / "u.obj", {"--at", "0.3,0.4"}).status == 0);
    REQUIRE(export_to(folder / "u.ilh", {"--at", "0.3,0.4"}).status == 0);
    const Hierarchy key = read_hierarchy(folder / "u.ilh");
    CHECK(key.roots == read_family(INTERLEAF_FIVE_KEYS).keys[0].hierarchy->roots);
    CHECK(corners_of(key) == corners_of(read_obj(folder / "u.obj")));
}

TEST_CASE("an exported PLY announces the union and has the size that it announces") {
    const ScratchFolder folder;
    REQUIRE(export_to(folder / "u.ply", {"--time", "1"}).status == 0);
    REQUIRE(export_to(folder / "u.obj", {"--time", "1"}).status == 0);
    const Hierarchy obj = read_obj(folder / "u.obj");
    const std::string ply = content(folder / "u.ply");
    const std::string end = "end_header\n";
    CHECK(contains(ply, "element vertex " + std::to_string(obj.vertex_count()) + "\n"));
    CHECK(contains(ply, "element face " + std::to_string(obj.leaf_count()) + "\n"));
    CHECK(ply.size() - (ply.find(end) + end.size()) == 12 * obj.vertex_count() + 13 * obj.leaf_count());
}

TEST_CASE("standard output gets the same bytes as a file") {
    const ScratchFolder folder;
    for (const std::string format : {"obj", "ply", "ilh", "glb", "html"}) {
        CAPTURE(format);
        REQUIRE(export_to(folder / ("u." + format), {"--at", "-0.2,0.1"}).status == 0);
        const Outcome outcome = export_to("-", {"--at", "-0.2,0.1", "--format", format});
        CHECK(outcome.status == 0);
        CHECK(outcome.output == content(folder / ("u." + format)));
    }
}

TEST_CASE("a key exported in compressed form is the same key") {
    const ScratchFolder folder;
    REQUIRE(export_to(folder / "plain.ilh", {"--at", "0.3,0.4"}).status == 0);
    REQUIRE(export_to(folder / "compressed.ilh", {"--at", "0.3,0.4", "--compress"}).status == 0);
    CHECK(std::filesystem::file_size(folder / "compressed.ilh") <
          std::filesystem::file_size(folder / "plain.ilh") / 4);
    const Hierarchy plain = read_hierarchy(folder / "plain.ilh");
    const Hierarchy compressed = read_hierarchy(folder / "compressed.ilh");
    CHECK(compressed.roots == plain.roots);
    CHECK(compressed.bits == plain.bits);
    CHECK(compressed.positions == plain.positions);
    const Outcome outcome = export_to("-", {"--at", "0.3,0.4", "--format", "ilh", "--compress"});
    CHECK(outcome.output == content(folder / "compressed.ilh"));
}

TEST_CASE("export names the formats that it knows, and the formats that hold a key") {
    const ScratchFolder folder;
    const Outcome unknown = export_to(folder / "u.stl", {});
    CHECK(unknown.status == 2);
    CHECK(contains(unknown.errors, "u.stl: expected the format ilh, obj, ply"));
    const Outcome mesh = export_to(folder / "u.obj", {"--compress"});
    CHECK(mesh.status == 2);
    CHECK(contains(mesh.errors, "--compress: expected the format ilh, got 'obj'"));
    const Outcome family = export_to(folder / "family.json", {});
    CHECK(family.status == 2);
    CHECK_FALSE(std::filesystem::exists(folder / "family.json"));
}

TEST_CASE("an exported glTF file opens as the family") {
    const ScratchFolder folder;
    REQUIRE(run_interleaf({"export", INTERLEAF_FIVE_KEYS, "-o", folder / "five.glb"}).status == 0);
    const Outcome info = run_interleaf({"info", folder / "five.glb"});
    CHECK(contains(info.output, "Five keys"));
    CHECK(contains(info.output, "timeline, seconds, linear"));
    CHECK(contains(info.output, "parameter domain, 4 triangles"));
    const Outcome blend =
        run_interleaf({"export", folder / "five.glb", "--time", "3", "--format", "obj", "-o", "-"});
    CHECK_MESSAGE(blend.status == 0, blend.errors);
    const Outcome fitted = run_interleaf({"check", folder / "five.glb"});
    CHECK_MESSAGE(fitted.status == 0, fitted.errors);
}

TEST_CASE("segments are for glTF and for linear timelines, and weights beyond 0 to 1 are told") {
    const ScratchFolder folder;
    CHECK(export_to(folder / "s.glb", {"--segments"}).status == 0);
    const Outcome mesh = export_to(folder / "s.obj", {"--segments"});
    CHECK(mesh.status == 2);
    CHECK(contains(mesh.errors, "--segments: expected the format glb, got 'obj'"));
    REQUIRE(run_interleaf({"family", INTERLEAF_FIVE_KEYS, "--interpolation", "spline", "-o", folder / "s"})
                .status == 0);
    const Outcome spline = run_interleaf({"export", folder / "s", "-o", folder / "s.glb"});
    CHECK(spline.status == 0);
    CHECK(contains(spline.errors, "s.glb: the animation has weights from -0."));
    const Outcome segments = run_interleaf({"export", folder / "s", "--segments", "-o", folder / "t.glb"});
    CHECK(segments.status == 2);
    CHECK_FALSE(std::filesystem::exists(folder / "t.glb"));
}

TEST_CASE("parts turn in what is written, but for morph targets and pages, which tell") {
    const ScratchFolder folder;
    REQUIRE(run_interleaf({"family", INTERLEAF_FIVE_KEYS, "--blend", "turning", "-o", folder / "t"}).status ==
            0);
    const auto written = [&](const std::string& family, const std::string& file) {
        return run_interleaf({"export", family, "--weights", "star=0.5,bone=0.5", "-o", folder / file});
    };
    const auto mesh_of = [&](const std::string& family) {
        const Outcome outcome =
            run_interleaf({"export", family, "--weights", "star=0.5,bone=0.5", "--format", "obj", "-o", "-"});
        CHECK(outcome.errors.empty());
        return outcome.output;
    };
    CHECK(mesh_of(folder / "t") != mesh_of(INTERLEAF_FIVE_KEYS));
    REQUIRE(run_interleaf({"family", folder / "t", "--blend", "straight", "-o", folder / "s"}).status == 0);
    CHECK(mesh_of(folder / "s") == mesh_of(INTERLEAF_FIVE_KEYS));
    CHECK(contains(written(folder / "t", "t.glb").errors, "t.glb: morph targets blend straight"));
    CHECK(contains(written(folder / "t", "t.html").errors, "t.html: a web page blends straight"));
    CHECK(written(folder / "s", "s.glb").errors.empty());
    CHECK(contains(run_interleaf({"info", folder / "t"}).output, "blend turning"));
    const Outcome unknown =
        run_interleaf({"family", INTERLEAF_FIVE_KEYS, "--blend", "round", "-o", folder / "u"});
    CHECK(unknown.status == 2);
    CHECK(contains(unknown.errors, "--blend: expected straight or turning, got 'round'"));
}

TEST_CASE("points and times outside are clamped, and the default is time 0") {
    const auto exported = [](std::vector<std::string> choice) {
        choice.insert(choice.end(), {"--format", "obj"});
        const Outcome outcome = export_to("-", choice);
        CHECK(outcome.status == 0);
        return outcome.output;
    };
    CHECK(exported({}) == exported({"--time", "0"}));
    CHECK(exported({"--time", "-3"}) == exported({"--time", "0"}));
    CHECK(exported({"--time", "1e9"}) == exported({"--time", "10"}));
    CHECK(exported({"--time", "1"}) != exported({"--time", "0"}));
    CHECK(exported({"--at", "0.25,7"}) == exported({"--at", "0.25,1"}));
    CHECK(exported({"--at=0.25,1"}) != exported({"--at", "0.5,1"}));
}

TEST_CASE("weights are used as given: negative, and with any sum") {
    const ScratchFolder folder;
    REQUIRE(export_to(folder / "w.obj", {"--weights", "star=1.5,sphere=-0.75"}).status == 0);
    const Family family = read_family(INTERLEAF_FIVE_KEYS);
    const Weights weights = sorted_weights(
        {{find_key(family, "star").value(), 1.5}, {find_key(family, "sphere").value(), -0.75}});
    CHECK(std::ranges::equal(read_obj(folder / "w.obj").positions,
                             morph(unite(family, weights), weight_values(weights))));
}

TEST_CASE("a single key or mesh needs no choice of a blend") {
    const ScratchFolder folder;
    REQUIRE(run_interleaf({"export", INTERLEAF_FIVE_KEYS "/star.ilh", "-o", folder / "star.obj"}).status ==
            0);
    const Hierarchy star = read_hierarchy(INTERLEAF_FIVE_KEYS "/star.ilh");
    CHECK(corners_of(read_obj(folder / "star.obj")) == corners_of(star));
    REQUIRE(run_interleaf({"export", folder / "star.obj", "-o", folder / "again.obj"}).status == 0);
    CHECK(content(folder / "again.obj") == content(folder / "star.obj"));

    const Outcome outcome =
        run_interleaf({"export", folder / "star.obj", "--at", "0,0", "-o", folder / "a.obj"});
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.errors, "--at"));
}

TEST_CASE("on a full disk an export of the whole family fails with the file's name, and leaves nothing") {
    for (const char* const name : {"a.glb", "a.html", "a.pvd"}) {
        CAPTURE(name);
        const ScratchFolder folder;
        const Outcome outcome = run_interleaf(
            {"export", "-o", folder / name}, {.standard_output = {}, .max_file_size = 50'000, .display = {}});
        CHECK(outcome.status == 3);
        CHECK(is_one_message(outcome.errors));
        CHECK(contains(outcome.errors, (folder / "a.").string()));
        CHECK(contains(outcome.errors, "cannot write: File too large"));
        CHECK(std::filesystem::is_empty(folder.path()));
    }
}

TEST_CASE("one key goes out in every format of whole families") {
    const ScratchFolder folder;
    REQUIRE(run_interleaf({"make", "star", "--leaves", "200", "-o", folder / "star.ilh"}).status == 0);
    for (const char* const name : {"a.glb", "a.html"}) {
        const Outcome outcome = export_to(folder / name, {folder / "star.ilh"});
        CHECK_MESSAGE(outcome.status == 0, outcome.errors);
    }
    const Outcome series = export_to(folder / "a.pvd", {folder / "star.ilh"});
    CHECK_MESSAGE(series.status == 0, series.errors);
    CHECK(std::filesystem::exists(folder / "a.0000.vtp"));
    CHECK_FALSE(std::filesystem::exists(folder / "a.0001.vtp"));
    const Outcome segments = export_to(folder / "b.glb", {folder / "star.ilh", "--segments"});
    CHECK(segments.status == 2);
    CHECK(contains(segments.errors, "expected a family with a linear timeline of at least two keys"));
}

}  // namespace
}  // namespace interleaf
