#include "io/export/export.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

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
    remark_on_straight(exported, exported.weights->size());
    return std::move(BlendSeries(exported.family, nullptr).at(*exported.weights));
}

void remark_on_straight(const Export& exported, std::size_t key_count) {
    std::optional<std::string> sentence = remark_on_straight(exported.family.blend, key_count);
    if (sentence && exported.remarks != nullptr) exported.remarks->push_back(std::move(*sentence));
}

Blend& BlendSeries::at(const Weights& weights) {
    const std::size_t first = finest_ != nullptr ? 1 : 0;  // key that blends
    if (std::vector<std::size_t> active = active_keys(weights); active != active_) {
        std::vector<const Hierarchy*> keys(first, finest_);
        for (const std::size_t key : active) keys.push_back(&*family_.keys[key].hierarchy);
        unite(keys, blend_.mesh);
        unite_fields(keys, blend_.mesh);
        active_ = std::move(active);
    }
    blend_.weights.assign(first, 0);
    for (const float weight : weight_values(weights)) blend_.weights.push_back(weight);
    // One key alone is itself, so that a series of keys needs no rotations.
    if (std::ranges::count(blend_.weights, 0.0F) + 1 >= std::ssize(blend_.weights)) {
        weighted_sum(blend_.mesh.positions, blend_.weights, blend_.positions);
    } else {
        if (!blend_.mesh.turning) set_blend(blend_.mesh, family_.blend, first);
        morph(blend_.mesh, blend_.weights, blend_.positions);
    }
    if (!std::ranges::all_of(blend_.positions, is_finite))
        throw UsageError("--weights: too large for float positions");
    blend_.fields = morphed_fields(blend_.mesh, blend_.weights);
    return blend_;
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
