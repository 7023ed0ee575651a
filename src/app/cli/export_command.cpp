#include "app/cli/export_command.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>

#include "app/cli/error_message.h"
#include "app/document/open_family.h"
#include "family/family_fields.h"
#include "family/origin.h"
#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "io/mesh/mesh_file.h"

namespace interleaf {
namespace {

constexpr std::array<std::string_view, 3> export_formats = {"obj", "ply", "ilh"};

bool is_finite(const glm::vec3& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z);
}

/// \throw UsageError where weights lead out of floats
std::vector<Field> morphed_fields(const UnionMesh& mesh, std::span<const float> weights) {
    std::vector<Field> fields;
    for (const UnionField& field : mesh.fields) {
        fields.push_back(morphed_field(field, weights));
        if (!std::ranges::all_of(fields.back().values, [](float value) { return std::isfinite(value); }))
            throw UsageError(
                fmt::format("--weights: too large for float values of field '{}'", field.label.name));
    }
    return fields;
}

}  // namespace

void run_export(const ExportOptions& options) {
    const std::string_view format = format_of(options.output, export_formats);
    if (options.form.compressed && format != "ilh")
        throw UsageError(fmt::format("--compress: expected the format ilh, got '{}'", format));
    const Family family = open_family(options.morph.family);
    const Weights weights = selected_weights(options.morph, family);
    UnionMesh mesh = unite(family, weights);
    unite_fields(family, weights, mesh);
    const std::vector<float> values = weight_values(weights);
    const Buffer<glm::vec3> positions = morph(mesh, values);
    if (!std::ranges::all_of(positions, is_finite))
        throw UsageError("--weights: too large for float positions");
    const std::vector<Field> fields = morphed_fields(mesh, values);

    if (format == "obj") {
        write_output(options.output, obj_text(mesh.triangles, positions, fields, family.origin));
    } else if (format == "ply") {
        write_output(options.output, ply_bytes(mesh.triangles, positions, fields, family.origin));
    } else {
        write_output(options.output, serialize_hierarchy(morphed_hierarchy(mesh, values), options.form));
        // A key has no place for it.
        if (family.origin != glm::dvec3(0))
            print_error(fmt::format("{}: {}", options.output.target, origin_sentence(family.origin)));
    }
}

}  // namespace interleaf
