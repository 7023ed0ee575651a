#include "io/mesh/surface_file.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "family/origin.h"
#include "io/file/input_file.h"
#include "io/mesh/obj_lines.h"
#include "io/text/words.h"

namespace interleaf {
namespace {

constexpr std::uint64_t max_surface_size = std::uint64_t{1} << 30;

glm::dvec3 as_floats(const glm::dvec3& p) {
    return {rounded_to_float(p.x), rounded_to_float(p.y), rounded_to_float(p.z)};
}

/// A sentence if 32-bit floats, which are coarse far from 0, have destroyed details; "" otherwise.
std::string lost_digits(const SurfaceFile& surface) {
    constexpr double enough_steps = 5000;
    glm::dvec3 least = surface.positions.front();
    glm::dvec3 most = least;
    for (const glm::dvec3& p : surface.positions) {
        if (p != as_floats(p)) return {};
        least = glm::min(least, p);
        most = glm::max(most, p);
    }
    const glm::dvec3 far = glm::max(glm::abs(least), glm::abs(most));
    const auto farthest = static_cast<float>(std::max({far.x, far.y, far.z}));
    const double step = double{std::nextafter(farthest, HUGE_VALF)} - double{farthest};
    const double steps = glm::distance(least, most) / step;
    if (steps > enough_steps) return {};
    return fmt::format(
        "The coordinates, of up to {:.6g}, are 32-bit floats, which leave {:.0f} steps across the surface: "
        "digits were lost when the file was written.",
        farthest, steps);
}

}  // namespace

SurfaceFile surface_of(PolygonMesh mesh, std::string_view name) {
    settle(mesh, name);
    std::vector<Triangle> triangles = triangles_of(mesh, name);
    return {std::move(mesh.positions), std::move(triangles), std::move(mesh.colors), std::move(mesh.scalars),
            std::move(mesh.remarks)};
}

SurfaceFile parse_obj(std::string_view text, std::string_view name) {
    SurfaceFile surface = surface_of(read_obj_lines(std::string(text), name), name);
    // The numbers of the key that the same file is (obj_keys.h): floats, unless it is far from 0.
    if (origin_for(surface.positions, surface.triangles) == glm::dvec3(0))
        for (glm::dvec3& position : surface.positions) position = as_floats(position);
    return surface;
}

SurfaceFile parse_file(const std::filesystem::path& file, SurfaceParser parse) {
    SurfaceFile surface = parse(read_text(file, max_surface_size), file.string());
    if (std::string lost = lost_digits(surface); !lost.empty()) surface.remarks.push_back(std::move(lost));
    return surface;
}

}  // namespace interleaf
