#include "io/obj_lines.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <system_error>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/json_place.h"
#include "io/polygon_divider.h"
#include "io/words.h"

namespace interleaf {

namespace {

/// Far more than the largest file can have.
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
            if (word.empty()) fail(fmt::format("a vertex of {} coordinates, expected three", axis));
            const std::optional<float> number = parse_float(word);
            if (!number)
                fail(fmt::format("{} is not a coordinate, expected three finite numbers", in_quotes(word)));
            position[axis] = *number;
        }
        read_color(line.substr(0, line.find('#')));
        lines_.positions.push_back(position);
    }

    /// What follows the coordinates: nothing, a weight, or a colour, and what may follow that.
    void read_color(std::string_view line) {
        std::array<std::string_view, 3> words;
        for (std::string_view& word : words) word = take_word(line);
        const bool has_color = !words[2].empty();
        if (has_color) lines_.colors.resize(lines_.positions.size(), glm::vec3(1));
        if (!has_color && lines_.colors.empty()) return;
        glm::vec3 color(1);
        for (int c = 0; has_color && c < 3; ++c) {
            const std::string_view word = words[static_cast<std::size_t>(c)];
            const std::optional<float> part = parse_float(word);
            if (!part || *part < 0 || *part > 1)
                fail(fmt::format("{} is not a part of a colour, expected three numbers from 0 to 1",
                                 in_quotes(word)));
            color[c] = *part;
        }
        lines_.colors.push_back(color);
    }

    void read_face(std::string_view line) {
        std::size_t corners = 0;
        for (std::string_view word = take_word(line); !word.empty(); word = take_word(line)) {
            lines_.corners.push_back(static_cast<Index>(vertex_number(word) - 1));
            ++corners;
        }
        if (corners < 3 || corners > most_corners)
            fail(fmt::format("a face of {} vertices, expected 3 to {}", corners, most_corners));
        lines_.face_sizes.push_back(static_cast<std::uint16_t>(corners));
        lines_.triangle_count += corners - 2;
    }

    /// The number, from 1, of the vertex of a corner "v", "v/vt", "v//vn" or "v/vt/vn". One below 0 counts
    /// back from the last.
    std::size_t vertex_number(std::string_view word) {
        std::int64_t number = 0;
        if (parse_word(word.substr(0, word.find('/')), number) != std::errc())
            fail(fmt::format("{} is not a corner, expected the number of a vertex", in_quotes(word)));
        const std::int64_t before = static_cast<std::int64_t>(lines_.positions.size());
        if (number == 0) fail("vertex 0 does not exist, they are counted from 1");
        if (number < -before || number > static_cast<std::int64_t>(most_vertices))
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
    std::vector<Triangle> triangles(lines.triangle_count);
    PolygonDivider divider(lines.positions, name);
    const Index* corner = lines.corners.data();
    auto* place = triangles.data();
    for (std::size_t face = 0; face < lines.face_sizes.size(); ++face) {
        const std::size_t size = lines.face_sizes[face];
        if (size == 3)
            *place = {corner[0], corner[1], corner[2]};
        else
            divider.divide(face, {corner, size}, {place, size - 2});
        corner += size;
        place += size - 2;
    }
    divider.finish();
    return triangles;
}

}  // namespace interleaf
