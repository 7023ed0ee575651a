#include "io/surface_file.h"

#include <cstdint>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/family_file.h"
#include "io/input_file.h"
#include "io/obj_lines.h"

namespace interleaf {
namespace {

constexpr std::uint64_t largest_surface = std::uint64_t{1} << 30;

SurfaceFile parse_obj(std::string_view text, std::string_view name) {
    return surface_of(read_obj_lines(std::string(text), name), name);
}

}  // namespace

SurfaceFile surface_of(PolygonMesh mesh, std::string_view name) {
    settle(mesh, name);
    std::vector<Triangle> triangles = triangles_of(mesh, name);
    return {std::move(mesh.positions), std::move(triangles), std::move(mesh.colors), std::move(mesh.remarks)};
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
