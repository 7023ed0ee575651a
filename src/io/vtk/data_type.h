// Types of the numbers in VTK files, by the names that the XML formats and the legacy format have for them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

namespace interleaf {

enum class DataType : std::uint8_t {
    int8,
    uint8,
    int16,
    uint16,
    int32,
    uint32,
    int64,
    uint64,
    float32,
    float64
};

/// The type that XML files call \p name: "Float32". None if there is no such type of numbers.
std::optional<DataType> xml_data_type(std::string_view name);

/// The type that legacy files call \p name, in lower case: "float", "vtkidtype". A vtkIdType has 4 bytes there,
/// a long has 8. None if there is no such type of numbers.
std::optional<DataType> legacy_data_type(std::string_view name);

/// "Float32".
std::string_view name_of(DataType type);

/// Calls \p action with a zero of \p type, and returns its result.
template <typename Action>
auto with_zero(DataType type, Action action) {
    switch (type) {
        case DataType::int8:
            return action(std::int8_t{});
        case DataType::uint8:
            return action(std::uint8_t{});
        case DataType::int16:
            return action(std::int16_t{});
        case DataType::uint16:
            return action(std::uint16_t{});
        case DataType::int32:
            return action(std::int32_t{});
        case DataType::uint32:
            return action(std::uint32_t{});
        case DataType::int64:
            return action(std::int64_t{});
        case DataType::uint64:
            return action(std::uint64_t{});
        case DataType::float32:
            return action(float{});
        case DataType::float64:
            break;
    }
    return action(double{});
}

/// Bytes per number.
inline std::size_t size_of(DataType type) {
    return with_zero(type, [](auto zero) { return sizeof zero; });
}

}  // namespace interleaf
