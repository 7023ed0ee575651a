// The Polygon File Format of Stanford: a header that declares elements and their properties, then the
// elements' values as text or binary. Vertices (x, y, z; red, green, blue where there are) and faces are
// read, other elements and properties are passed over.
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/json_place.h"
#include "io/surface_file.h"
#include "io/words.h"

namespace interleaf {
namespace {

struct Type {
    std::string_view name;
    std::string_view other_name;
    std::size_t bytes;
    bool is_signed;
    bool is_float;
};

constexpr std::array<Type, 8> types = {{{"char", "int8", 1, true, false},
                                        {"uchar", "uint8", 1, false, false},
                                        {"short", "int16", 2, true, false},
                                        {"ushort", "uint16", 2, false, false},
                                        {"int", "int32", 4, true, false},
                                        {"uint", "uint32", 4, false, false},
                                        {"float", "float32", 4, true, true},
                                        {"double", "float64", 8, true, true}}};

struct Property {
    std::string_view name;
    const Type* type;
    const Type* count_type;  ///< of a list; nullptr for one value
};

struct Element {
    std::string_view name;
    std::uint64_t count;
    std::vector<Property> properties;
};

enum class Form { text, little_endian, big_endian };

class PlyReader {
  public:
    PlyReader(std::string_view bytes, std::string_view name) : rest_(bytes), name_(name) {}

    SurfaceFile read() {
        read_header();
        for (const Element& element : elements_) {
            if (element.properties.empty()) continue;  // takes no place
            for (number_ = 0; number_ < element.count; ++number_) {
                element_ = element.name;
                if (element.name == "vertex")
                    read_vertex(element);
                else if (element.name == "face")
                    read_face(element);
                else
                    for (const Property& property : element.properties) pass_over(property);
            }
        }
        if (surface_.triangles.empty())
            throw InputError(fmt::format("{}: has no faces, expected some", name_));
        if (surface_.colors.size() != surface_.positions.size()) surface_.colors.clear();
        for (const Triangle& triangle : surface_.triangles)
            for (const Index vertex : triangle)
                if (vertex >= surface_.positions.size())
                    throw InputError(fmt::format("{}: a face has vertex {}, there are {}, counted from 0",
                                                 name_, vertex, surface_.positions.size()));
        return std::move(surface_);
    }

