#include "io/vtk/data_type.h"

#include <algorithm>
#include <array>
#include <span>

namespace interleaf {
namespace {

struct NamedType {
    std::string_view name;
    DataType type;
};

/// In the order of the enumerators.
constexpr std::array<NamedType, 10> xml_types = {{
    {"Int8", DataType::int8},
    {"UInt8", DataType::uint8},
    {"Int16", DataType::int16},
    {"UInt16", DataType::uint16},
    {"Int32", DataType::int32},
    {"UInt32", DataType::uint32},
    {"Int64", DataType::int64},
    {"UInt64", DataType::uint64},
    {"Float32", DataType::float32},
    {"Float64", DataType::float64},
}};

constexpr std::array<NamedType, 16> legacy_types = {{
    {"char", DataType::int8},
    {"signed_char", DataType::int8},
    {"unsigned_char", DataType::uint8},
    {"short", DataType::int16},
    {"unsigned_short", DataType::uint16},
    {"int", DataType::int32},
    {"unsigned_int", DataType::uint32},
    {"long", DataType::int64},
    {"unsigned_long", DataType::uint64},
    {"vtkidtype", DataType::int32},
    {"vtktypeint32", DataType::int32},
    {"vtktypeuint32", DataType::uint32},
    {"vtktypeint64", DataType::int64},
    {"vtktypeuint64", DataType::uint64},
    {"float", DataType::float32},
    {"double", DataType::float64},
}};

std::optional<DataType> find_type(std::span<const NamedType> types, std::string_view name) {
    const auto found = std::ranges::find(types, name, &NamedType::name);
    if (found == types.end()) return std::nullopt;
    return found->type;
}

}  // namespace

std::optional<DataType> xml_data_type(std::string_view name) {
    return find_type(xml_types, name);
}

std::optional<DataType> legacy_data_type(std::string_view name) {
    return find_type(legacy_types, name);
}

std::string_view name_of(DataType type) {
    return xml_types.at(static_cast<std::size_t>(type)).name;
}

}  // namespace interleaf
