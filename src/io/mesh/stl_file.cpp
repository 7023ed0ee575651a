// Reads stereolithography files: three positions per triangle, as text or binary. Welding equal positions
// into one vertex is left to the caller.
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/mesh/surface_file.h"
#include "io/text/json_place.h"
#include "io/text/plain_text.h"
#include "io/text/words.h"

namespace interleaf {
namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t triangle_bytes = 50;  // normal, three positions, two bytes of attributes

/// Triangle n has the vertices 3 n, 3 n + 1 and 3 n + 2.
void number_vertices(SurfaceFile& surface, std::string_view name) {
    const auto count = static_cast<Index>(surface.positions.size() / 3);
    if (count == 0) throw InputError(fmt::format("{}: has no triangles, expected at least one", name));
    for (Index n = 0; n < count; ++n) surface.triangles.push_back({3 * n, 3 * n + 1, 3 * n + 2});
}

std::uint32_t claimed_triangles(std::string_view bytes) {
    std::uint32_t count = 0;
    for (unsigned byte = 0; byte < 4; ++byte)
        count |= std::uint32_t{static_cast<unsigned char>(bytes[80 + byte])} << (8 * byte);
    return count;
}

/// The number of triangles. Programs that write the file while they make triangles leave 0 or 2^32 - 1 as the
/// count; then the size of the file gives the number. Some programs write more bytes after the last triangle.
std::size_t count_triangles(std::string_view bytes, std::string_view name,
                            std::vector<std::string>& remarks) {
    const std::size_t claimed = claimed_triangles(bytes);
    const std::size_t present = (bytes.size() - header_bytes) / triangle_bytes;
    const std::size_t trailing = bytes.size() - header_bytes - triangle_bytes * present;
    const bool is_unknown = claimed == 0 || claimed == 0xffffffff;
    if (is_unknown && present > 0 && trailing == 0) {
        remarks.push_back(
            fmt::format("The count says {} triangles, but the size of the file says {}.", claimed, present));
        return present;
    }
    if (claimed > present)
        throw InputError(fmt::format(
            "{}: size: {} bytes, expected {} + {} for each of the {} triangles of the count at byte 80", name,
            bytes.size(), header_bytes, triangle_bytes, claimed));
    const std::size_t unread = bytes.size() - header_bytes - triangle_bytes * claimed;
    if (unread > 0) remarks.push_back(fmt::format("{} bytes after the last triangle were ignored.", unread));
    return claimed;
}

SurfaceFile parse_binary(std::string_view bytes, std::string_view name) {
    SurfaceFile surface;
    const std::size_t count = count_triangles(bytes, name, surface.remarks);
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

/// Reads the text form, in which line ends separate words like blanks.
class StlTextReader {
  public:
    StlTextReader(std::string_view text, std::string_view name) : words_(text), name_(name) {}

    SurfaceFile read() {
        // A name follows "solid" and "endsolid", up to the end of the line or the first "facet normal".
        std::size_t name_line = 0;
        bool is_ended = false;
        for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
            if (is_word(word, "facet") && is_word(Words(words_.rest()).next(), "normal")) {
                name_line = 0;
                is_ended = false;
            } else if (words_.line() == name_line) {
                continue;
            } else if (is_word(word, "solid") || is_word(word, "endsolid")) {
                name_line = words_.line();
                is_ended = is_word(word, "endsolid");
            } else if (is_word(word, "vertex")) {
                read_vertex();
            } else if (is_word(word, "endloop")) {
                end_loop();
            }
        }
        if (in_loop_ != 0) throw InputError(fmt::format("{}: ends within a loop, expected endloop", name_));
        if (!is_ended) surface_.remarks.emplace_back("The file ends without endsolid: it may be cut off.");
        return std::move(surface_);
    }

  private:
    [[noreturn]] void fail(std::size_t line, std::string_view what) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line, what));
    }

    void read_vertex() {
        const std::size_t line = words_.line();
        glm::dvec3 position;
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = words_.next();
            const double coordinate = parse_coordinate(word).value_or(NAN);
            if (std::isnan(coordinate))
                fail(line,
                     fmt::format("{} is not a coordinate, expected three finite numbers", in_quotes(word)));
            position[axis] = coordinate;
        }
        surface_.positions.push_back(position);
        ++in_loop_;
    }

    void end_loop() {
        if (in_loop_ != 3)
            fail(words_.line(), fmt::format("a loop of {} vertices ends, expected 3", in_loop_));
        in_loop_ = 0;
    }

    Words words_;
    std::string_view name_;
    std::size_t in_loop_ = 0;
    SurfaceFile surface_;
};

bool is_text(std::string_view bytes) {
    return looks_like_text(bytes) && is_word(Words(bytes).next().substr(0, 5), "solid");
}

}  // namespace

SurfaceFile parse_stl(std::string_view bytes, std::string_view name) {
    const bool is_exactly_binary =
        bytes.size() > header_bytes &&
        bytes.size() == header_bytes + triangle_bytes * std::size_t{claimed_triangles(bytes)};
    SurfaceFile surface;
    std::vector<std::string> remarks;
    if (!is_exactly_binary) {
        const std::string text = plain_text(std::string(bytes), remarks);
        if (is_text(text)) {
            surface = StlTextReader(text, name).read();
            surface.remarks.insert(surface.remarks.begin(), remarks.begin(), remarks.end());
            number_vertices(surface, name);
            return surface;
        }
        if (const std::string_view word = Words(text).next(); looks_like_text(text) && !word.empty())
            throw InputError(
                fmt::format("{}: begins with {}, expected solid, or a binary STL", name, in_quotes(word)));
    }
    if (bytes.size() < header_bytes)
        throw InputError(
            fmt::format("{}: size: {} bytes, expected at least {}, or a file that begins with solid", name,
                        bytes.size(), header_bytes));
    surface = parse_binary(bytes, name);
    number_vertices(surface, name);
    return surface;
}

}  // namespace interleaf
