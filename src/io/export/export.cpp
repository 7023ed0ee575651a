#include "io/export/export.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "hierarchy/union_fields.h"

namespace interleaf {
namespace {

bool is_finite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

std::vector<Field> morphed_fields(const UnionMesh& mesh, std::span<const float> weights) {
    std::vector<Field> fields;
    fields.reserve(mesh.fields.size());
    for (const UnionField& field : mesh.fields) {
        fields.push_back(morphed_field(field, weights));
        if (!std::ranges::all_of(fields.back().values, [](float value) { return std::isfinite(value); }))
            throw UsageError(
                fmt::format("--weights: too large for float values of field '{}'", field.label.name));
    }
    return fields;
}

}  // namespace

void report_progress(const Export& exported, std::string_view stage, double part) {
    if (exported.progress && !exported.progress(stage, part)) throw Cancelled();
}

Blend blend_of(const Export& exported) {
    if (!exported.weights) throw UsageError(no_default_blend);
    return blend_over(exported.family, *exported.weights, nullptr);
}

Blend blend_over(const Family& family, const Weights& weights, const Hierarchy* finest) {
    std::vector<const Hierarchy*> keys;
    Blend blend;
    if (finest != nullptr) {
        keys.push_back(finest);
        blend.weights.push_back(0);
    }
    for (const std::size_t key : active_keys(weights)) keys.push_back(&*family.keys[key].hierarchy);
    for (const float weight : weight_values(weights)) blend.weights.push_back(weight);
    blend.mesh = unite(keys);
    unite_fields(keys, blend.mesh);
    set_blend(blend.mesh, family.blend);
    blend.positions = morph(blend.mesh, blend.weights);
    if (!std::ranges::all_of(blend.positions, is_finite))
        throw UsageError("--weights: too large for float positions");
    blend.fields = morphed_fields(blend.mesh, blend.weights);
    return blend;
}

Hierarchy finest_of(const Family& family, std::span<const std::size_t> keys, std::size_t max_leaves) {
    Hierarchy finest = *family.keys[keys.front()].hierarchy;
    for (const std::size_t key : keys.subspan(1)) {
        const std::array<const Hierarchy*, 2> pair = {&finest, &*family.keys[key].hierarchy};
        UnionMesh mesh = unite(pair);
        unite_fields(pair, mesh);
        finest = morphed_hierarchy(mesh, std::array{1.0F, 0.0F});
        if (finest.leaf_count() > max_leaves) break;
    }
    return finest;
}

}  // namespace interleaf
