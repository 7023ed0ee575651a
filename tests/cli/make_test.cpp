// `interleaf make`: keys from formulas, the built-in family of such keys, and sequences.
#include <algorithm>
#include <utility>

#include "cli/process.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "hierarchy/measure.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {
namespace {

Hierarchy make(const std::vector<std::string>& arguments) {
    const ScratchFolder folder;
    std::vector<std::string> line = {"make", "-o", folder / "key.ilh"};
    line.insert(line.end(), arguments.begin(), arguments.end());
    const Outcome outcome = run_interleaf(line);
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    return read_hierarchy(folder / "key.ilh");
}

TEST_CASE("--list names every shape that can be made") {
    const Outcome outcome = run_interleaf({"make", "--list"});
    CHECK(outcome.status == 0);
    for (const std::string name : {"icosahedron", "bone", "cushion", "star", "sphere", "brezel"}) {
        CAPTURE(name);
        CHECK(contains("\n" + outcome.output, "\n" + name + " "));
        CHECK(make({name, "--leaves", "200"}).leaf_count() <= 200);
    }
}

TEST_CASE("make keeps a budget of leaves, and nearly uses it up") {
    const std::size_t leaves = make({"star", "--leaves", "1000"}).leaf_count();
    CHECK(leaves <= 1000);
    CHECK(leaves > 980);
}

TEST_CASE("make refuses fewer leaves than the shape has roots") {
    const ScratchFolder folder;
    const Outcome outcome = run_interleaf({"make", "brezel", "--leaves", "143", "-o", folder / "brezel.ilh"});
    CHECK(outcome.status == 2);
    CHECK(contains(outcome.errors, "144 roots"));
    CHECK(make({"brezel", "--leaves", "144"}).leaf_count() == 144);
}

TEST_CASE("a smaller tolerance makes more leaves") {
    CHECK(make({"sphere", "--tolerance", "0.0005"}).leaf_count() >
          make({"sphere", "--tolerance", "0.005"}).leaf_count());
}

TEST_CASE("a compressed key is the same key in fewer bytes, and a rounded key takes fewer still") {
    const ScratchFolder folder;
    const auto write = [&](const std::string& name, const std::vector<std::string>& options) {
        std::vector<std::string> line = {"make", "star", "--leaves", "5000", "-o", folder / name};
        line.insert(line.end(), options.begin(), options.end());
        const Outcome outcome = run_interleaf(line);
        REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
        return std::filesystem::file_size(folder / name);
    };
    const std::uintmax_t plain = write("plain.ilh", {});
    const std::uintmax_t compressed = write("compressed.ilh", {"--compress"});
    const std::uintmax_t rounded = write("rounded.ilh", {"--compress", "--bits", "12"});
    CHECK(compressed < plain / 3);
    CHECK(rounded < compressed / 2);

    const Hierarchy key = read_hierarchy(folder / "plain.ilh");
    const Hierarchy same = read_hierarchy(folder / "compressed.ilh");
    CHECK(same.bits == key.bits);
    CHECK(same.midpoints == key.midpoints);
    CHECK(same.positions == key.positions);
    const Hierarchy close = read_hierarchy(folder / "rounded.ilh");
    REQUIRE(close.vertex_count() == key.vertex_count());
    const Box box = bounding_box(key.positions);
    const glm::vec3 sides = box.max - box.min;
    const float bound = std::max({sides.x, sides.y, sides.z}) / 8192;
    for (std::size_t v = 0; v < key.vertex_count(); ++v) {
        const glm::vec3 distance = glm::abs(close.positions[v] - key.positions[v]);
        CHECK(std::max({distance.x, distance.y, distance.z}) <= bound);
    }
}

TEST_CASE("standard output gets the same bytes as a file") {
    const ScratchFolder folder;
    REQUIRE(run_interleaf({"make", "bone", "--leaves", "200", "-o", folder / "bone.ilh"}).status == 0);
    const Outcome outcome = run_interleaf({"make", "bone", "--leaves", "200", "-o", "-"});
    CHECK(outcome.status == 0);
    CHECK(outcome.output == content(folder / "bone.ilh"));
}

TEST_CASE("the shipped family is what `make five-keys` writes") {
    const ScratchFolder folder;
    const Outcome outcome = run_interleaf({"make", "five-keys", "-o", folder / "made"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    CHECK(content(folder / "made/family.json") == content(INTERLEAF_FIVE_KEYS "/family.json"));

    const Family made = read_family(folder / "made");
    const Family shipped = read_family(INTERLEAF_FIVE_KEYS);
    REQUIRE(made.keys.size() == shipped.keys.size());
    for (std::size_t i = 0; i < made.keys.size(); ++i) {
        CAPTURE(shipped.keys[i].name);
        const Hierarchy& ours = *made.keys[i].hierarchy;
        const Hierarchy& theirs = *shipped.keys[i].hierarchy;
        CHECK(made.keys[i].name == shipped.keys[i].name);
        CHECK(ours.roots == theirs.roots);
        CHECK(ours.bits == theirs.bits);
        CHECK(ours.midpoints == theirs.midpoints);
        REQUIRE(ours.positions.size() == theirs.positions.size());
        float farthest = 0;
        for (std::size_t v = 0; v < ours.positions.size(); ++v) {
            farthest = std::max(farthest, glm::distance(ours.positions[v], theirs.positions[v]));
        }
        CHECK(farthest < 1e-6F);  // mathematical libraries may round differently
    }
}

TEST_CASE("--list names the sequences, and each is a sound family with one key more than steps") {
    const ScratchFolder folder;
    const Outcome list = run_interleaf({"make", "--list"});
    for (const std::string name : {"flow", "catenoid"}) {
        CAPTURE(name);
        CHECK(contains(list.output, "\n" + name + " "));
        const Outcome outcome =
            run_interleaf({"make", name, "--steps", "3", "--tolerance", "0.01", "-o", folder / name});
        REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
        CHECK(outcome.output.empty());
        CHECK(outcome.errors.empty());
        CHECK(read_family(folder / name).keys.size() == 4);
        CHECK(run_interleaf({"check", folder / name}).status == 0);
    }
}

TEST_CASE("rings farther apart than 1.3255 radii make a film that collapses") {
    const ScratchFolder folder;
    const Outcome outcome = run_interleaf({"make", "catenoid", "--distance", "1.45", "--steps", "2",
                                           "--tolerance", "0.005", "-o", folder / "collapse", "--compress"});
    REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
    const Family family = read_family(folder / "collapse");
    CHECK(is_compressed_hierarchy(folder / "collapse/step-02.ilh"));
    const Box box = bounding_box(family.keys[0].hierarchy->positions);
    CHECK(box.max.y - box.min.y == doctest::Approx(1.45));
    float neck = 1;
    for (const glm::vec3& position : family.keys[2].hierarchy->positions)
        neck = std::min(neck, glm::length(glm::vec2(position.x, position.z)));
    CHECK(neck < 0.15F);
}

TEST_CASE("the shipped sequences are what make writes, but for the rounding of mathematical libraries") {
    const ScratchFolder folder;
    const std::filesystem::path families = std::filesystem::path(INTERLEAF_FIVE_KEYS).parent_path();
    for (const auto& [name, tolerance] : {std::pair{"flow", "0.001"}, std::pair{"catenoid", "0.0005"}}) {
        CAPTURE(name);
        const Outcome outcome = run_interleaf({"make", name, "--steps", "30", "--tolerance", tolerance, "-o",
                                               folder / name, "--compress", "--bits", "16"});
        REQUIRE_MESSAGE(outcome.status == 0, outcome.errors);
        const Family made = read_family(folder / name);
        const Family shipped = read_family(families / name);
        CHECK(made.name == shipped.name);
        REQUIRE(made.timeline.has_value());
        CHECK(made.timeline->end() == doctest::Approx(shipped.timeline->end()).epsilon(0.05));
        REQUIRE(made.keys.size() == shipped.keys.size());
        for (std::size_t i = 0; i < made.keys.size(); ++i) {
            CAPTURE(i);
            const Hierarchy& ours = *made.keys[i].hierarchy;
            const Hierarchy& theirs = *shipped.keys[i].hierarchy;
            CHECK(made.keys[i].name == shipped.keys[i].name);
            CHECK(ours.roots == theirs.roots);
            const auto leaves = static_cast<double>(theirs.leaf_count());
            CHECK(static_cast<double>(ours.leaf_count()) == doctest::Approx(leaves).epsilon(0.05));
            const Box box = bounding_box(ours.positions);
            CHECK(glm::distance(box.min, bounding_box(theirs.positions).min) < 0.01F * box.diagonal());
            CHECK(glm::distance(box.max, bounding_box(theirs.positions).max) < 0.01F * box.diagonal());
        }
    }
}

TEST_CASE("an adaptive domain is bisected where the shape needs it; wrong constants are refused by name") {
    const ScratchFolder folder;
    const std::vector<std::string> stars = {"family",          "--adapt",     "star",
                                            "--range",         "arm=0.2:1.2", "--range",
                                            "sharpness=10:40", "-o",          folder / "stars"};
    const auto with = [&](std::vector<std::string> more) {
        more.insert(more.begin(), stars.begin(), stars.end());
        return run_interleaf(more);
    };
    const Outcome made = with({"--tolerance", "0.03"});
    REQUIRE_MESSAGE(made.status == 0, made.errors);
    const Family family = read_family(folder / "stars");
    CHECK(made.output == fmt::format("{} keys, {} triangles in the domain\n", family.keys.size(),
                                     family.domain->triangles().size()));
    CHECK(family.keys.size() > 4);
    CHECK_FALSE(family.timeline);
    const Outcome cushions =
        run_interleaf({"family", "--adapt", "cushion", "--range", "height=0.2:0.9", "--range", "length=0.5:2",
                       "--tolerance", "0.05", "-o", folder / "cushions"});
    CHECK_MESSAGE(cushions.status == 0, cushions.errors);
    CHECK(contains(with({}).errors, "--tolerance"));
    CHECK(contains(with({"--tolerance", "0.03", "--interpolation", "hold"}).errors, "no timeline"));
    CHECK(contains(with({"--tolerance", "0.03", "--range", "core=1:2"}).errors, "two --range"));
    const auto refusal = [&](const char* shape, const char* u, const char* v) {
        const Outcome outcome = run_interleaf({"family", "--adapt", shape, "--range", u, "--range", v,
                                               "--tolerance", "0.1", "-o", folder / "x"});
        CHECK(outcome.status == 2);
        CHECK(is_one_message(outcome.errors));
        return outcome.errors;
    };
    CHECK(contains(refusal("sphere", "a=0:1", "b=0:1"), "bone, cushion, star, flow"));
    CHECK(contains(refusal("star", "arm=0:1", "arms=0:1"), "core, arm, sharpness"));
    CHECK(contains(refusal("star", "arm=0:1", "arm=0:1"), "different"));
    CHECK(contains(refusal("star", "arm=0:9", "core=1:2"), "from 0 to 3"));
    CHECK(contains(refusal("star", "arm", "core=1:2"), "NAME=A:B"));
}

}  // namespace
}  // namespace interleaf
