// `interleaf lod`: cuts keys to a level of detail.
#include <algorithm>
#include <fstream>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {
namespace {

const std::string star_file = INTERLEAF_FIVE_KEYS "/star.ilh";

Outcome lod(const std::string& from, const std::string& to, std::vector<std::string> options) {
    options.insert(options.begin(), {"lod", from, "-o", to});
    return run_interleaf(options);
}

/// The key \p from cut with \p options.
Hierarchy cut_key(const std::string& from, const std::vector<std::string>& options) {
    const ScratchFolder folder;
    const Outcome outcome = lod(from, folder / "cut.ilh", options);
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(outcome.errors.empty());
    return read_hierarchy(folder / "cut.ilh");
}

bool are_equal(const Hierarchy& a, const Hierarchy& b) {
    return a.roots == b.roots && a.bits == b.bits && a.midpoints == b.midpoints && a.positions == b.positions;
}

TEST_CASE("a number of leaves is kept and nearly used up, and the cut is sound") {
    const Hierarchy cut = cut_key(star_file, {"--leaves", "2000"});
    CHECK(cut.leaf_count() <= 2000);
    CHECK(cut.leaf_count() > 1800);
    CHECK(check(cut).empty());
    CHECK(cut.roots == read_hierarchy(star_file).roots);
}

TEST_CASE("the number of roots leaves the roots, and as many leaves as there are leave the key as it is") {
    CHECK(cut_key(star_file, {"--leaves", "20"}).leaf_count() == 20);
    CHECK(are_equal(cut_key(star_file, {"--leaves", "2e4"}), read_hierarchy(star_file)));
    CHECK(are_equal(cut_key(star_file, {"--leaves", "1e6"}), read_hierarchy(star_file)));
}

TEST_CASE("a larger tolerance leaves fewer leaves, down to the roots") {
    const std::size_t fine = cut_key(star_file, {"--tolerance", "0.0005"}).leaf_count();
    const std::size_t coarse = cut_key(star_file, {"--tolerance", "0.005"}).leaf_count();
    CHECK(fine > coarse);
    CHECK(coarse > 20);
    CHECK(cut_key(star_file, {"--tolerance", "1"}).leaf_count() == 20);
}

TEST_CASE("a line per key says what was done, and standard output gets the bytes that a file gets") {
    const ScratchFolder folder;
    const Outcome outcome = lod(star_file, folder / "cut.ilh", {"--tolerance", "0.002"});
    REQUIRE(outcome.status == 0);
    CHECK(outcome.output.starts_with("star: "));
    CHECK(contains(outcome.output, " of 20,000 leaves, at most "));
    CHECK(contains(outcome.output, " % of the box diagonal"));
    const std::string before = "at most ";
    const double percent = std::stod(outcome.output.substr(outcome.output.find(before) + before.size()));
    CHECK(percent > 0.1);
    CHECK(percent <= 0.2);
    CHECK(std::ranges::count(outcome.output, '\n') == 1);
    CHECK(lod(star_file, "-", {"--tolerance", "0.002"}).output == content(folder / "cut.ilh"));
}

TEST_CASE("a family keeps its timeline and its domain, and each key is cut") {
    const ScratchFolder folder;
    const Outcome outcome = lod(INTERLEAF_FIVE_KEYS, folder / "cut", {"--leaves", "1000"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(std::ranges::count(outcome.output, '\n') == 5);
    CHECK(content(folder / "cut/family.json") == content(INTERLEAF_FIVE_KEYS "/family.json"));
    const Family whole = read_family(INTERLEAF_FIVE_KEYS);
    const Family cut = read_family(folder / "cut");
    for (std::size_t i = 0; i < whole.keys.size(); ++i) {
        CAPTURE(whole.keys[i].name);
        CHECK(cut.keys[i].hierarchy->leaf_count() <= 1000);
        const std::string key = INTERLEAF_FIVE_KEYS "/" + whole.keys[i].name + ".ilh";
        CHECK(are_equal(*cut.keys[i].hierarchy, cut_key(key, {"--leaves", "1000"})));
    }
}

TEST_CASE("a family can be cut in its own folder") {
    const ScratchFolder folder;
    REQUIRE(lod(INTERLEAF_FIVE_KEYS, folder / "family", {"--leaves", "2000"}).status == 0);
    REQUIRE(lod(folder / "family", folder / "family", {"--leaves", "500"}).status == 0);
    for (const Key& key : read_family(folder / "family").keys) CHECK(key.hierarchy->leaf_count() <= 500);
}

TEST_CASE(
    "several key files become a family, a compressed key is smaller, and the faces of a mesh are roots") {
    const ScratchFolder folder;
    REQUIRE(lod(INTERLEAF_FIVE_KEYS "/s*.ilh", folder / "two", {"--leaves", "500"}).status == 0);
    CHECK(read_family(folder / "two").keys.size() == 2);

    REQUIRE(lod(star_file, folder / "plain.ilh", {"--leaves", "3000"}).status == 0);
    REQUIRE(lod(star_file, folder / "small.ilh", {"--leaves", "3000", "--compress"}).status == 0);
    CHECK(std::filesystem::file_size(folder / "small.ilh") <
          std::filesystem::file_size(folder / "plain.ilh") / 2);

    REQUIRE(run_interleaf({"export", star_file, "-o", folder / "star.obj"}).status == 0);
    CHECK(cut_key(folder / "star.obj", {"--tolerance", "0.1"}).leaf_count() == 20000);
}

TEST_CASE("fields go along, and positions far from 0 keep the origin of their family") {
    const ScratchFolder folder;
    Family family = read_family(INTERLEAF_FIVE_KEYS);
    for (Key& key : family.keys) {
        Hierarchy hierarchy = *key.hierarchy;
        Field height{"height", FieldKind::scalar, {}};
        for (const glm::vec3& p : hierarchy.positions) height.values.push_back(p.z);
        hierarchy.fields = {height};
        key.hierarchy = hierarchy;
    }
    family.origin = {4000000, 500000, 100};
    write_family(family, folder / "far");
    REQUIRE(lod(folder / "far", folder / "cut", {"--tolerance", "0.01"}).status == 0);
    const Family cut = read_family(folder / "cut");
    CHECK(cut.origin == family.origin);
    for (const Key& key : cut.keys) {
        REQUIRE(key.hierarchy->fields.size() == 1);
        for (Index v = 0; v < key.hierarchy->vertex_count(); ++v)
            REQUIRE(key.hierarchy->fields[0].at(v)[0] == key.hierarchy->positions[v].z);
    }
}

TEST_CASE("a mesh that must be fitted first, and a missing file, are refused") {
    const ScratchFolder folder;
    std::ofstream(folder / "a.stl") << "solid a\nendsolid a\n";
    CHECK(lod(folder / "a.stl", folder / "b.ilh", {"--leaves", "100"}).status == 1);
    CHECK(lod(folder / "none.ilh", folder / "b.ilh", {"--leaves", "100"}).status == 1);
    CHECK_FALSE(std::filesystem::exists(folder / "b.ilh"));
}

}  // namespace
}  // namespace interleaf
