#include "io/gltf/glb_export.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "family/family_fields.h"
#include "hierarchy/error.h"
#include "io/family/composition.h"
#include "io/gltf/glb_builder.h"
#include "io/gltf/glb_mesh.h"
#include "io/gltf/gltf_constants.h"
#include "io/gltf/scene_hierarchies.h"
#include "io/gltf/weight_animation.h"

namespace interleaf {

namespace {

using nlohmann::ordered_json;

/// Segments are chosen where the union of all keys has more than this many times their vertices.
constexpr std::size_t max_union_growth = 4;

void remark(const Export& exported, std::string sentence) {
    if (exported.remarks != nullptr) exported.remarks->push_back(std::move(sentence));
}

UnionMesh united(const Family& family, std::span<const std::size_t> keys) {
    Weights weights;
    for (const std::size_t key : keys) weights.push_back({key, 0});
    weights = sorted_weights(std::move(weights));
    UnionMesh mesh = unite(family, weights);
    unite_fields(family, weights, mesh);
    return mesh;
}

/// What all files have in common. The caller adds nodes, meshes and animations.
ordered_json document_of(const Family& family, const UnionMesh& mesh) {
    const bool has_colors = std::ranges::any_of(
        mesh.fields, [](const UnionField& field) { return field.label.kind == FieldKind::color; });
    const double gray = has_colors ? 1 : 0.8;
    ordered_json material = {
        {"name", "surface"},
        {"pbrMetallicRoughness",
         {{"baseColorFactor", {gray, gray, gray, 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.6}}}};
    if (mesh.roots.boundary_edge_count() > 0) material["doubleSided"] = true;
    return {{"asset", {{"version", "2.0"}, {"generator", gltf::generator}}},
            {"scene", 0},
            {"scenes", ordered_json::array({{{"name", family.name}}})},
            {"materials", ordered_json::array({std::move(material)})}};
}

/// What glTF has no place for: how the keys are blended, and the names of fields.
ordered_json extras_of(const Family& family, const UnionMesh& mesh, std::size_t base) {
    ordered_json own = ordered_json::parse(composition_text(family));
    own["base"] = family.keys[base].name;
    ordered_json fields = ordered_json::array();
    const std::vector<std::string> names = attribute_names(mesh.fields);
    for (std::size_t i = 0; i < names.size(); ++i)
        fields.push_back({{"attribute", names[i]}, {"name", mesh.fields[i].label.name}});
    if (!fields.empty()) own["fields"] = std::move(fields);
    return own;
}

ordered_json channel_of(std::size_t sampler, std::size_t node, std::string_view path) {
    return {{"sampler", sampler}, {"target", {{"node", node}, {"path", path}}}};
}

ordered_json animation_of(GlbBuilder& builder, const WeightAnimation& weights) {
    ordered_json sampler;
    sampler["input"] = builder.add_animation(weights.times, GlbBounds::with);
    sampler["interpolation"] = weights.is_stepped ? "STEP" : "LINEAR";
    sampler["output"] = builder.add_animation(weights.weights, GlbBounds::without);
    return {{"name", weights.name},
            {"samplers", ordered_json::array({std::move(sampler)})},
            {"channels", ordered_json::array({channel_of(0, 0, "weights")})}};
}

void remark_on(const Export& exported, const WeightAnimation& animation) {
    constexpr double slack = 1e-6;
    if (animation.delay > 0)
        remark(exported,
               fmt::format("glTF has no times below 0: the animation begins at 0, {:.6g} seconds later",
                           animation.delay));
    if (animation.least < -slack || animation.most > 1 + slack)
        remark(
            exported,
            fmt::format("the animation has weights from {:.3g} to {:.3g}; Blender limits weights to 0 to 1",
                        animation.least, animation.most));
}

/// The key that the targets are relative to.
std::size_t base_key(const Family& family) {
    return family.timeline ? family.timeline->keys().front().key : 0;
}

/// The pairs of keys that follow each other in the timeline, or share an edge of the domain.
std::vector<KeyPair> blended_pairs(const Family& family) {
    std::set<KeyPair> pairs;
    const auto add = [&pairs](std::size_t a, std::size_t b) {
        if (a != b) pairs.insert({std::min(a, b), std::max(a, b)});
    };
    if (family.timeline) {
        const auto keys = family.timeline->keys();
        for (std::size_t i = 0; i + 1 < keys.size(); ++i) add(keys[i].key, keys[i + 1].key);
    }
    if (family.domain)
        for (const auto& [a, b, c] : family.domain->triangles()) {
            const auto vertices = family.domain->vertices();
            add(vertices[a].key, vertices[b].key);
            add(vertices[b].key, vertices[c].key);
            add(vertices[c].key, vertices[a].key);
        }
    return {pairs.begin(), pairs.end()};
}

/// One mesh with all keys.
void write_whole(const Export& exported, const UnionMesh& mesh, const OutputTarget& target) {
    const Family& family = exported.family;
    require_primitive_size(mesh);
    const std::size_t base = base_key(family);
    std::vector<std::size_t> targets(family.keys.size());
    std::iota(targets.begin(), targets.end(), std::size_t{0});
    std::erase(targets, base);

    const Progress normals = part_of(exported.progress, 0.3, 0.9);
    GlbBuilder builder;
    ordered_json gltf_mesh = {{"name", family.name}};
    gltf_mesh["primitives"] =
        ordered_json::array({add_primitive(builder, mesh, base, blended_pairs(family), normals)});
    ordered_json extras;
    if (!targets.empty()) {
        gltf_mesh["weights"] = target_weights(exported.weights.value_or(Weights{{base, 1}}), targets);
        for (const std::size_t key : targets) extras["targetNames"].push_back(family.keys[key].name);
    }
    extras[gltf::extras_member] = extras_of(family, mesh, base);
    gltf_mesh["extras"] = std::move(extras);

    ordered_json document = document_of(family, mesh);
    document["scenes"][0]["nodes"] = {0};
    document["nodes"] = ordered_json::array({{{"name", family.name}, {"mesh", 0}}});
    document["meshes"] = ordered_json::array({std::move(gltf_mesh)});
    if (const auto animation = weight_animation(family, targets); animation && !targets.empty()) {
        document["animations"] = ordered_json::array({animation_of(builder, *animation)});
        remark_on(exported, *animation);
    }
    report_progress(exported, "writing", 0.9);
    write_output(target, builder.file(std::move(document)));
}

bool has_segments(const Family& family) {
    return family.timeline && family.timeline->keys().size() > 1 &&
           family.timeline->interpolation().basis == Basis::linear;
}

/// The largest number of vertices of the union of an interval's two keys.
std::size_t largest_segment(const Export& exported) {
    std::size_t most = 0;
    const Family& family = exported.family;
    const auto keys = family.timeline->keys();
    UnionMesh mesh;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        report_progress(exported, "uniting keys", 0.2);
        unite(family, sorted_weights({{keys[i].key, 0}, {keys[i + 1].key, 0}}), mesh);
        most = std::max(most, mesh.vertex_count());
    }
    return most;
}

/// Collects the segments of a timeline: meshes, nodes, and the two channels of each.
struct Segments {
    GlbBuilder builder;
    ordered_json meshes = ordered_json::array();
    ordered_json nodes = ordered_json::array();
    ordered_json samplers = ordered_json::array();
    ordered_json channels = ordered_json::array();

