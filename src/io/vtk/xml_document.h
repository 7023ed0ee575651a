// The XML of a VTK file, and the arrays in it: as words, as inline base 64, or in the data appended to the XML.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include <pugixml.hpp>

#include "io/vtk/data_block.h"
#include "io/vtk/number_array.h"

namespace interleaf {

class XmlDocument {
  public:
    /// Parses \p text, the content of the file that messages call \p file.
    /// \throw InputError if it is no XML of VTK, or if it has more than a million tags and attributes
    XmlDocument(std::string text, std::string file);
    XmlDocument(const XmlDocument&) = delete;
    XmlDocument& operator=(const XmlDocument&) = delete;

    const std::string& file() const { return file_; }

    /// The type of the data set, such as "UnstructuredGrid".
    std::string_view type() const { return root_.attribute("type").value(); }

    /// The element with the name of the type, in the root.
    pugi::xml_node data_set() const { return root_.child(root_.attribute("type").value()); }

    /// The whole number in [0, 2^32 - 2] that \p attribute of \p node is.
    /// \throw InputError if it is none, or if it is missing and there is no \p fallback
    std::size_t count(const pugi::xml_node& node, const char* attribute,
                      std::optional<std::size_t> fallback = {}) const;

    /// The numbers of the element \p array, a DataArray. Without a format they are words, or appended where the array
    /// has an offset, as VTK reads them.
    /// \throw InputError naming \p place, as read_words() and read_block(), and if the array has a type, format
    ///                   or place that is none
    NumberArray numbers(const pugi::xml_node& array, const ArrayPlace& place);

    [[noreturn]] void fail(std::string_view what) const;

  private:
    void cut_off_appended_data();
    void parse();
    void read_format();
    EncodedBytes appended_at(std::string_view offset, const ArrayPlace& place) const;

    std::string text_;
    std::string file_;
    std::string appended_;
    EncodedBytes::Form appended_form_ = EncodedBytes::Form::base64;
    pugi::xml_document document_;
    pugi::xml_node root_;
    BlockFormat format_;
    BlockBudget budget_;
};

}  // namespace interleaf
