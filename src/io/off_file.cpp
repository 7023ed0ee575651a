// The Object File Format of Geomview: a header, counts, a line for each vertex and each face. Read in its
// text form with three coordinates; the letters N and C before OFF tell of normals, which are left out, and
// of colours.
#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/json_place.h"
#include "io/surface_file.h"
#include "io/words.h"

namespace interleaf {
namespace {

class OffReader {
  public:
    OffReader(std::string_view text, std::string_view name) : text_(text), name_(name) {}

    SurfaceFile read() {
        next_line();
        read_header();
        if (line_.empty()) next_line();
        const Index vertices = take_count("a number of vertices");
        const Index faces = take_count("a number of faces");
        for (Index vertex = 0; vertex < vertices; ++vertex) read_vertex();
        for (Index face = 0; face < faces; ++face) read_face(vertices);
        if (surface_.triangles.empty())
            throw InputError(fmt::format("{}: has no faces, expected some", name_));
        return std::move(surface_);
    }

  private:
    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line_number_, what));
    }

    /// Goes to the next line that holds a word, and drops its comment.
    void next_line() {
        do {
            if (text_.empty()) fail("the file ends, expected more vertices or faces");
            line_ = take_line(text_);
            ++line_number_;
            line_ = line_.substr(0, line_.find('#'));
            std::string_view rest = line_;
            if (take_word(rest).empty()) line_ = {};
        } while (line_.empty());
    }

    void read_header() {
        std::string_view rest = line_;
        const std::string_view word = take_word(rest);
        if (word != "OFF" && word != "COFF" && word != "NOFF" && word != "CNOFF")
            fail(fmt::format("{} begins the file, expected OFF, COFF, NOFF or CNOFF", in_quotes(word)));
        has_colors_ = word.starts_with('C');
        has_normals_ = word.find('N') != std::string_view::npos;
        line_ = rest;
        if (take_word(rest).empty()) line_ = {};
    }

    Index take_count(std::string_view expected) {
        const std::string_view word = take_word(line_);
        Index count = 0;
        if (parse_word(word, count) != std::errc())
            fail(fmt::format("{} found, expected {}", in_quotes(word), expected));
        return count;
    }

    double take_number(std::string_view expected) {
        const std::string_view word = take_word(line_);
        const std::optional<double> number = parse_double(word);
        if (!number) fail(fmt::format("{} found, expected {}", in_quotes(word), expected));
        return *number;
    }

    void read_vertex() {
        next_line();
        glm::dvec3 position;
        for (int axis = 0; axis < 3; ++axis) position[axis] = take_number("three finite coordinates");
        surface_.positions.push_back(position);
        for (int axis = 0; has_normals_ && axis < 3; ++axis) take_number("a normal of three finite numbers");
        if (has_colors_) read_color();
    }

    /// Whole numbers from 0 to 255, or numbers from 0 to 1 of which one has a point.
    void read_color() {
        const bool is_fraction = line_.find('.') != std::string_view::npos;
        glm::vec3 color;
        for (int channel = 0; channel < 3; ++channel) {
            const double number = take_number("a colour of three numbers");
            if (number < 0 || number > (is_fraction ? 1 : 255))
                fail("a colour out of range, expected 0 to 1 with a point, or 0 to 255 without");
            color[channel] = static_cast<float>(is_fraction ? number : number / 255);
        }
        surface_.colors.push_back(color);
    }

    void read_face(Index vertices) {
        next_line();
        const Index count = take_count("the number of a face's corners");
        if (count < 3 || count > most_polygon_corners)
            fail(fmt::format("a face of {} corners, expected 3 to {}", count, most_polygon_corners));
        corners_.clear();
        for (Index i = 0; i < count; ++i) {
            const Index corner = take_count("a vertex for each corner");
            if (corner >= vertices)
                fail(fmt::format("vertex {} does not exist, there are {}, counted from 0", corner, vertices));
            corners_.push_back(corner);
        }
        append_fan(surface_.triangles, corners_);
    }

    std::string_view text_;
    std::string_view name_;
    std::string_view line_;
    std::size_t line_number_ = 0;
    bool has_colors_ = false;
    bool has_normals_ = false;
    std::vector<Index> corners_;
    SurfaceFile surface_;
};

}  // namespace

SurfaceFile parse_off(std::string_view bytes, std::string_view name) {
    return OffReader(bytes, name).read();
}

}  // namespace interleaf
