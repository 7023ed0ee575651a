// The shipped family of the paper's figure 9, compared with those results of `assets/make-figure-9` that need
// no network.
#include <cstddef>
#include <filesystem>
#include <string>

#include "cli/process.h"
#include "sanitized.h"
#include "scratch_folder.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>

#include "fit/half_way.h"
#include "hierarchy/measure.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {
namespace {

const std::filesystem::path shipped_folder = INTERLEAF_FIGURE_9;

TEST_CASE("figure 9 is shipped as one triangle of bone, bunny and sphere over a cube's roots") {
    const Family family = read_family(shipped_folder);
    CHECK(family.name == "Figure 9");
    REQUIRE(family.keys.size() == 3);
    CHECK(family.keys[0].name == "bone");
    CHECK(family.keys[1].name == "bunny");
    CHECK(family.keys[2].name == "sphere");
    for (const Key& key : family.keys) {
        CAPTURE(key.name);
        CHECK(key.hierarchy->roots.triangle_count() == 12);
        CHECK(key.hierarchy->roots.euler_number() == 2);
        CHECK(is_compressed_hierarchy(shipped_folder / (key.name + ".ilh")));
        const Box box = bounding_box(key.hierarchy->positions);
        CHECK(glm::distance(box.min, box.max) > 2.5F);
        CHECK(glm::distance(box.min, box.max) < 3.5F);
        CHECK(glm::length(box.center()) < 0.2F);
    }
    CHECK(family.keys[1].hierarchy->leaf_count() == 20000);
    REQUIRE(family.domain.has_value());
    REQUIRE(family.domain->triangles().size() == 1);
    CHECK(family.domain->vertices().size() == 3);
    CHECK(run_interleaf({"check", shipped_folder.string()}).status == 0);
}

TEST_CASE("the timeline of figure 9 visits all keys, stays in the domain, and ends where it began") {
    const Family family = read_family(shipped_folder);
    REQUIRE(family.timeline.has_value());
    REQUIRE(family.domain.has_value());
    const auto keys = family.timeline->keys();
    REQUIRE(keys.size() == 4);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        CHECK(keys[i].time == 2.0 * static_cast<double>(i));
        CHECK(keys[i].key == i % 3);
    }
    for (double time = 0; time <= family.timeline->end(); time += 0.125) {
        CAPTURE(time);
        CHECK(family.domain->point_of(family.timeline->at(time)).has_value());
    }
}

TEST_CASE(
    "surfaces half way between keys of figure 9 keep their area, since matching brings parts to parts") {
    const Family family = read_family(shipped_folder);
    const auto area_half_way = [&](std::size_t one, std::size_t other) {
        return half_way_area(*family.keys[one].hierarchy, *family.keys[other].hierarchy, glm::dmat3(1));
    };
    CHECK(area_half_way(0, 1) > 0.86);  // 0.740 without matching
    CHECK(area_half_way(0, 2) > 0.98);  // 0.761
    CHECK(area_half_way(1, 2) > 0.91);  // 0.905
}

// Under the sanitizers other tests run the same code on smaller meshes.
TEST_CASE("bone and sphere of figure 9 are the output of the commands in make-figure-9, to the last bit" *
          doctest::skip(is_sanitized)) {
    const ScratchFolder folder;
    for (const std::string shape : {"bone", "sphere"}) {
        const std::string made = folder / (shape + "-made.ilh");
        REQUIRE(run_interleaf({"make", shape, "--leaves", "40000", "-o", made}).status == 0);
        REQUIRE(run_interleaf({"export", made, "-o", folder / (shape + ".ply")}).status == 0);
    }
    const std::string bone = folder / "bone.ply";
    const std::string key = folder / "bone.ilh";
    REQUIRE(
        run_interleaf({"fit", bone, "--leaves", "14000", "-o", key, "--compress", "--bits", "16"}).status ==
        0);
    CHECK(content(key) == content(shipped_folder / "bone.ilh"));
    const std::string pair = folder / "pair";
    REQUIRE(run_interleaf({"fit", bone, folder / "sphere.ply", "--leaves", "12000", "-o", pair, "--compress",
                           "--bits", "16"})
                .status == 0);
    CHECK(content(pair + "/sphere.ilh") == content(shipped_folder / "sphere.ilh"));
}

}  // namespace
}  // namespace interleaf
