// Reads the Object File Format of Geomview, text or binary: a header, counts, vertices and faces. The letters
// before OFF in the header, read from right to left, say what follows the three coordinates of a vertex: N a
// normal, C a color, ST texture coordinates. The reader skips normals and texture coordinates.
#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/mesh/ear_clipping.h"
#include "io/mesh/polygon_mesh.h"
#include "io/mesh/surface_file.h"
#include "io/text/json_place.h"
#include "io/text/plain_text.h"
#include "io/text/words.h"
#include "text/parsed_number.h"

namespace interleaf {
namespace {

struct OffHeader {
    std::string parts;  ///< what follows the coordinates of a vertex, in order: 'N', 'C', 'T'
    std::string_view rest;
    std::size_t line = 1;  ///< the line on which the rest begins
};

/// The OffHeader::parts for the letters before "OFF": "NCOFF" gives "CN". None for any other letters.
std::optional<std::string> parts_of(std::string_view letters) {
    std::string parts;
    while (!letters.empty()) {
        const bool is_texture = letters.ends_with("ST");
        if (!is_texture && !letters.ends_with('N') && !letters.ends_with('C')) return std::nullopt;
        parts += is_texture ? 'T' : letters.back();
        letters.remove_suffix(is_texture ? 2 : 1);
        if (parts.find(parts.back()) + 1 != parts.size()) return std::nullopt;
    }
    return parts;
}

/// Reads the header. A file without a header begins with its counts, and a count may adjoin the header.
OffHeader read_header(std::string_view text, std::string_view name) {
    Words words(text);
    std::string_view word = words.next();
    std::size_t line = words.line();
    for (std::string_view rest = text; word.starts_with('#'); line += words.line()) {
        rest.remove_prefix(static_cast<std::size_t>(word.data() - rest.data()));
        take_line(rest);
        words = Words(rest);
        word = words.next();
    }
    if (word.empty()) throw InputError(fmt::format("{}: is empty, expected OFF", name));
    if (!looks_like_text(word)) throw InputError(fmt::format("{}: is not text, expected OFF", name));
    const std::size_t place = word.find("OFF");
    const auto parts = parts_of(word.substr(0, place == std::string_view::npos ? 0 : place));
    std::uint32_t count = 0;
    if (!parts || (place == std::string_view::npos && parse_all(word, count) != std::errc()))
        throw InputError(fmt::format(
            "{}: line {}: {} begins the file, expected OFF, after ST, C or N for textures, colors or normals",
            name, line, in_quotes(word)));
    const char* const begin = place == std::string_view::npos ? word.data() : word.data() + place + 3;
    return {*parts, {begin, static_cast<std::size_t>(text.data() + text.size() - begin)}, line};
}

/// The part after the header of a binary file; none for a text file.
std::optional<std::string_view> binary_part(std::string_view bytes) {
    Words words(bytes.substr(0, 80));
    if (!words.next().ends_with("OFF") || words.next() != "BINARY") return std::nullopt;
    std::string_view rest = bytes.substr(static_cast<std::size_t>(words.rest().data() - bytes.data()));
    if (!rest.empty()) take_line(rest);
    return rest;
}

class OffTextReader {
  public:
    OffTextReader(OffHeader header, std::string_view name)
        : text_(header.rest), line_number_(header.line - 1), parts_(std::move(header.parts)), name_(name) {}

    PolygonMesh read() {
        next_line();
        const Index vertices = take_count("a number of vertices");
        const Index faces = take_count("a number of faces");
        constexpr std::size_t shortest_line = 6;  // "0 0 0" and its end
        mesh_.max_triangles = max_triangles_of(text_.size());
        mesh_.positions.reserve(std::min<std::size_t>(vertices, text_.size() / shortest_line + 1));
        for (Index vertex = 0; vertex < vertices; ++vertex) read_vertex();
        for (Index face = 0; face < faces; ++face) read_face(vertices);
        return std::move(mesh_);
    }

