#include "io/export/export.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>

#include "family/family_fields.h"
#include "hierarchy/error.h"
#include "hierarchy/morph.h"

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

Blend blend_of(const Export& exported) {
    if (!exported.weights) throw UsageError(no_default_blend);
    Blend blend;
    blend.mesh = unite(exported.family, *exported.weights);
    unite_fields(exported.family, *exported.weights, blend.mesh);
    blend.weights = weight_values(*exported.weights);
    blend.positions = morph(blend.mesh, blend.weights);
    if (!std::ranges::all_of(blend.positions, is_finite))
        throw UsageError("--weights: too large for float positions");
    blend.fields = morphed_fields(blend.mesh, blend.weights);
    return blend;
}

}  // namespace interleaf
