// Stereolithography files: three positions for each triangle, as text or binary. What makes a surface of
// them, that equal positions are one vertex, is for who reads it.
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/json_place.h"
#include "io/surface_file.h"
#include "io/words.h"

namespace interleaf {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;  // normal, three positions, two bytes of attributes

/// Triangle n has the vertices 3 n, 3 n + 1 and 3 n + 2.
void number_vertices(SurfaceFile& surface, std::string_view name) {
    const auto count = static_cast<Index>(surface.positions.size() / 3);
    if (count == 0) throw InputError(fmt::format("{}: has no triangles, expected some", name));
    for (Index n = 0; n < count; ++n) surface.triangles.push_back({3 * n, 3 * n + 1, 3 * n + 2});
}

std::uint32_t claimed_triangles(std::string_view bytes) {
    std::uint32_t count = 0;
    for (unsigned byte = 0; byte < 4; ++byte)
        count |= std::uint32_t{static_cast<unsigned char>(bytes[80 + byte])} << (8 * byte);
    return count;
}

bool is_binary(std::string_view bytes) {
    return bytes.size() >= header_bytes &&
           bytes.size() == header_bytes + triangle_bytes * std::size_t{claimed_triangles(bytes)};
}

SurfaceFile parse_binary(std::string_view bytes, std::string_view name) {
    SurfaceFile surface;
    const std::size_t count = claimed_triangles(bytes);
    surface.positions.reserve(3 * count);
    for (std::size_t n = 0; n < count; ++n)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            glm::vec3 position;
            static_assert(sizeof position == 12);
            std::memcpy(&position, &bytes[header_bytes + triangle_bytes * n + 12 * (corner + 1)], 12);
            if (!std::isfinite(position.x) || !std::isfinite(position.y) || !std::isfinite(position.z))
                throw InputError(fmt::format(
                    "{}: triangle {} (counted from 0): a coordinate is not a finite number", name, n));
            surface.positions.emplace_back(position);
        }
    return surface;
}

SurfaceFile parse_text(std::string_view text, std::string_view name) {
    SurfaceFile surface;
    std::size_t in_loop = 0;
    for (std::size_t number = 1; !text.empty(); ++number) {
        std::string_view line = take_line(text);
        const auto fail = [&](std::string_view what) {
            throw InputError(fmt::format("{}: line {}: {}", name, number, what));
        };
        const std::string_view keyword = take_word(line);
        if (keyword == "vertex") {
            glm::dvec3 position;
            for (int axis = 0; axis < 3; ++axis) {
                const std::string_view word = take_word(line);
                const std::optional<double> coordinate = parse_double(word);
                if (!coordinate)
                    fail(fmt::format("{} is not a coordinate, expected three finite numbers",
                                     in_quotes(word)));
                position[axis] = coordinate.value_or(0);
            }
            surface.positions.push_back(position);
            ++in_loop;
        } else if (keyword == "endloop") {
            if (in_loop != 3) fail(fmt::format("a loop of {} vertices ends, expected 3", in_loop));
            in_loop = 0;
        }
    }
    if (in_loop != 0) throw InputError(fmt::format("{}: ends within a loop, expected endloop", name));
    return surface;
}

}  // namespace

SurfaceFile parse_stl(std::string_view bytes, std::string_view name) {
    if (!is_binary(bytes) && !bytes.starts_with("solid")) {
        throw InputError(
            bytes.size() < header_bytes
                ? fmt::format("{}: size: {} bytes, expected at least {}, or a file that begins with solid",
                              name, bytes.size(), header_bytes)
                : fmt::format(
                      "{}: size: {} bytes, expected {} + {} for each of the {} triangles named at byte 80, "
                      "or a file that begins with solid",
                      name, bytes.size(), header_bytes, triangle_bytes, claimed_triangles(bytes)));
    }
    SurfaceFile surface = is_binary(bytes) ? parse_binary(bytes, name) : parse_text(bytes, name);
    number_vertices(surface, name);
    return surface;
}

}  // namespace interleaf
