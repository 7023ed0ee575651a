// Families as .glb: the union of all keys, its targets, and the timeline as an animation.
#include "io/gltf/glb_export.h"

#include <algorithm>
#include <random>

#include "messages.h"
#include "scratch_folder.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "family/family_fields.h"
#include "family/new_family.h"
#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "io/gltf/glb_builder.h"
#include "io/gltf/glb_mesh.h"
#include "io/gltf/glb_parts.h"
#include "io/samples.h"

namespace interleaf {

namespace {

std::string exported_bytes(const Export& exported) {
    const ScratchFolder folder;
    export_glb(exported, {folder / "a.glb"});
    return content(folder / "a.glb");
}

/// Three keys with a color and a scalar, a timeline that begins at key 2, and a domain.
Family family_with_fields() {
    std::mt19937 random(11);
    Family family = sample_family(random);
    for (Key& key : family.keys) {
        Hierarchy hierarchy = *key.hierarchy;
        const std::size_t count = hierarchy.vertex_count();
        hierarchy.fields = {{"height", FieldKind::scalar, Buffer<float>(count, 2)},
                            {"Height", FieldKind::scalar, Buffer<float>(count, 3)},
                            {"tint", FieldKind::color, Buffer<float>(3 * count, 0.25F)},
                            {"color", FieldKind::color, Buffer<float>(3 * count, 0.5F)}};
        key.hierarchy = std::move(hierarchy);
    }
    family.timeline = Timeline({{1.5, 2}, {2, 0}, {4, 1}, {5, 2}});
    return family;
}

UnionMesh union_of_all(const Family& family) {
    Weights weights;
    for (std::size_t key = 0; key < family.keys.size(); ++key) weights.push_back({key, 0});
    return unite(family, weights);
}

}  // namespace

TEST_CASE("the lengths in a .glb add up, and every array is aligned and has its own view") {
    const std::string bytes = exported_bytes({family_with_fields(), std::nullopt, {}});
    CHECK(bytes.substr(0, 4) == "glTF");
    CHECK(word_at(bytes, 4) == 2);
    CHECK(word_at(bytes, 8) == bytes.size());
    const std::size_t text_size = word_at(bytes, 12);
    CHECK(text_size % 4 == 0);
    CHECK(word_at(bytes, 20 + text_size) == bytes.size() - 28 - text_size);
    const GlbParts parts = glb_parts(bytes);
    const auto& views = parts.document["bufferViews"];
    CHECK(views.size() == parts.document["accessors"].size());
    std::size_t end = 0;
    for (const auto& view : views) {
        CHECK(view["byteOffset"].get<std::size_t>() % 4 == 0);
        CHECK(view["byteOffset"].get<std::size_t>() == (end + 3) / 4 * 4);
        end = view["byteOffset"].get<std::size_t>() + view["byteLength"].get<std::size_t>();
    }
    CHECK(parts.document["buffers"][0]["byteLength"] == (end + 3) / 4 * 4);
}

TEST_CASE("base and targets are the keys over the union of all keys, with their bounds") {
    const Family family = family_with_fields();
    const std::string bytes = exported_bytes({family, std::nullopt, {}});
    const GlbParts parts = glb_parts(bytes);
    const auto& mesh = parts.document["meshes"][0];
    const auto& primitive = mesh["primitives"][0];
    CHECK(mesh["extras"]["interleaf"]["base"] == family.keys[2].name);
    CHECK(mesh["extras"]["targetNames"] == nlohmann::json{family.keys[0].name, family.keys[1].name});
    const UnionMesh whole = union_of_all(family);
    const auto base = values_of<glm::vec3>(parts, primitive["attributes"]["POSITION"]);
    CHECK(std::ranges::equal(base, whole.positions[2]));
    for (std::size_t key = 0; key < 2; ++key) {
        const auto& accessor = primitive["targets"][key]["POSITION"];
        const auto deltas = values_of<glm::vec3>(parts, accessor);
        REQUIRE(deltas.size() == base.size());
        glm::vec3 least = deltas.front();
        float farthest = 0;
        for (std::size_t v = 0; v < base.size(); ++v) {
            farthest = std::max(farthest, glm::distance(base[v] + deltas[v], whole.positions[key][v]));
            least.x = std::min(least.x, deltas[v].x);
        }
        CHECK(farthest < 1e-6);
        const auto& described = parts.document["accessors"][accessor.get<std::size_t>()];
        CHECK(described["min"][0].get<float>() == least.x);
        CHECK(described["max"].size() == 3);
    }
    const auto indices = values_of<std::uint16_t>(parts, primitive["indices"]);
    REQUIRE(indices.size() == 3 * whole.leaf_count());
    CHECK(std::ranges::equal(indices, std::span(whole.triangles[0].data(), indices.size())));
    CHECK(parts.document["materials"][0]["pbrMetallicRoughness"]["metallicFactor"] == 0.0);
}

TEST_CASE("colors are linear light, scalars are attributes with unique names") {
    const std::string bytes = exported_bytes({family_with_fields(), std::nullopt, {}});
    const GlbParts parts = glb_parts(bytes);
    const auto& attributes = parts.document["meshes"][0]["primitives"][0]["attributes"];
    CHECK(values_of<float>(parts, attributes["COLOR_0"])[0] == doctest::Approx(0.214041).epsilon(1e-5));
    CHECK(values_of<float>(parts, attributes["COLOR_1"])[0] == doctest::Approx(0.050876).epsilon(1e-4));
    CHECK(values_of<float>(parts, attributes["_HEIGHT"])[0] == 2);
    CHECK(values_of<float>(parts, attributes["_HEIGHT_2"])[0] == 3);
    const auto& fields = parts.document["meshes"][0]["extras"]["interleaf"]["fields"];
    CHECK(fields[1] == nlohmann::json{{"attribute", "_HEIGHT_2"}, {"name", "Height"}});
}

TEST_CASE("the animation has the weights of the timeline's keys at their times") {
    const Family family = family_with_fields();
    const std::string bytes = exported_bytes({family, Weights{{1, 0.75}, {2, 0.25}}, {}});
    const GlbParts parts = glb_parts(bytes);
    CHECK(parts.document["meshes"][0]["weights"] == nlohmann::json{0.0, 0.75});
    const auto& animation = parts.document["animations"][0];
    CHECK(animation["name"] == "timeline");
    const auto& sampler = animation["samplers"][0];
    CHECK(sampler["interpolation"] == "LINEAR");
    CHECK(values_of<float>(parts, sampler["input"]) == std::vector<float>{1.5F, 2, 4, 5});
    CHECK(values_of<float>(parts, sampler["output"]) == std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0});
}

