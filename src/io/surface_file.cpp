#include "io/surface_file.h"

#include <cstdint>
#include <string>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/family_file.h"
#include "io/input_file.h"
#include "io/obj_lines.h"

namespace interleaf {
namespace {

constexpr std::uint64_t largest_surface = std::uint64_t{1} << 30;

SurfaceFile parse_obj(std::string_view text, std::string_view name) {
    const ObjLines lines = read_obj_lines(text, name);
    return {{lines.positions.begin(), lines.positions.end()}, triangles_of(lines, name), lines.colors};
}

}  // namespace

void append_fan(std::vector<Triangle>& triangles, std::span<const Index> corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.push_back({corners[0], corners[i - 1], corners[i]});
}

SurfaceFile read_surface(const std::filesystem::path& file) {
    const std::string extension = lower_case_extension(file);
    SurfaceFile (*parse)(std::string_view, std::string_view) = nullptr;
    if (extension == ".obj") parse = parse_obj;
    if (extension == ".off") parse = parse_off;
    if (extension == ".ply") parse = parse_ply;
    if (extension == ".stl") parse = parse_stl;
    if (parse == nullptr)
        throw InputError(fmt::format("{}: expected a mesh called .obj, .ply, .stl or .off", file.string()));
    return parse(read_text(file, largest_surface), file.string());
}

}  // namespace interleaf
