// What is exported: the blend that writers ask for, and what they can do without one.
#include "io/export/export.h"

#include <limits>
#include <random>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "io/export/vtk_export.h"
#include "io/gltf/glb_export.h"
#include "io/samples.h"

namespace interleaf {

namespace {

std::string usage_error_of(const Export& exported) {
    try {
        blend_of(exported);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

Family family_with_field() {
    std::mt19937 random(3);
    Family family = sample_family(random);
    for (Key& key : family.keys) {
        Hierarchy hierarchy = *key.hierarchy;
        hierarchy.fields = {{"height", FieldKind::scalar, Buffer<float>(hierarchy.positions.size(), 1e30F)}};
        key.hierarchy = std::move(hierarchy);
    }
    return family;
}

}  // namespace

TEST_CASE("a blend is the union with its blended positions and common fields") {
    const Family family = family_with_field();
    const Weights weights{{0, 0.25}, {2, 0.75}};
    const Blend blend = blend_of({family, weights, {}});
    const UnionMesh mesh = unite(family, weights);
    CHECK(std::ranges::equal(blend.mesh.triangles, mesh.triangles));
    CHECK(blend.weights == std::vector<float>{0.25F, 0.75F});
    CHECK(std::ranges::equal(blend.positions, morph(mesh, blend.weights)));
    REQUIRE(blend.fields.size() == 1);
    CHECK(blend.fields[0].name == "height");
    CHECK(blend.fields[0].values.size() == blend.positions.size());
}

TEST_CASE("the blend of a family whose parts turn has turned positions, and is exact at its keys") {
    Family family = family_with_field();
    const Weights weights{{0, 0.25}, {2, 0.75}};
    const Buffer<glm::vec3> straight = blend_of({family, weights, {}}).positions;
    family.blend = BlendKind::turning;
    const Blend blend = blend_of({family, weights, {}});
    CHECK(blend.mesh.turning);
    CHECK(std::ranges::equal(blend.positions, morph(blend.mesh, blend.weights)));
    CHECK_FALSE(std::ranges::equal(blend.positions, straight));

    const Blend at_key = blend_of({family, Weights{{0, 1}, {2, 0}}, {}});
    for (std::size_t v = 0; v < at_key.positions.size(); ++v)
        REQUIRE(glm::distance(at_key.positions[v], at_key.mesh.positions[0][v]) <= 1e-5F);
}

TEST_CASE("eight keys turn over common leaves as they do on their own, and nine are straight with a remark") {
    const Family sample = family_with_field();
    Family family = sample;
    family.keys.clear();
    Weights weights;
    for (std::size_t n = 0; n <= Turning::max_keys; ++n) {
        Hierarchy key = *sample.keys[n % 3].hierarchy;
        for (glm::vec3& position : key.positions) position = {-position.y, position.x, position.z};
        family.keys.push_back(
            {fmt::format("key {}", n), n % 2 == 0 ? sample.keys[n % 3].hierarchy : SharedHierarchy(key)});
        weights.push_back({n, n == 0 ? 0.3 : 0.1});
    }
    family.timeline.reset();
    family.domain.reset();
    family.blend = BlendKind::turning;
    std::vector<std::string> remarks;
    CHECK_FALSE(blend_of({.family = family, .weights = weights, .remarks = &remarks}).mesh.turning);
    REQUIRE(remarks.size() == 1);
    CHECK(remarks[0] == "Parts turn in blends of at most 8 keys; this one has 9 and is straight.");

    weights.pop_back();
    remarks.clear();
    const Blend own = blend_of({.family = family, .weights = weights, .remarks = &remarks});
    CHECK(remarks.empty());
    const Hierarchy finest = finest_of(family, active_keys(weights), no_index);
    BlendSeries series(family, &finest);
    const Blend& common = series.at(weights);
    REQUIRE(own.mesh.turning);
    REQUIRE(common.mesh.turning);
    REQUIRE(common.positions.size() == own.positions.size());
    for (std::size_t v = 0; v < own.positions.size(); ++v)
        REQUIRE(glm::distance(own.positions[v], common.positions[v]) <= 1e-4F);
}

TEST_CASE("a series of blends keeps the union of the same keys, and is each key without rotations") {
    Family family = family_with_field();
    family.blend = BlendKind::turning;
    BlendSeries series(family, nullptr);
    const Blend& blend = series.at({{0, 0}, {2, 1}});
    CHECK_FALSE(blend.mesh.turning);
    CHECK(std::ranges::equal(blend.positions, blend.mesh.positions[1]));
    const auto* const triangles = blend.mesh.triangles.data();
    series.at({{0, 0.5}, {2, 0.5}});
    CHECK(blend.mesh.turning);
    CHECK(blend.mesh.triangles.data() == triangles);
    const Weights next{{0, 0.25}, {1, 0.75}};
    CHECK(std::ranges::equal(series.at(next).positions, blend_of({family, next, {}}).positions));
}

TEST_CASE("formats in which parts do not turn between two keys say so") {
    const ScratchFolder folder;
    std::mt19937 random(3);
    Family family = sample_family(random);
    std::vector<TimelineKey> times;
    for (std::size_t key = 0; key < family.keys.size(); ++key)
        times.push_back({static_cast<double>(key), key});
    family.timeline.emplace(std::move(times));
    const auto remarks_of = [&](ExportWriter write, const char* name, bool segments) {
        std::vector<std::string> remarks;
        write({.family = family, .weights = std::nullopt, .segments = segments, .remarks = &remarks},
              {folder / name});
        std::string text;
        for (const std::string& remark : remarks) text += remark + "\n";
        return text;
    };
    for (const bool is_turning : {false, true}) {
        family.blend = is_turning ? BlendKind::turning : BlendKind::straight;
        CHECK((remarks_of(export_pvd, "a.pvd", false).find("Parts of this family turn") !=
               std::string::npos) == is_turning);
        CHECK((remarks_of(export_glb, "a.glb", true).find("morph targets blend straight") !=
               std::string::npos) == is_turning);
    }
}

TEST_CASE("a blend needs weights, and weights within floats") {
    const Family family = family_with_field();
    CHECK(usage_error_of({family, std::nullopt, {}}) == no_default_blend);
    CHECK(usage_error_of({family, Weights{{0, 1e39}}, {}}) == "--weights: too large for float positions");
    CHECK(usage_error_of({family, Weights{{0, 1e20}}, {}}) ==
          "--weights: too large for float values of field 'height'");
}

TEST_CASE("a writer of the whole family needs no weights") {
    std::mt19937 random(3);
    const Family family = sample_family(random);
    const ExportWriter write = [](const Export& exported, const OutputTarget& target) {
        std::string text;
        for (const TimelineKey& key : exported.family.timeline->keys())
            text += fmt::format("{} {}\n", key.time, exported.family.keys[key.key].hierarchy->leaf_count());
        write_output(target, text);
    };
    const ScratchFolder folder;
    write({family, std::nullopt, {}}, {folder / "whole.txt"});
    const std::string text = content(folder / "whole.txt");
    CHECK(std::ranges::count(text, '\n') == static_cast<long>(family.timeline->keys().size()));
}

TEST_CASE("a target that cannot be written is named") {
    const ScratchFolder folder;
    CHECK(contains(machine_error_of([&] { write_output({folder / "none/a.obj"}, std::string_view("v")); }),
                   "none/a.obj"));
}

}  // namespace interleaf
