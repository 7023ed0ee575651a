// Reads the Polygon File Format of Stanford: a header (ply_header.h), then the values of the elements as text or
// binary. The reader takes vertices (x, y, z; red, green, blue if present; other floats as scalars), faces and triangle
// strips, and skips all other elements and properties.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/mesh/ear_clipping.h"
#include "io/mesh/ply_header.h"
#include "io/mesh/polygon_mesh.h"
#include "io/mesh/surface_file.h"
#include "io/text/json_place.h"
#include "io/text/plain_text.h"
#include "io/text/words.h"
#include "text/parsed_number.h"

namespace interleaf {
namespace {

class PlyReader {
  public:
    PlyReader(std::string_view bytes, std::string_view name)
        : name_(name), header_(read_ply_header(bytes, name)), rest_(header_.values) {
        mesh_.max_triangles = max_triangles_of(bytes.size());
        mesh_.remarks = std::move(header_.remarks);
    }

    PolygonMesh read() {
        const bool is_row_per_line = header_.form == PlyHeader::Form::text && has_row_per_line();
        for (const Element& element : header_.elements) {
            if (element.properties.empty()) continue;  // takes no bytes
            if (element.name == "vertex") mesh_.positions.reserve(at_most(element));
            if (element.name == "edge") mesh_.lines = element.count;
            for (number_ = 0; number_ < element.count; ++number_) {
                element_ = element.name;
                if (element.name == "vertex")
                    read_vertex(element);
                else if (element.name == "face")
                    read_face(element);
                else if (element.name == "tristrips")
                    read_strips(element);
                else
                    for (const Property& property : element.properties) pass_over(property);
                if (is_row_per_line) end_line();
            }
        }
        const bool has_more =
            header_.form == PlyHeader::Form::text ? !Words(rest_).next().empty() : !rest_.empty();
        if (!header_.unknown_line.empty() && has_more)
            throw InputError(fmt::format("{}: more follows than the header declares, of which a line says {}",
                                         name_, in_quotes(header_.unknown_line)));
        if (mesh_.colors.size() != mesh_.positions.size()) mesh_.colors.clear();
        std::erase_if(mesh_.scalars, [&](const MeshField& scalar) {
            return scalar.values.size() != mesh_.positions.size();
        });
        for (const Index vertex : mesh_.corners)
            if (vertex >= mesh_.positions.size())
                throw InputError(fmt::format("{}: a face has vertex {}, there are {}, counted from 0", name_,
                                             vertex, mesh_.positions.size()));
        return std::move(mesh_);
    }

  private:
    using Type = PlyHeader::Type;
    using Property = PlyHeader::Property;
    using Element = PlyHeader::Element;
    using Form = PlyHeader::Form;

    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: {}: {}", name_, place(), what));
    }
    std::string place() const { return fmt::format("{} {} (counted from 0)", element_, number_); }

    /// The number of instances of an element that the header says, but at most as many as fit the rest of the
    /// file.
    std::size_t at_most(const Element& element) const {
        constexpr std::size_t digit_and_blank = 2;
        std::size_t bytes = 0;
        for (const Property& property : element.properties) {
            const Type& type = property.count_type != nullptr ? *property.count_type : *property.type;
            bytes += header_.form == Form::text ? digit_and_blank : type.bytes;
        }
        return static_cast<std::size_t>(std::min<std::uint64_t>(element.count, rest_.size() / bytes + 1));
    }

    /// Whether there are as many lines that are not blank as rows of values.
    bool has_row_per_line() const {
        std::uint64_t lines = 0;
        for (std::string_view rest = rest_; !rest.empty();) {
            std::string_view line = take_line(rest);
            if (!take_word(line).empty()) ++lines;
        }
        std::uint64_t rows = 0;
        for (const Element& element : header_.elements)
            if (!element.properties.empty()) rows += element.count;
        return lines == rows;
    }

    /// Passes over the values on the rest of the line, which some programs write without declaring them.
    void end_line() {
        if (rest_.empty()) return;
        std::string_view line = take_line(rest_);
        if (take_word(line).empty() || std::exchange(has_undeclared_, true)) return;
        mesh_.remarks.push_back(
            fmt::format("Values that the header does not declare, first of {}, were ignored.", place()));
    }

