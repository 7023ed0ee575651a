#include "io/mesh/ply_header.h"

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/text/json_place.h"
#include "io/text/plain_text.h"
#include "io/text/words.h"
#include "text/parsed_number.h"

namespace interleaf {
namespace {

constexpr std::array<PlyHeader::Type, 8> ply_types = {{{"char", "int8", 1, true, false},
                                                       {"uchar", "uint8", 1, false, false},
                                                       {"short", "int16", 2, true, false},
                                                       {"ushort", "uint16", 2, false, false},
                                                       {"int", "int32", 4, true, false},
                                                       {"uint", "uint32", 4, false, false},
                                                       {"float", "float32", 4, true, true},
                                                       {"double", "float64", 8, true, true}}};

const PlyHeader::Type* find_ply_type(std::string_view name) {
    const auto* const found = std::ranges::find_if(ply_types, [name](const PlyHeader::Type& type) {
        return type.name == name || type.other_name == name;
    });
    return found == ply_types.end() ? nullptr : found;
}

class PlyHeaderReader {
  public:
    PlyHeaderReader(std::string_view bytes, std::string_view name)
        : whole_(bytes), rest_(bytes), name_(name) {}

    PlyHeader read() {
        bool has_format = false;
        for (line_number_ = 1;; ++line_number_) {
            if (rest_.empty()) fail("the file ends, expected end_header");
            std::string_view line = take_header_line();
            const std::string_view whole = line;
            const std::string_view keyword = take_word(line);
            if (line_number_ == 1) {
                if (keyword != "ply") fail("expected ply");
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
                if (!looks_like_text(whole)) fail("is not text, expected end_header before");
                header_.unknown_line = whole;
                header_.remarks.push_back(
                    fmt::format("Line {} of the header, {}, was ignored.", line_number_, in_quotes(whole)));
                constexpr std::size_t max_unknown_lines = 100;
                if (header_.remarks.size() > max_unknown_lines)
                    fail("expected format, element, property or end_header");
            }
        }
        if (!has_format) fail("the header ends, expected a format in it");
        header_.values = rest_;
        return std::move(header_);
    }

  private:
    using Type = PlyHeader::Type;
    using Property = PlyHeader::Property;
    using Form = PlyHeader::Form;

    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: line {}: {}", name_, line_number_, what));
    }

    /// The next line of the header. All lines end like the first one, so that it is clear which bytes follow
    /// the last one.
    std::string_view take_header_line() {
        const std::size_t first_end = whole_.find_first_of("\r\n");
        if (first_end == std::string_view::npos || whole_[first_end] == '\n' ||
            (first_end + 1 < whole_.size() && whole_[first_end + 1] == '\n'))
            return take_line(rest_);
        const std::string_view line = rest_.substr(0, rest_.find('\r'));
        rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
        return line;
    }

    void read_format(std::string_view word) {
        if (word == "ascii")
            header_.form = Form::text;
        else if (word == "binary_little_endian")
            header_.form = Form::little_endian;
        else if (word == "binary_big_endian")
            header_.form = Form::big_endian;
        else
            fail(fmt::format("format {}, expected ascii, binary_little_endian or binary_big_endian",
                             in_quotes(word)));
    }

    void read_element(std::string_view line) {
        const std::string_view name = take_word(line);
        const std::string_view word = take_word(line);
        std::uint64_t count = 0;
        if (name.empty() || parse_all(word, count) != std::errc())
            fail(fmt::format("{} found, expected an element's name and count", in_quotes(word)));
        constexpr std::size_t max_elements = 1000;
        if (header_.elements.size() == max_elements) fail("more than 1000 elements");
        header_.elements.push_back({name, count, {}});
    }

    void read_property(std::string_view line) {
        if (header_.elements.empty()) fail("a property, expected an element before it");
        const auto take_type = [&] {
            const std::string_view word = take_word(line);
            const Type* type = find_ply_type(word);
            if (type == nullptr) fail(fmt::format("{} is not a type", in_quotes(word)));
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
        header_.elements.back().properties.push_back(property);
    }

    std::string_view whole_;
    std::string_view rest_;
    std::string_view name_;
    std::size_t line_number_ = 0;
    PlyHeader header_;
};

}  // namespace

PlyHeader read_ply_header(std::string_view bytes, std::string_view name) {
    return PlyHeaderReader(bytes, name).read();
}

}  // namespace interleaf
