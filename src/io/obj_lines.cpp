#include "io/obj_lines.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <system_error>

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include "hierarchy/error.h"
#include "io/json_place.h"
#include "io/words.h"

namespace interleaf {

namespace {

/// Dividing a polygon takes time that grows with the square of its corners.
constexpr std::size_t most_corners = 1000;

/// tinyobjloader counts vertices in an int, and coordinates in an int as well.
constexpr std::size_t most_vertices = std::numeric_limits<int>::max() / 3;

class Reader {
  public:
    explicit Reader(std::string_view name) : name_(name) {}

    void read(std::string_view line) {
        ++line_number_;
        const std::string_view keyword = take_word(line);
        if (keyword == "v") read_vertex(line);
        if (keyword == "f") read_face(line);
    }

    ObjLines finish() {
        if (greatest_ > lines_.positions.size()) {
            line_number_ = greatest_line_;
            fail(fmt::format("vertex {} does not exist, there are {}", greatest_, lines_.positions.size()));
        }
        if (lines_.colors.size() != lines_.positions.size()) lines_.colors.clear();
        if (lines_.triangle_count == 0)
            throw InputError(fmt::format("{}: has no faces, expected some", name_));
        return std::move(lines_);
    }

  private:
    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line_number_, what));
    }

    void read_vertex(std::string_view line) {
        if (lines_.positions.size() == most_vertices)
            fail(fmt::format("more than {} vertices", most_vertices));
        glm::vec3 position{};
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = take_word(line);
            const std::optional<float> number = parse_float(word);
            if (!number)
                fail(fmt::format("{} is not a coordinate, expected three finite numbers", in_quotes(word)));
            position[axis] = *number;
        }
        lines_.positions.push_back(position);
        read_color(line);
        fmt::format_to(std::back_inserter(lines_.text), "v {} {} {}\n", position.x, position.y, position.z);
    }

    /// Three more numbers on a vertex line are its colour, as many programs write it; anything else is not.
    void read_color(std::string_view rest) {
        glm::vec3 color{};
        for (int channel = 0; channel < 3; ++channel) {
            const std::optional<float> number = parse_float(take_word(rest));
            if (!number || *number < 0 || *number > 1) return;
            color[channel] = *number;
        }
        if (take_word(rest).empty() && lines_.colors.size() + 1 == lines_.positions.size())
            lines_.colors.push_back(color);
    }

    void read_face(std::string_view line) {
        lines_.text += 'f';
        std::size_t corners = 0;
        for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
            fmt::format_to(std::back_inserter(lines_.text), " {}", vertex_number(word));
            ++corners;
        }
        if (corners < 3 || corners > most_corners)
            fail(fmt::format("a face of {} vertices, expected 3 to {}", corners, most_corners));
        lines_.text += '\n';
        lines_.triangle_count += corners - 2;
    }

    /// The number, from 1, of the vertex of a corner "v", "v/vt", "v//vn" or "v/vt/vn". One below 0 counts
    /// back from the last.
    std::size_t vertex_number(std::string_view word) {
        std::int64_t number = 0;
        if (parse_word(word.substr(0, word.find('/')), number) != std::errc())
            fail(fmt::format("{} is not a corner, expected the number of a vertex", in_quotes(word)));
        const std::int64_t before = static_cast<std::int64_t>(lines_.positions.size());
        if (number == 0 || number < -before || number > static_cast<std::int64_t>(most_vertices))
            fail(fmt::format("vertex {} does not exist, there are {} before this line", number, before));
        const auto counted = static_cast<std::size_t>(number > 0 ? number : before + 1 + number);
        if (counted > greatest_) {
            greatest_ = counted;
            greatest_line_ = line_number_;
        }
        return counted;
    }

    std::string_view name_;
    std::size_t line_number_ = 0;
    std::size_t greatest_ = 0;
    std::size_t greatest_line_ = 0;
    ObjLines lines_;
};

}  // namespace

ObjLines read_obj_lines(std::string_view obj, std::string_view name) {
    Reader reader(name);
    while (!obj.empty()) reader.read(take_line(obj));
    return reader.finish();
}

std::vector<Triangle> triangles_of(const ObjLines& lines, std::string_view name) {
    tinyobj::ObjReader reader;
    tinyobj::ObjReaderConfig options;
    options.vertex_color = false;
    if (!reader.ParseFromString(lines.text, "", options))
        throw InputError(fmt::format("{}: {}", name, reader.Error()));

    std::vector<Triangle> triangles;
    triangles.reserve(lines.triangle_count);
    for (const tinyobj::shape_t& shape : reader.GetShapes())
        for (std::size_t i = 0; i < shape.mesh.indices.size(); i += 3) {
            const auto vertex = [&](std::size_t corner) {
                return static_cast<Index>(shape.mesh.indices[i + corner].vertex_index);
            };
            triangles.push_back({vertex(0), vertex(1), vertex(2)});
        }
    if (triangles.size() != lines.triangle_count)
        throw InputError(fmt::format("{}: faces: a polygon cannot be divided into triangles", name));
    return triangles;
}

}  // namespace interleaf
