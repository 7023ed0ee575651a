// `interleaf info` and `interleaf check`.
#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

#include "hierarchy/measure.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {
namespace {

using nlohmann::json;

json info(const std::string& file) {
    const Outcome outcome = run_interleaf({"info", file, "--json"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    return json::parse(outcome.output);
}

/// Two triangles that share their refinement edge.
Hierarchy square() {
    return unrefined(RootComplex(4, {{0, 1, 2}, {3, 2, 1}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}});
}

TEST_CASE("the figures of a key are those of its leaves and its file") {
    const std::string file = INTERLEAF_FIVE_KEYS "/star.ilh";
    const json figures = info(file);
    const Hierarchy star = read_hierarchy(file);
    std::vector<Triangle> triangles;
    unsigned lowest = max_level;
    unsigned highest = 0;
    for (const Leaf& leaf : leaves_of(star)) {
        triangles.push_back(leaf.vertices);
        lowest = std::min<unsigned>(lowest, leaf.level);
        highest = std::max<unsigned>(highest, leaf.level);
    }
    const Box box = bounding_box(star.positions);
    CHECK(figures.at("kind") == "hierarchy");
    CHECK(figures.at("roots") == 20);
    CHECK(figures.at("leaves") == triangles.size());
    CHECK(figures.at("vertices") == star.vertex_count());
    CHECK(figures.at("levels") == json{{"min", lowest}, {"max", highest}});
    CHECK(figures.at("bytes") ==
          json{{"memory", star.byte_count()}, {"file", std::filesystem::file_size(file)}});
    CHECK(figures.at("angles").at("min").get<double>() ==
          doctest::Approx(measure(triangles, star.positions).min_angle));
    CHECK(figures.at("euler") == 2);
    CHECK(figures.at("boundary_edges") == 0);
    CHECK(figures.at("box") == json{{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}});
}

TEST_CASE("the figures of a family list its keys, its timeline and its domain") {
    const json figures = info(INTERLEAF_FIVE_KEYS);
    CHECK(figures == info(INTERLEAF_FIVE_KEYS "/family.json"));
    CHECK(figures.at("kind") == "family");
    REQUIRE(figures.at("keys").size() == 5);
    std::uintmax_t bytes = std::filesystem::file_size(INTERLEAF_FIVE_KEYS "/family.json");
    std::size_t leaves = 0;
    for (const json& key : figures.at("keys")) {
        json alone = info(INTERLEAF_FIVE_KEYS "/" + key.at("name").get<std::string>() + ".ilh");
        alone.erase("kind");
        CHECK(key == alone);
        bytes += key.at("bytes").at("file").get<std::uintmax_t>();
        leaves += key.at("leaves").get<std::size_t>();
    }
    CHECK(figures.at("bytes").at("file") == bytes);
    CHECK(figures.at("leaves") == leaves);
    CHECK(figures.at("timeline").at("keys").size() >= 5);
    CHECK(figures.at("domain").at("vertices").size() == 5);
    CHECK(figures.at("domain").at("triangles").size() == 4);
}

TEST_CASE("info prints the form of a file, and of each key of a family") {
    const ScratchFolder folder;
    std::filesystem::copy(INTERLEAF_FIVE_KEYS, folder.path(), std::filesystem::copy_options::recursive);
    const std::string star = folder / "star.ilh";
    CHECK(info(star).at("form") == "plain");
    CHECK(contains(run_interleaf({"info", star}).output, " bytes, plain, 10.26 bytes per leaf\n"));

    write_hierarchy(read_hierarchy(star), star, {.compressed = true, .rounding_bits = 0});
    json figures = info(star);
    CHECK(figures.at("form") == "compressed");
    CHECK(figures.at("bytes").at("file") == std::filesystem::file_size(star));
    CHECK(contains(run_interleaf({"info", star}).output, " bytes, compressed, 1."));

    const json family = info(folder.path().string());
    CHECK_FALSE(family.contains("form"));
    std::uintmax_t bytes = std::filesystem::file_size(folder / "family.json");
    for (const json& key : family.at("keys")) {
        const std::string name = key.at("name");
        CHECK(key.at("form") == (name == "star" ? "compressed" : "plain"));
        CHECK(key.at("bytes").at("file") == std::filesystem::file_size(folder / (name + ".ilh")));
        bytes += std::filesystem::file_size(folder / (name + ".ilh"));
    }
    CHECK(family.at("bytes").at("file") == bytes);
    CHECK(contains(run_interleaf({"info", folder.path().string()}).output, "  compressed\n"));
}

TEST_CASE("an open mesh has level 0 and boundary edges") {
    const ScratchFolder folder;
    put(folder / "square.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nf 4 3 2\n");
    const json figures = info(folder / "square.obj");
    CHECK(figures.at("kind") == "mesh");
    CHECK_FALSE(figures.contains("form"));
    CHECK(figures.at("leaves") == 2);
    CHECK(figures.at("levels") == json{{"min", 0}, {"max", 0}});
    CHECK(figures.at("euler") == 1);
    CHECK(figures.at("boundary_edges") == 4);
    CHECK(figures.at("angles").at("min").get<double>() == doctest::Approx(45));
    CHECK(figures.at("bytes").at("file") == std::filesystem::file_size(folder / "square.obj"));
}

TEST_CASE("the text form shows the same figures") {
    const Outcome key = run_interleaf({"info", INTERLEAF_FIVE_KEYS "/star.ilh"});
    CHECK(key.status == 0);
    CHECK(contains(key.output, "\nleaves        20,000\n"));
    const Outcome family = run_interleaf({"info", INTERLEAF_FIVE_KEYS});
    CHECK(family.status == 0);
    for (const std::string part :
         {"Five keys", "icosahedron", "bone", "cushion", "star", "sphere", "timeline"}) {
        CHECK(contains(family.output, part));
    }
}

TEST_CASE("check accepts sound files, one line each") {
    const Outcome outcome = run_interleaf(
        {"check", INTERLEAF_FIVE_KEYS, INTERLEAF_FIVE_KEYS "/star.ilh", INTERLEAF_FIVE_KEYS "/bone.ilh"});
    CHECK(outcome.status == 0);
    CHECK(outcome.errors.empty());
    CHECK(std::ranges::count(outcome.output, '\n') == 3);
    CHECK(contains(outcome.output, INTERLEAF_FIVE_KEYS "/bone.ilh: sound"));
}

TEST_CASE("check names the faulty file, and continues with the others") {
    const ScratchFolder folder;
    std::string bytes = content(INTERLEAF_FIVE_KEYS "/star.ilh");
    bytes[bytes.size() / 2] ^= 1;
    put(folder / "damaged.ilh", bytes);
    const Outcome outcome = run_interleaf(
        {"check", folder / "damaged.ilh", folder / "missing.ilh", INTERLEAF_FIVE_KEYS "/star.ilh"});
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "interleaf: " + (folder / "damaged.ilh").string() + ": "));
    CHECK(contains(outcome.errors, "interleaf: " + (folder / "missing.ilh").string() + ": "));
    CHECK(outcome.output == INTERLEAF_FIVE_KEYS "/star.ilh: sound, 1 key\n");
}

TEST_CASE("check names a file that cannot be opened, continues, and exits with 3 whatever else is faulty") {
    const ScratchFolder folder;
    std::filesystem::create_symlink("loop.ilh", folder.path() / "loop.ilh");
    put(folder / "damaged.ilh", "not a hierarchy");
    const std::string star = INTERLEAF_FIVE_KEYS "/star.ilh";
    const Outcome outcome =
        run_interleaf({"check", folder / "loop.ilh", star, folder / "damaged.ilh", folder / "loop.ilh"});
    CHECK(outcome.status == 3);
    CHECK(outcome.output == star + ": sound, 1 key\n");
    CHECK(std::ranges::count(outcome.errors, '\n') == 3);
    const std::string loop = "interleaf: " + (folder / "loop.ilh").string() + ": cannot open: ";
    CHECK(outcome.errors.starts_with(loop));
    CHECK(outcome.errors.rfind(loop) > outcome.errors.find(folder / "damaged.ilh"));
    CHECK(run_interleaf({"check", star, folder / "loop.ilh"}).status == 3);
}

TEST_CASE("check names every damaged key of a family") {
    const ScratchFolder folder;
    std::filesystem::copy(INTERLEAF_FIVE_KEYS, folder.path(), std::filesystem::copy_options::recursive);
    put(folder / "bone.ilh", "damaged");
    put(folder / "star.ilh", "damaged");
    const Outcome outcome = run_interleaf({"check", folder.path().string()});
    CHECK(outcome.status == 1);
    CHECK(contains(outcome.errors, "bone.ilh: signature"));
    CHECK(contains(outcome.errors, "star.ilh: signature"));
    CHECK_FALSE(contains(outcome.errors, "sphere.ilh"));
}

TEST_CASE("info prints area, volume, parts, openings and handles of any mesh, and check checks it") {
    const ScratchFolder folder;
    const std::string star = INTERLEAF_FIVE_KEYS "/star.ilh";
    REQUIRE(run_interleaf({"export", star, "-o", folder / "star.ply"}).status == 0);
    const json key = info(star);
    const json mesh = info(folder / "star.ply");
    CHECK(mesh.at("kind") == "mesh");
    CHECK(mesh.at("triangles") == key.at("leaves"));
    CHECK(mesh.at("vertices") == key.at("vertices"));
    for (const char* figure : {"area", "volume"})
        CHECK(mesh.at(figure).get<double>() == doctest::Approx(key.at(figure).get<double>()).epsilon(1e-6));
    for (const json& each : {key, mesh}) {
        CHECK(each.at("parts") == 1);
        CHECK(each.at("openings") == 0);
        CHECK(each.at("handles") == 0);
    }
    CHECK(contains(run_interleaf({"info", folder / "star.ply"}).output, "1, closed, without handles"));

    put(folder / "open.off", "OFF\n4 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n");
    const json open = info(folder / "open.off");
    CHECK(open.at("openings") == 1);
    CHECK(open.at("volume").is_null());
    const Outcome checked = run_interleaf({"check", folder / "star.ply", folder / "open.off"});
    CHECK(checked.status == 1);
    CHECK(contains(checked.output, "star.ply: sound, a mesh to fit a key to"));
    CHECK(contains(checked.errors, "open.off: the surface has 1 hole"));
}

TEST_CASE("the kind of a file does not depend on the case of its extension") {
    const ScratchFolder folder;
    write_hierarchy(square(), folder / "SQUARE.ILH");
    CHECK(info(folder / "SQUARE.ILH").at("kind") == "hierarchy");
}

TEST_CASE("a message is one line, whatever the name of the file") {
    const Outcome outcome = run_interleaf({"info", "first\nsecond.ilh"});
    CHECK(outcome.status == 1);
    CHECK(is_one_message(outcome.errors));
    CHECK(contains(outcome.errors, "first\\x0asecond.ilh"));
}

TEST_CASE("check names the keys that do not share their roots: constraints (B)") {
    const ScratchFolder folder;
    write_hierarchy(square(), folder / "square.ilh");
    std::filesystem::copy(INTERLEAF_FIVE_KEYS "/star.ilh", folder.path());
    put(folder / "family.json",
        R"({"format": "interleaf-family", "version": 1, "name": "mixed", "keys": [)"
        R"({"name": "star", "file": "star.ilh"}, {"name": "square", "file": "square.ilh"}]})");
    const Outcome outcome = run_interleaf({"check", folder.path().string()});
    CHECK(outcome.status == 1);
    CHECK(outcome.output.empty());
    CHECK(contains(outcome.errors, "family.json"));
    CHECK(contains(outcome.errors, "keys[1]: key square: 2 root triangles"));
    CHECK(contains(outcome.errors, "square"));
}

}  // namespace
}  // namespace interleaf
