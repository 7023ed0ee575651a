#include "io/vtk/xml_document.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/text/json_place.h"
#include "io/text/words.h"
#include "text/characters.h"
#include "text/parsed_number.h"

namespace interleaf {
namespace {

/// A tag of 4 bytes takes 60 bytes of memory, hence a limit.
constexpr std::ptrdiff_t max_tags = 1'000'000;

constexpr std::string_view appended_tag = "<AppendedData";

/// The bytes that the blocks of a file of \p size bytes may hold: as much as the file, unless compressed.
std::size_t block_budget(std::size_t size, bool is_compressed) {
    return is_compressed ? 64 * size + (std::size_t{16} << 20U) : size;
}

}  // namespace

XmlDocument::XmlDocument(std::string text, std::string file)
    : text_(std::move(text)), file_(std::move(file)) {
    const std::size_t size = text_.size();
    cut_off_appended_data();
    parse();
    read_format();
    budget_.bytes = block_budget(size, format_.is_compressed);
}

void XmlDocument::fail(std::string_view what) const {
    throw InputError(fmt::format("{}: {}", file_, what));
}

/// Raw bytes are no XML. So the parser gets the text in front of the appended data, and the end of the root.
void XmlDocument::cut_off_appended_data() {
    const std::size_t tag = text_.find(appended_tag);
    if (tag == std::string::npos) return;
    const std::size_t end = text_.find('>', tag);
    const std::size_t mark = text_.find_first_not_of(" \t\r\n", std::min(end, text_.size() - 1) + 1);
    if (end == std::string::npos || mark == std::string::npos || text_[mark] != '_')
        fail("AppendedData: expected an underscore before the data");
    const std::string_view attributes = std::string_view(text_).substr(tag, end - tag);
    if (attributes.find("raw") != std::string_view::npos) appended_form_ = EncodedBytes::Form::raw;
    appended_ = text_.substr(mark + 1);
    text_.resize(tag);
    text_ += "</VTKFile>";
    text_.shrink_to_fit();
}

void XmlDocument::parse() {
    if (std::ranges::count_if(text_, [](char c) { return c == '<' || c == '"' || c == '\''; }) > max_tags)
        fail("expected at most a million tags and attributes");
    constexpr unsigned options = pugi::parse_escapes | pugi::parse_wconv_attribute;
    const pugi::xml_parse_result result =
        document_.load_buffer_inplace(text_.data(), text_.size(), options, pugi::encoding_utf8);
    root_ = document_.child("VTKFile");
    if (!root_) fail("expected a VTK file, with <VTKFile> at its beginning");
    if (!result) fail(fmt::format("byte {}: damaged XML: {}", result.offset, result.description()));
}

void XmlDocument::read_format() {
    format_.is_big_endian = std::string_view(root_.attribute("byte_order").value()) == "BigEndian";
    format_.has_wide_headers = std::string_view(root_.attribute("header_type").value()) == "UInt64";
    const std::string_view compressor = root_.attribute("compressor").value();
    format_.is_compressed = !compressor.empty();
    if (format_.is_compressed && compressor != "vtkZLibDataCompressor")
        fail(fmt::format("compressed by {}, expected vtkZLibDataCompressor", in_quotes(compressor)));
}

std::size_t XmlDocument::count(const pugi::xml_node& node, const char* attribute,
                               std::optional<std::size_t> fallback) const {
    // Some programs write numbers of a fixed width into attributes.
    const std::string_view value = without_blanks(node.attribute(attribute).value());
    if (value.empty() && fallback) return *fallback;
    const auto number = parsed_number<std::uint32_t>(value);
    if (!number || *number >= no_index)
        fail(fmt::format("{}: {}: {}, expected a whole number in [0, 2^32 - 2]", node.name(), attribute,
                         in_quotes(value)));
    return *number;
}

NumberArray XmlDocument::numbers(const pugi::xml_node& array, const ArrayPlace& place) {
    const auto type = xml_data_type(array.attribute("type").value());
    if (!type)
        place.fail(fmt::format("type {}, expected one such as Float32 or Int64",
                               in_quotes(array.attribute("type").value())));
    std::string_view format = without_blanks(array.attribute("format").value());
    if (format.empty()) format = array.attribute("offset") ? "appended" : "ascii";
    const std::string_view text = array.text().get();
    if (is_word(format, "ascii")) {
        Words words(text);
        return read_words(words, *type, place);
    }
    if (is_word(format, "binary"))
        return read_block(EncodedBytes(text, EncodedBytes::Form::base64), *type, format_, place, budget_);
    if (is_word(format, "appended"))
        return read_block(appended_at(array.attribute("offset").value(), place), *type, format_, place,
                          budget_);
    place.fail(fmt::format("format {}, expected ascii, binary or appended", in_quotes(format)));
}

EncodedBytes XmlDocument::appended_at(std::string_view offset, const ArrayPlace& place) const {
    const auto number = parsed_number<std::uint64_t>(without_blanks(offset));
    if (!number || *number > appended_.size())
        place.fail(fmt::format("offset {}, expected one in the {} bytes of the appended data",
                               in_quotes(offset), appended_.size()));
    return {std::string_view(appended_).substr(*number), appended_form_};
}

}  // namespace interleaf
