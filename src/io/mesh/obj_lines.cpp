#include "io/mesh/obj_lines.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/mesh/ear_clipping.h"
#include "io/text/json_place.h"
#include "io/text/plain_text.h"
#include "io/text/words.h"
#include "text/parsed_number.h"

namespace interleaf {

namespace {

/// Far more vertices than the largest file can have.
constexpr std::size_t max_vertices = std::numeric_limits<int>::max() / 3;

class Reader {
  public:
    Reader(std::string_view text, std::string_view name) : text_(text), name_(name) {
        mesh_.max_triangles = max_triangles_of(text.size());
        constexpr std::size_t shortest_line = 8;  // "v 0 0 0" and its end
        mesh_.positions.reserve(std::min(vertex_lines_in(text), text.size() / shortest_line + 1));
    }

    PolygonMesh read() {
        while (!text_.empty()) read_line();
        if (greatest_ > mesh_.positions.size()) {
            line_number_ = max_line_;
            fail(fmt::format("vertex {} does not exist, there are {}", greatest_, mesh_.positions.size()));
        }
        if (mesh_.colors.size() != mesh_.positions.size()) mesh_.colors.clear();
        return std::move(mesh_);
    }

  private:
    static std::size_t vertex_lines_in(std::string_view text) {
        std::size_t count = text.starts_with("v ");
        for (std::size_t place = text.find('\n'); place != std::string_view::npos;
             place = text.find('\n', place + 1))
            count += text.substr(place + 1, 2) == "v ";
        return count;
    }

    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line_number_, what));
    }

    void read_line() {
        std::string_view line = next_line();
        line_number_ = lines_read_;
        std::string_view rest = line;
        const std::string_view keyword = take_word(rest);
        if (keyword == "l") ++mesh_.lines;
        if (keyword == "surf") ++mesh_.free_forms;
        if (keyword != "v" && keyword != "f") return;
        line = whole_line(line);
        take_word(line);
        if (keyword == "v")
            read_vertex(line);
        else
            read_face(line);
    }

    std::string_view next_line() {
        ++lines_read_;
        return take_line(text_);
    }

    /// \p line without its comment. If it ends in a backslash, the next line is joined to it.
    std::string_view whole_line(std::string_view line) {
        constexpr std::string_view blanks = " \t\r";
        joined_.clear();
        while (true) {
            line = line.substr(0, comment_in(line));
            line = line.substr(0, line.find_last_not_of(blanks) + 1);
            if (!line.ends_with('\\')) break;
            line.remove_suffix(1);
            if (text_.empty()) break;
            joined_.append(line).append(" ");
            line = next_line();
        }
        if (joined_.empty()) return line;
        joined_.append(line);
        return joined_;
    }

    /// The place where the comment of a line begins. The "#" in "1.#QNAN", which some programs print, does
    /// not begin a comment.
    static std::size_t comment_in(std::string_view line) {
        std::size_t place = line.find('#');
        while (place != std::string_view::npos && place > 0 && line[place - 1] == '.')
            place = line.find('#', place + 1);
        return place;
    }

    /// The next word, without the comma that may follow a number.
    static std::string_view take_number(std::string_view& line) {
        std::string_view word = take_word(line);
        if (word.size() > 1 && word.ends_with(',')) word.remove_suffix(1);
        return word;
    }

    void read_vertex(std::string_view line) {
        if (mesh_.positions.size() == max_vertices) fail(fmt::format("more than {} vertices", max_vertices));
        glm::dvec3 position{};
        for (int axis = 0; axis < 3; ++axis) {
            const std::string_view word = take_number(line);
            if (word.empty()) fail(fmt::format("a vertex of {} coordinates, expected three", axis));
            const std::optional<double> number = parse_coordinate(word);
            if (!number)
                fail(fmt::format("{} is not a coordinate, expected three finite numbers", in_quotes(word)));
            position[axis] = *number;
        }
        read_color(line);
        if (!mesh_.add_vertex(position, [&] { return fmt::format("line {}", line_number_); }))
            fail(too_many_broken_vertices);
    }

    /// Reads the rest of a line after the coordinates: nothing, a weight, or a color and anything after it.
    void read_color(std::string_view line) {
        std::array<std::string_view, 3> words;
        for (std::string_view& word : words) word = take_number(line);
        const bool has_color = !words[2].empty();
        if (has_color) mesh_.colors.resize(mesh_.positions.size(), glm::vec3(1));
        if (!has_color && mesh_.colors.empty()) return;
        glm::vec3 color(1);
        for (int c = 0; has_color && c < 3; ++c) {
            const std::string_view word = words[static_cast<std::size_t>(c)];
            const std::optional<double> part = parse_coordinate(word);
            if (!part)
                fail(fmt::format("{} is not a part of a color, expected three numbers", in_quotes(word)));
            color[c] = static_cast<float>(*part);
        }
        mesh_.colors.push_back(color);
    }

    void read_face(std::string_view line) {
        corners_.clear();
        for (std::string_view word = take_number(line); !word.empty(); word = take_number(line))
            corners_.push_back(static_cast<Index>(vertex_number(word) - 1));
        if (corners_.size() < 3 || corners_.size() > max_polygon_corners)
            fail(
                fmt::format("a face of {} vertices, expected 3 to {}", corners_.size(), max_polygon_corners));
        if (!mesh_.add_face(corners_, line_number_)) fail(too_many_triangles);
    }

    /// The number, from 1, of the vertex of a corner "v", "v/vt", "v//vn" or "v/vt/vn". A negative number in
    /// the file counts back from the last vertex.
    std::size_t vertex_number(std::string_view word) {
        std::int64_t number = 0;
        if (parse_all(word.substr(0, word.find('/')), number) != std::errc())
            fail(fmt::format("{} is not a corner, expected the number of a vertex", in_quotes(word)));
        const std::int64_t before = static_cast<std::int64_t>(mesh_.positions.size());
        if (number == 0) fail("vertex 0 does not exist, they are counted from 1");
        if (number < -before || number > static_cast<std::int64_t>(max_vertices))
            fail(fmt::format("vertex {} does not exist, there are {} before this line", number, before));
        const auto counted = static_cast<std::size_t>(number > 0 ? number : before + 1 + number);
        if (counted > greatest_) {
            greatest_ = counted;
            max_line_ = line_number_;
        }
        return counted;
    }

    std::string_view text_;
    std::string_view name_;
    std::size_t lines_read_ = 0;
    std::size_t line_number_ = 0;  ///< the line on which the current vertex or face begins
    std::string joined_;           ///< its lines, joined
    std::vector<Index> corners_;
    std::size_t greatest_ = 0;
    std::size_t max_line_ = 0;
    PolygonMesh mesh_;
};

}  // namespace

PolygonMesh read_obj_lines(std::string text, std::string_view name) {
    std::vector<std::string> remarks;
    const std::string plain = plain_text(std::move(text), remarks);
    PolygonMesh mesh = Reader(plain, name).read();
    if (mesh.face_sizes.empty() && !looks_like_text(plain))
        throw InputError(fmt::format("{}: is not text, expected lines that begin with v and f", name));
    mesh.remarks = std::move(remarks);
    return mesh;
}

}  // namespace interleaf
