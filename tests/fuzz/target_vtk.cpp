// VTK files, legacy and XML. Every file is read as both, and counts as rejected if both readers reject it. The
// parts are the XML and the data appended to it; the whole of any other file.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "fuzz/hierarchy_parts.h"
#include "fuzz/target.h"

#include "hierarchy/error.h"
#include "io/vtk/legacy_file.h"
#include "io/vtk/xml_file.h"

namespace interleaf::fuzz {

namespace {

std::string_view vtk_text(ByteSpan bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string inspected(const FieldMesh& mesh) {
    const auto is_finite = [](double number) { return std::isfinite(number); };
    const auto exists = [&](const std::array<Index, 3>& triangle) {
        return std::ranges::all_of(triangle, [&](Index i) { return i < mesh.points.size(); });
    };
    if (!std::ranges::all_of(mesh.triangles, exists)) return "unsound: a point does not exist";
    if (mesh.cell_of.size() != mesh.triangles.size()) return "unsound: number of cells";
    if (!std::ranges::is_sorted(mesh.cell_of)) return "unsound: order of cells";
    for (const glm::dvec3& point : mesh.points)
        if (!is_finite(point.x) || !is_finite(point.y) || !is_finite(point.z)) return "unsound: a point";
    // Values may be any doubles: the recovery of keys refuses those that are not finite, if their field is wanted.
    for (const auto& [fields, count] : {std::pair{&mesh.point_fields, mesh.points.size()},
                                        std::pair{&mesh.triangle_fields, mesh.triangles.size()}})
        for (const MeshField& field : *fields) {
            if (field.values.size() != field.components * count) return "unsound: number of values";
        }
    return {};
}

Inspection read(ByteSpan bytes) {
    std::optional<FieldMesh> mesh;
    try {
        mesh = parse_legacy_vtk(vtk_text(bytes), "mesh");
    } catch (const InputError&) {
        mesh = parse_vtk_xml(std::string(vtk_text(bytes)), "mesh");
    }
    return [mesh = std::move(*mesh)] { return inspected(mesh); };
}

std::vector<Bytes> parts_of(ByteSpan file) {
    constexpr std::string_view appended = "<AppendedData";
    std::vector<Bytes> parts;
    ByteSpan rest = file;
    if (const std::size_t begin = vtk_text(file).find(appended); begin != std::string_view::npos)
        parts.push_back(take(rest, begin));
    parts.push_back(take(rest, rest.size()));
    return parts;
}

Bytes joined_parts(std::vector<Bytes> parts, bool /*keeps_counts*/) {
    Bytes file;
    for (const Bytes& part : parts) file.insert(file.end(), part.begin(), part.end());
    return file;
}

/// Compressed data stands for at most 64 times its size.
std::uint64_t content_size(ByteSpan file) {
    const bool is_compressed = vtk_text(file).find("compressor") != std::string_view::npos;
    return is_compressed ? 64 * std::uint64_t{file.size()} + (1U << 24U) : file.size();
}

}  // namespace

const Target target{"vtk", read, parts_of, joined_parts, content_size};

}  // namespace interleaf::fuzz
