#include "io/formats.h"

#include <algorithm>
#include <array>

#include "family/origin.h"
#include "io/export/blend_export.h"
#include "io/export/vtk_export.h"
#include "io/family/family_file.h"
#include "io/file/file_pattern.h"
#include "io/gltf/glb_export.h"
#include "io/gltf/gltf_reader.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/mesh/obj_keys.h"
#include "io/page/page_export.h"
#include "io/text/joined_text.h"

namespace interleaf {
namespace {

/// Reads hierarchy files. They store no origin: their positions are relative to any origin.
std::variant<FileKeys, Misfit> read_hierarchies(std::span<const std::filesystem::path> files,
                                                std::optional<glm::dvec3> /*origin*/) {
    FileKeys read;
    for (const std::filesystem::path& file : files) read.keys.push_back(read_hierarchy(file));
    return read;
}

constexpr auto table = std::to_array<Format>({
    {.extension = ".json",
     .title = "family file",
     .read = Carried{.fields = true, .colors = true, .hierarchy = true, .origin = true, .time = true},
     .written = Carried{.fields = true, .colors = true, .hierarchy = true, .origin = true, .time = true},
     .read_family = read_family},
    {.extension = ".ilh",
     .title = "hierarchy file",
     .read = Carried{.fields = true, .colors = true, .hierarchy = true},
     .written = Carried{.fields = true, .colors = true, .hierarchy = true},
     .read_keys = read_hierarchies,
     .write = export_key},
    {.extension = ".obj",
     .title = "Wavefront OBJ",
     .read = Carried{.colors = true, .origin = true},
     .written = Carried{.colors = true, .origin = true},
     .read_keys = read_obj_keys,
     .parse_surface = parse_obj,
     .write = export_obj},
    {.extension = ".ply",
     .title = "PLY",
     .read = Carried{.fields = true, .colors = true, .origin = true},
     .written = Carried{.fields = true, .colors = true, .origin = true},
     .parse_surface = parse_ply,
     .write = export_ply},
    {.extension = ".stl", .title = "STL", .read = Carried{.origin = true}, .parse_surface = parse_stl},
    {.extension = ".off",
     .title = "OFF",
     .read = Carried{.colors = true, .origin = true},
     .parse_surface = parse_off},
    {.extension = ".glb",
     .title = "binary glTF 2.0",
     .read = Carried{.fields = true, .colors = true, .origin = true, .time = true},
     .written = Carried{.fields = true, .colors = true, .origin = true, .time = true},
     .read_family = read_gltf_family,
     .read_keys = read_gltf_keys,
     .parse_surface = parse_gltf,
     .write = export_glb},
    {.extension = ".gltf",
     .title = "glTF 2.0",
     .read = Carried{.fields = true, .colors = true, .origin = true, .time = true},
     .read_family = read_gltf_family,
     .read_keys = read_gltf_keys,
     .parse_surface = parse_gltf},
    {.extension = ".html",
     .title = "web page",
     .written = Carried{.fields = true, .colors = true, .time = true},
     .write = export_page},
    {.extension = ".vtp",
     .title = "VTK polygons",
     .read = Carried{.fields = true, .origin = true},
     .written = Carried{.fields = true, .colors = true, .origin = true},
     .is_step = true,
     .write = export_vtp},
    {.extension = ".vtu",
     .title = "VTK unstructured grid",
     .read = Carried{.fields = true, .origin = true},
     .written = Carried{.fields = true, .colors = true, .origin = true},
     .is_step = true,
     .write = export_vtu},
    {.extension = ".pvtp",
     .title = "VTK polygons in pieces",
     .read = Carried{.fields = true, .origin = true},
     .is_step = true},
    {.extension = ".pvtu",
     .title = "VTK unstructured grid in pieces",
     .read = Carried{.fields = true, .origin = true},
     .is_step = true},
    {.extension = ".vtk",
     .title = "legacy VTK",
     .read = Carried{.fields = true, .origin = true},
     .is_step = true},
    {.extension = ".pvd",
     .title = "ParaView collection",
     .read = Carried{.fields = true, .origin = true, .time = true},
     .written = Carried{.fields = true, .colors = true, .origin = true, .time = true},
     .is_step = true,
     .write = export_pvd},
    {.extension = ".series",
     .title = "ParaView file series",
     .read = Carried{.fields = true, .origin = true, .time = true},
     .is_step = true},
});

}  // namespace

std::span<const Format> formats() {
    return table;
}

const Format* find_format(const std::filesystem::path& file) {
    return format_with_extension(lower_case_extension(file));
}

const Format* format_with_extension(std::string_view extension) {
    const auto found = std::ranges::find(table, extension, &Format::extension);
    return found == table.end() ? nullptr : &*found;
}

std::vector<std::string> lost_offsets(const Format& format, const Family& family) {
    std::vector<std::string> sentences;
    if (!format.written->origin && family.origin != glm::dvec3(0))
        sentences.push_back(origin_sentence(family.origin));
    if (!format.is_exported_key())
        return sentences;  // fields of the others have their offsets, or are missing
    for (const FieldScale& scale : family.field_scales)
        if (scale.offset != 0) sentences.push_back(offset_sentence(scale));
    return sentences;
}

bool is_called(const std::filesystem::path& file, FormatTrait trait) {
    const Format* const format = find_format(file);
    return format != nullptr && (format->*trait)();
}

std::vector<std::string> extensions_of(FormatTrait trait) {
    std::vector<std::string> extensions;
    for (const Format& format : formats())
        if ((format.*trait)()) extensions.emplace_back(format.extension);
    return extensions;
}

std::string extensions_in_words(FormatTrait trait) {
    return either_of(extensions_of(trait));
}

}  // namespace interleaf