  private:
    [[noreturn]] void fail_in_header(std::string_view what) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line_number_, what));
    }
    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: {} {} (counted from 0): {}", name_, element_, number_, what));
    }

    static const Type* find_type(std::string_view name) {
        const auto* const found = std::ranges::find_if(
            types, [name](const Type& type) { return type.name == name || type.other_name == name; });
        return found == types.end() ? nullptr : found;
    }

    void read_header() {
        bool has_format = false;
        for (line_number_ = 1;; ++line_number_) {
            if (rest_.empty()) fail_in_header("the file ends, expected end_header");
            std::string_view line = take_line(rest_);
            const std::string_view keyword = take_word(line);
            if (line_number_ == 1) {
                if (keyword != "ply") fail_in_header("expected ply");
            } else if (keyword == "format") {
                read_format(take_word(line));
                has_format = true;
            } else if (keyword == "element") {
                read_element(line);
            } else if (keyword == "property") {
                read_property(line);
            } else if (keyword == "end_header") {
                break;
            } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
                fail_in_header(fmt::format("{} found, expected format, element, property or end_header",
                                           in_quotes(keyword)));
            }
        }
        if (!has_format) fail_in_header("the header ends, expected a format in it");
    }

    void read_format(std::string_view word) {
        if (word == "ascii")
            form_ = Form::text;
        else if (word == "binary_little_endian")
            form_ = Form::little_endian;
        else if (word == "binary_big_endian")
            form_ = Form::big_endian;
        else
            fail_in_header(fmt::format("format {}, expected ascii, binary_little_endian or binary_big_endian",
                                       in_quotes(word)));
    }

    void read_element(std::string_view line) {
        const std::string_view name = take_word(line);
        const std::string_view word = take_word(line);
        std::uint64_t count = 0;
        if (name.empty() || parse_word(word, count) != std::errc())
            fail_in_header(fmt::format("{} found, expected an element's name and count", in_quotes(word)));
        elements_.push_back({name, count, {}});
    }

    void read_property(std::string_view line) {
        if (elements_.empty()) fail_in_header("a property, expected an element before it");
        const auto take_type = [&] {
            const std::string_view word = take_word(line);
            const Type* type = find_type(word);
            if (type == nullptr) fail_in_header(fmt::format("{} is not a type", in_quotes(word)));
            return type;
        };
        Property property{};
        std::string_view rest = line;
        if (take_word(rest) == "list") {
            line = rest;
            property.count_type = take_type();
        }
        property.type = take_type();
        property.name = take_word(line);
        elements_.back().properties.push_back(property);
    }

    /// The next word of the text, whatever lines it is on.
    std::string_view next_word() {
        constexpr std::string_view spaces = " \t\r\n";
        rest_.remove_prefix(std::min(rest_.find_first_not_of(spaces), rest_.size()));
        const std::string_view word = rest_.substr(0, rest_.find_first_of(spaces));
        if (word.empty()) fail("the file ends within it");
        rest_.remove_prefix(word.size());
        return word;
    }

    /// The next value, in double, which holds every type's values.
    double next(const Type& type) {
        if (form_ == Form::text) {
            const std::string_view word = next_word();
            const std::optional<double> number = parse_double(word);
            if (!number) fail(fmt::format("{} found, expected a finite number", in_quotes(word)));
            return *number;
        }
        if (rest_.size() < type.bytes) fail("the file ends within it");
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < type.bytes; ++i) {
            const std::size_t place = form_ == Form::little_endian ? i : type.bytes - 1 - i;
            bits |= std::uint64_t{static_cast<unsigned char>(rest_[place])} << (8 * i);
        }
        rest_.remove_prefix(type.bytes);
        if (type.is_float && type.bytes == 8) return std::bit_cast<double>(bits);
        if (type.is_float) return std::bit_cast<float>(static_cast<std::uint32_t>(bits));
        const std::uint64_t sign = std::uint64_t{1} << (8 * type.bytes - 1);
        const auto value = static_cast<double>(bits);
        return type.is_signed && (bits & sign) != 0 ? value - 2 * static_cast<double>(sign) : value;
    }

    Index next_whole(const Type& type, std::string_view expected) {
        const double number = next(type);
        if (!(number >= 0 && number < double(no_index) && number == std::floor(number)))
            fail(fmt::format("{} found, expected {}", number, expected));
        return static_cast<Index>(number);
    }

    void pass_over(const Property& property) {
        Index count = 1;
        if (property.count_type != nullptr) count = next_whole(*property.count_type, "the length of a list");
        for (Index i = 0; i < count; ++i) next(*property.type);
    }

    void read_vertex(const Element& element) {
        std::array<std::optional<double>, 3> position;
        std::array<std::optional<float>, 3> color;
        constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
        constexpr std::array<std::string_view, 3> channels = {"red", "green", "blue"};
        for (const Property& property : element.properties) {
            const auto* const axis = std::ranges::find(axes, property.name);
            const auto* const channel = std::ranges::find(channels, property.name);
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
                if (!(value >= 0 && value <= most))
                    fail(fmt::format("a colour of {}, expected 0 to {}", value, most));
                color[static_cast<std::size_t>(channel - channels.begin())] =
                    static_cast<float>(value / most);
            }
        }
        if (!position[0] || !position[1] || !position[2]) fail("expected the properties x, y and z");
        for (const std::optional<double>& coordinate : position)
            if (!std::isfinite(*coordinate)) fail("a coordinate is not a finite number");
        surface_.positions.emplace_back(*position[0], *position[1], *position[2]);
        if (color[0] && color[1] && color[2]) surface_.colors.emplace_back(*color[0], *color[1], *color[2]);
    }

    void read_face(const Element& element) {
        bool has_corners = false;
        for (const Property& property : element.properties) {
            if (property.count_type == nullptr || !property.name.starts_with("vertex_ind")) {
                pass_over(property);
                continue;
            }
            const Index count = next_whole(*property.count_type, "the number of a face's corners");
            if (count < 3 || count > most_polygon_corners)
                fail(fmt::format("{} corners, expected 3 to {}", count, most_polygon_corners));
            corners_.clear();
            for (Index i = 0; i < count; ++i) corners_.push_back(next_whole(*property.type, "a vertex"));
            append_fan(surface_.triangles, corners_);
            has_corners = true;
        }
        if (!has_corners) fail("expected the property list vertex_indices");
    }

    std::string_view rest_;
    std::string_view name_;
    std::size_t line_number_ = 0;
    Form form_ = Form::text;
    std::vector<Element> elements_;
    std::string_view element_;
    std::uint64_t number_ = 0;
    std::vector<Index> corners_;
    SurfaceFile surface_;
};

}  // namespace

SurfaceFile parse_ply(std::string_view bytes, std::string_view name) {
    return PlyReader(bytes, name).read();
}

}  // namespace interleaf
