// The header of a PLY file, which declares elements and their properties.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace interleaf {

/// Refers to the bytes of the file.
struct PlyHeader {
    struct Type {
        std::string_view name;
        std::string_view other_name;
        std::size_t bytes;
        bool is_signed;
        bool is_float;
    };

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

    Form form = Form::text;  ///< of the values
    std::vector<Element> elements;
    std::string_view values;           ///< what follows the header
    std::string_view unknown_line;     ///< a line that was ignored; empty if there is none
    std::vector<std::string> remarks;  ///< one per such line
};

/// \param name  of the file, for messages
/// \throw InputError
PlyHeader read_ply_header(std::string_view bytes, std::string_view name);

}  // namespace interleaf
