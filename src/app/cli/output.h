// Where a command writes what it made: a file, written whole or not at all, or standard output.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

namespace interleaf {

struct Output {
    std::string target;  ///< a file, or "-" for standard output
    std::string format;  ///< empty to go by the extension of the target
};

/// The format of \p output, one of \p known: named outright, or the extension of the file.
/// \throw UsageError when it is neither
std::string_view format_of(const Output& output, std::span<const std::string_view> known);

/// \throw MachineError when it cannot be written
void write_output(const Output& output, std::span<const std::byte> bytes);
void write_output(const Output& output, std::string_view text);

}  // namespace interleaf
