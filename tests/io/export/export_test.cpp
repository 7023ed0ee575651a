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