    /// The next word of the text, on any line.
    std::string_view next_word() {
        constexpr std::string_view spaces = " \t\r\n";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(spaces), rest_.size()));
        const std::string_view word = rest_.substr(0, rest_.find_first_of(spaces));
        if (word.empty()) fail("the file ends within it");
        rest_.remove_prefix(word.size());
        return word;
    }

    /// The next value as a double, which can hold the values of all types.
    double next(const Type& type) {
        if (header_.form == Form::text) {
            const std::string_view word = next_word();
            const std::optional<double> number = parse_coordinate(word);
            if (!number) fail(fmt::format("{} found, expected a number", in_quotes(word)));
            return *number;
        }
        if (rest_.size() < type.bytes) fail("the file ends within it");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < type.bytes; ++i) {
            const std::size_t place = header_.form == Form::little_endian ? i : type.bytes - 1 - i;
            bits |= std::uint64_t{static_cast<unsigned char>(rest_[place])} << (8 * i);
        }
        rest_.remove_prefix(type.bytes);
        if (type.is_float && type.bytes == 8) return std::bit_cast<double>(bits);
        if (type.is_float) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
        const auto value = static_cast<double>(bits);
        return type.is_signed && (bits & sign) != 0 ? value - 2 * static_cast<double>(sign) : value;
    }

    Index next_whole(const Type& type, std::string_view expected) { return whole(next(type), expected); }

    Index whole(double number, std::string_view expected) const {
        if (!(number >= 0 && number < double(no_index) && number == std::floor(number)))
            fail(fmt::format("{} found, expected {}", number, expected));
        return static_cast<Index>(number);
    }

    /// Reads triangle strips. Every three consecutive corners are a triangle, and every second triangle is
    /// reversed. -1 ends a strip. A repeated corner connects two parts of a strip.
    void read_strips(const Element& element) {
        for (const Property& property : element.properties) {
            if (property.count_type == nullptr || !property.name.starts_with("vertex_ind")) {
                pass_over(property);
                continue;
            }
            const Index count = next_whole(*property.count_type, "the length of the strips");
            corners_.clear();
            for (Index i = 0; i < count; ++i) {
                const double corner = next(*property.type);
                if (corner == -1) {
                    corners_.clear();
                    continue;
                }
                corners_.push_back(whole(corner, "a vertex or -1"));
                const std::size_t length = corners_.size();
                if (length < 3) continue;
                const std::size_t odd = length % 2 == 0 ? 1 : 0;
                const std::array triangle{corners_[length - 3 + odd], corners_[length - 2 - odd],
                                          corners_[length - 1]};
                const auto& [a, b, c] = triangle;
                if (a != b && b != c && c != a && !mesh_.add_face(triangle)) fail(too_many_triangles);
            }
        }
    }

    void pass_over(const Property& property) {
        Index count = 1;
        if (property.count_type != nullptr) count = next_whole(*property.count_type, "the length of a list");
        for (Index i = 0; i < count; ++i) next(*property.type);
    }

    /// Whether \p property of a vertex is a value on the surface: a float that is neither a place, a direction, a
    /// color nor a place on a texture.
    static bool is_scalar(const Property& property) {
        constexpr std::array<std::string_view, 14> others = {"x",  "y",   "z",         "nx",       "ny",
                                                             "nz", "red", "green",     "blue",     "alpha",
                                                             "s",  "t",   "texture_u", "texture_v"};
        return property.count_type == nullptr && property.type->is_float &&
               std::ranges::find(others, property.name) == others.end();
    }

    /// The scalar that receives \p property of the next vertex; null if there is none, or if a vertex lacks it.
    MeshField* scalar_of(const Property& property) {
        if (!is_scalar(property)) return nullptr;
        const auto scalar = std::ranges::find(mesh_.scalars, property.name, &MeshField::name);
        if (scalar != mesh_.scalars.end())
            return scalar->values.size() == mesh_.positions.size() ? &*scalar : nullptr;
        if (!mesh_.positions.empty() || mesh_.scalars.size() == max_mesh_scalars) return nullptr;
        return &mesh_.scalars.emplace_back(MeshField{std::string(property.name), 1, {}});
    }

    void read_vertex(const Element& element) {
        std::array<std::optional<double>, 3> position;
        std::array<std::optional<float>, 3> color;
        constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
        constexpr std::array<std::string_view, 3> channels = {"red", "green", "blue"};
        for (const Property& property : element.properties) {
            const auto* const axis = std::ranges::find(axes, property.name);
            const auto* const channel = std::ranges::find(channels, property.name);
            if (MeshField* const scalar = scalar_of(property)) {
                scalar->values.push_back(next(*property.type));
                continue;
            }
            if (property.count_type != nullptr || (axis == axes.end() && channel == channels.end())) {
                pass_over(property);
                continue;
            }
            const double value = next(*property.type);
            if (axis != axes.end()) {
                position[static_cast<std::size_t>(axis - axes.begin())] = value;
            } else {
                const double most =
                    property.type->is_float ? 1 : std::ldexp(1, 8 * int(property.type->bytes)) - 1;
                color[static_cast<std::size_t>(channel - channels.begin())] =
                    static_cast<float>(value / most);
            }
        }
        if (!position[0] || !position[1] || !position[2]) fail("expected the properties x, y and z");
        if (!mesh_.add_vertex({*position[0], *position[1], *position[2]}, [&] { return place(); }))
            fail(too_many_broken_vertices);
        if (color[0] && color[1] && color[2]) mesh_.colors.emplace_back(*color[0], *color[1], *color[2]);
    }

    void read_face(const Element& element) {
        bool has_corners = false;
        for (const Property& property : element.properties) {
            if (property.count_type == nullptr || !property.name.starts_with("vertex_ind")) {
                pass_over(property);
                continue;
            }
            const Index count = next_whole(*property.count_type, "the number of a face's corners");
            if (count < 3 || count > max_polygon_corners)
                fail(fmt::format("{} corners, expected 3 to {}", count, max_polygon_corners));
            corners_.clear();
            for (Index i = 0; i < count; ++i) corners_.push_back(next_whole(*property.type, "a vertex"));
            if (!mesh_.add_face(corners_)) fail(too_many_triangles);
            has_corners = true;
        }
        if (!has_corners) fail("expected the property list vertex_indices");
    }

    std::string_view name_;
    PlyHeader header_;
    std::string_view rest_;
    bool has_undeclared_ = false;  ///< values
    std::string_view element_;
    std::uint64_t number_ = 0;
    std::vector<Index> corners_;
    PolygonMesh mesh_;
};

/// Reads a text in UTF-16, or with a byte order mark.
PolygonMesh read_converted(std::string_view bytes, std::string_view name) {
    std::vector<std::string> remarks;
    const std::string text = plain_text(std::string(bytes), remarks);
    PolygonMesh mesh = PlyReader(text, name).read();
    mesh.remarks.insert(mesh.remarks.begin(), remarks.begin(), remarks.end());
    return mesh;
}

}  // namespace

SurfaceFile parse_ply(std::string_view bytes, std::string_view name) {
    if (bytes.starts_with("ply")) return surface_of(PlyReader(bytes, name).read(), name);
    return surface_of(read_converted(bytes, name), name);
}

}  // namespace interleaf