    void add_channel(std::size_t node, std::string_view path, std::string_view interpolation,
                     std::size_t input, std::size_t output) {
        channels.push_back(channel_of(samplers.size(), node, path));
        samplers.push_back({{"input", input}, {"interpolation", interpolation}, {"output", output}});
    }
};

/// Shows node \p segment of \p count from its time to the next one, by its scale; the last one also at the
/// end.
void add_visibility(Segments& segments, std::size_t segment, std::size_t count, std::size_t times) {
    std::vector<glm::vec3> scales(count + 1, glm::vec3(0));
    scales[segment] = glm::vec3(1);
    if (segment + 1 == count) scales[count] = glm::vec3(1);
    segments.add_channel(segment, "scale", "STEP", times, segments.builder.add_animation(scales));
}

/// Adds the union of the keys \p first and \p second: the first is the base, the second the target.
void add_segment(Segments& segments, const Family& family, const UnionMesh& mesh, std::size_t first,
                 std::size_t second) {
    const std::string& from = family.keys[first].name;
    const std::string& to = family.keys[second].name;
    const std::size_t base = first < second || mesh.key_count() == 1 ? 0 : 1;
    ordered_json gltf_mesh = {{"name", fmt::format("{} to {}", from, to)}};
    const std::vector<KeyPair> pairs(mesh.key_count() - 1, {0, 1});
    gltf_mesh["primitives"] = ordered_json::array({add_primitive(segments.builder, mesh, base, pairs)});
    if (mesh.key_count() > 1) {
        gltf_mesh["weights"] = {0.0};
        gltf_mesh["extras"]["targetNames"] = {to};
    }
    const double scale = segments.nodes.empty() ? 1 : 0;
    segments.nodes.push_back(
        {{"name", gltf_mesh["name"]}, {"mesh", segments.meshes.size()}, {"scale", {scale, scale, scale}}});
    segments.meshes.push_back(std::move(gltf_mesh));
}

/// A mesh per interval of the timeline.
/// \pre has_segments()
void write_segments(const Export& exported, const OutputTarget& target) {
    const Family& family = exported.family;
    const auto keys = family.timeline->keys();
    const double delay = std::max(0.0, -keys.front().time);
    std::vector<float> times;
    times.reserve(keys.size());
    for (const TimelineKey& key : keys) {
        times.push_back(static_cast<float>(key.time + delay));
        if (times.size() > 1 && !(times.back() > times[times.size() - 2]))
            throw InputError("two times of the timeline are the same as 32-bit floats, which glTF uses");
    }

    Segments segments;
    const std::size_t all_times = segments.builder.add_animation(times, GlbBounds::with);
    const std::size_t rise = segments.builder.add_animation(std::vector<float>{0, 1}, GlbBounds::without);
    ordered_json document;
    std::uint64_t size = 0;
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        report_progress(exported, fmt::format("segment {} of {}", i + 1, keys.size() - 1),
                        0.9 * static_cast<double>(i) / static_cast<double>(keys.size() - 1));
        const UnionMesh mesh = united(family, std::vector{keys[i].key, keys[i + 1].key});
        size += primitive_size(mesh);
        if (size > max_glb_size)
            throw InputError(
                fmt::format("the first {} of {} segments would take {} bytes as .glb, expected at "
                            "most {} for all",
                            i + 1, keys.size() - 1, size, max_glb_size));
        if (i == 0) document = document_of(family, mesh);
        add_segment(segments, family, mesh, keys[i].key, keys[i + 1].key);
        add_visibility(segments, i, keys.size() - 1, all_times);
        if (mesh.key_count() < 2) continue;
        const std::size_t interval =
            segments.builder.add_animation(std::span(times).subspan(i, 2), GlbBounds::with);
        segments.add_channel(i, "weights", "LINEAR", interval, rise);
    }
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) document["scenes"][0]["nodes"].push_back(i);
    document["scenes"][0]["extras"][gltf::extras_member] = scene_extras(family);
    document["nodes"] = std::move(segments.nodes);
    document["meshes"] = std::move(segments.meshes);
    document["animations"] = ordered_json::array({{{"name", "timeline"},
                                                   {"samplers", std::move(segments.samplers)},
                                                   {"channels", std::move(segments.channels)}}});
    report_progress(exported, "writing", 0.9);
    write_output(target, segments.builder.file(std::move(document)));
}

}  // namespace

void export_glb(const Export& exported, const OutputTarget& target) {
    const Family& family = exported.family;
    if (exported.segments && !has_segments(family))
        throw UsageError("--segments: expected a family with a linear timeline of at least two keys");
    if (family.blend != BlendKind::straight)
        remark(exported, "morph targets blend straight; parts of this family turn");
    if (exported.segments) return write_segments(exported, target);

    std::vector<std::size_t> all(family.keys.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    report_progress(exported, "uniting keys", 0);
    const UnionMesh mesh = united(family, all);
    if (has_segments(family) && !family.domain && family.keys.size() > 2) {
        const std::size_t most = largest_segment(exported);
        if (mesh.vertex_count() > max_union_growth * most) {
            remark(exported,
                   fmt::format("the union of all keys has {} vertices, over four times the {} of an "
                               "interval; written as one mesh per interval, as by --segments",
                               mesh.vertex_count(), most));
            return write_segments(exported, target);
        }
    }
    write_whole(exported, mesh, target);
}

}  // namespace interleaf