  private:
    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line_number_, what));
    }

    /// Goes to the next line that contains a word, and drops its comment.
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

    Index take_count(std::string_view expected) {
        const std::string_view word = take_word(line_);
        Index count = 0;
        if (parse_all(word, count) != std::errc())
            fail(fmt::format("{} found, expected {}", in_quotes(word), expected));
        return count;
    }

    double take_number(std::string_view expected) {
        const std::string_view word = take_word(line_);
        const std::optional<double> number = parse_coordinate(word);
        if (!number) fail(fmt::format("{} found, expected {}", in_quotes(word), expected));
        return *number;
    }

    void read_vertex() {
        next_line();
        glm::dvec3 position;
        for (int axis = 0; axis < 3; ++axis) position[axis] = take_number("three finite coordinates");
        if (!mesh_.add_vertex(position, [&] { return fmt::format("line {}", line_number_); }))
            fail(too_many_broken_vertices);
        for (const char part : parts_) {
            if (part == 'C') read_color();
            const int numbers = part == 'N' ? 3 : part == 'T' ? 2 : 0;
            for (int i = 0; i < numbers; ++i) take_number("a normal's or a texture's finite number");
        }
    }

    /// Reads a color: integers from 0 to 255, or numbers from 0 to 1 if one of them has a decimal point. If
    /// more numbers follow than the rest of the vertex needs, the first of them is the opacity and is
    /// skipped.
    void read_color() {
        std::array<std::string_view, 3> words;
        for (std::string_view& word : words) word = take_word(line_);
        bool is_fraction = false;
        for (const std::string_view word : words) is_fraction = is_fraction || word.find('.') != word.npos;
        glm::vec3 color;
        for (int channel = 0; channel < 3; ++channel) {
            const std::string_view word = words[static_cast<std::size_t>(channel)];
            const std::optional<double> number = parse_coordinate(word);
            if (!number) fail(fmt::format("{} found, expected a color of three numbers", in_quotes(word)));
            color[channel] = static_cast<float>(is_fraction ? *number : *number / 255);
        }
        mesh_.colors.push_back(color);
        std::size_t behind = 0;  // numbers of this vertex after its color
        const std::size_t place = parts_.find('C');
        for (const char part : parts_.substr(place + 1)) behind += part == 'N' ? 3 : 2;
        std::string_view rest = line_;
        std::size_t present = 0;
        while (!take_word(rest).empty()) ++present;
        if (present > behind) take_word(line_);
    }

    /// Reads a face. Its corners may continue on the next line. The reader skips everything after the
    /// corners, such as a color.
    void read_face(Index vertices) {
        next_line();
        const std::size_t line = line_number_;
        const Index count = take_count("the number of a face's corners");
        if (count < 3 || count > max_polygon_corners)
            fail(fmt::format("a face of {} corners, expected 3 to {}", count, max_polygon_corners));
        corners_.clear();
        for (Index i = 0; i < count; ++i) {
            std::string_view rest = line_;
            if (take_word(rest).empty()) next_line();
            const Index corner = take_count("a vertex for each corner");
            if (corner >= vertices)
                fail(fmt::format("vertex {} does not exist, there are {}, counted from 0", corner, vertices));
            corners_.push_back(corner);
        }
        if (!mesh_.add_face(corners_, line)) fail(too_many_triangles);
    }

    std::string_view text_;
    std::string_view line_;
    std::size_t line_number_;
    std::string parts_;
    std::string_view name_;
    std::vector<Index> corners_;
    PolygonMesh mesh_;
};

/// Reads the binary form: numbers of four bytes, big endian.
class BinaryReader {
  public:
    BinaryReader(std::string_view bytes, std::string parts, std::string_view name)
        : rest_(bytes), parts_(std::move(parts)), name_(name) {}

    PolygonMesh read() {
        const std::uint32_t vertices = take();
        const std::uint32_t faces = take();
        take();  // edges
        constexpr std::size_t vertex_bytes = 12;
        mesh_.max_triangles = max_triangles_of(rest_.size());
        mesh_.positions.reserve(std::min<std::size_t>(vertices, rest_.size() / vertex_bytes));
        element_ = "vertex";
        for (number_ = 0; number_ < vertices; ++number_) read_vertex();
        element_ = "face";
        for (number_ = 0; number_ < faces; ++number_) read_face(vertices);
        return std::move(mesh_);
    }

  private:
    std::string place() const { return fmt::format("{} {} (counted from 0)", element_, number_); }

    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: {}: {}", name_, place(), what));
    }

    std::uint32_t take() {
        if (rest_.size() < 4) fail("the file ends within it");
        std::uint32_t number = 0;
        for (std::size_t i = 0; i < 4; ++i) number = number << 8 | static_cast<unsigned char>(rest_[i]);
        rest_.remove_prefix(4);
        return number;
    }

    float take_float() { return std::bit_cast<float>(take()); }

    void read_vertex() {
        glm::dvec3 position;
        for (int axis = 0; axis < 3; ++axis) position[axis] = take_float();
        if (!mesh_.add_vertex(position, [&] { return place(); })) fail(too_many_broken_vertices);
        for (const char part : parts_) {
            std::array<float, 4> numbers{};
            const std::size_t count = part == 'C' ? 4 : part == 'N' ? 3 : 2;
            for (std::size_t i = 0; i < count; ++i) numbers[i] = take_float();
            if (part == 'C') mesh_.colors.emplace_back(numbers[0], numbers[1], numbers[2]);
        }
    }

    void read_face(std::uint32_t vertices) {
        const std::uint32_t count = take();
        if (count < 3 || count > max_polygon_corners)
            fail(fmt::format("{} corners, expected 3 to {}", count, max_polygon_corners));
        corners_.clear();
        for (std::uint32_t i = 0; i < count; ++i) {
            const std::uint32_t corner = take();
            if (corner >= vertices)
                fail(fmt::format("vertex {} does not exist, there are {}, counted from 0", corner, vertices));
            corners_.push_back(corner);
        }
        if (!mesh_.add_face(corners_)) fail(too_many_triangles);
        const std::uint32_t colors = take();
        if (colors > 4) fail(fmt::format("a color of {} numbers, expected at most 4", colors));
        for (std::uint32_t i = 0; i < colors; ++i) take();
    }

    std::string_view rest_;
    std::string parts_;
    std::string_view name_;
    std::string_view element_ = "count";
    std::uint32_t number_ = 0;
    std::vector<Index> corners_;
    PolygonMesh mesh_;
};

PolygonMesh read_text_form(std::string_view bytes, std::string_view name) {
    std::vector<std::string> remarks;
    const std::string text = plain_text(std::string(bytes), remarks);
    PolygonMesh mesh = OffTextReader(read_header(text, name), name).read();
    mesh.remarks = std::move(remarks);
    return mesh;
}

}  // namespace

SurfaceFile parse_off(std::string_view bytes, std::string_view name) {
    if (const auto binary = binary_part(bytes))
        return surface_of(BinaryReader(*binary, read_header(bytes.substr(0, 80), name).parts, name).read(),
                          name);
    return surface_of(read_text_form(bytes, name), name);
}

}  // namespace interleaf