TEST_CASE("a family of one key has no targets and no animation") {
    std::mt19937 random(5);
    std::vector<Key> keys;
    keys.push_back({"only", random_hierarchy(random, true, 8)});
    const std::string bytes = exported_bytes({family_of_keys("one", std::move(keys)), std::nullopt, {}});
    const GlbParts parts = glb_parts(bytes);
    CHECK_FALSE(parts.document["meshes"][0]["primitives"][0].contains("targets"));
    CHECK_FALSE(parts.document["meshes"][0].contains("weights"));
    CHECK_FALSE(parts.document.contains("animations"));
    CHECK(parts.document["materials"][0]["doubleSided"] == true);
}

TEST_CASE("segments are the unions of neighboring keys, each shown in its interval") {
    const Family family = family_with_fields();
    const std::string bytes =
        exported_bytes({.family = family, .weights = std::nullopt, .form = {}, .segments = true});
    const GlbParts parts = glb_parts(bytes);
    REQUIRE(parts.document["nodes"].size() == 3);
    CHECK(parts.document["scenes"][0]["nodes"] == nlohmann::json{0, 1, 2});
    const auto& first = parts.document["meshes"][0];
    CHECK(first["extras"]["targetNames"] == nlohmann::json{family.keys[0].name});
    const UnionMesh pair = unite(family, {{0, 0}, {2, 0}});
    CHECK(std::ranges::equal(values_of<glm::vec3>(parts, first["primitives"][0]["attributes"]["POSITION"]),
                             pair.positions[1]));
    const auto& animation = parts.document["animations"][0];
    for (const auto& channel : animation["channels"]) {
        const auto& sampler = animation["samplers"][channel["sampler"].get<std::size_t>()];
        if (channel["target"]["path"] != "scale" || channel["target"]["node"] != 2) continue;
        CHECK(sampler["interpolation"] == "STEP");
        const auto scales = values_of<glm::vec3>(parts, sampler["output"]);
        CHECK(scales == std::vector{glm::vec3(0), glm::vec3(0), glm::vec3(1), glm::vec3(1)});
    }
}

TEST_CASE("a file of more than 4 GiB is refused by the size that its arrays would have") {
    Family family = family_with_fields();
    family.timeline.reset();
    UnionMesh mesh = union_of_all(family);
    unite_fields(family, {{0, 0}, {1, 0}, {2, 0}}, mesh);
    const GlbParts parts = glb_parts(exported_bytes({family, std::nullopt, {}}));
    std::uint64_t size = 0;
    for (const auto& view : parts.document["bufferViews"]) size += view["byteLength"].get<std::uint64_t>();
    CHECK(primitive_size(mesh) == size);
    CHECK(max_glb_size == (std::uint64_t{1} << 32) - 1);
    CHECK_NOTHROW(require_primitive_size(mesh, size));
    const std::string error = text_of_thrown<InputError>([&] { require_primitive_size(mesh, size - 1); });
    CHECK(contains(error, "bytes, expected at most"));
    CHECK(contains(error, "--segments takes less"));
}

TEST_CASE("the same family makes the same bytes") {
    const Family family = family_with_fields();
    for (const bool segments : {false, true}) {
        const Export exported{.family = family, .weights = std::nullopt, .form = {}, .segments = segments};
        CHECK(exported_bytes(exported) == exported_bytes(exported));
    }
}

TEST_CASE("segments need a linear timeline") {
    Family family = family_with_fields();
    family.timeline = family.timeline->with_interpolation({Basis::spline});
    const auto write = [&] {
        export_glb({.family = family, .weights = std::nullopt, .form = {}, .segments = true}, {});
    };
    CHECK(
        contains(text_of_thrown<UsageError>(write), "--segments: expected a family with a linear timeline"));
}

}  // namespace interleaf
