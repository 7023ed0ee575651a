// Runs the interleaf program as a shell would, without a display, and keeps what it says.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "messages.h"

namespace interleaf {

struct Surroundings {
    std::optional<std::filesystem::path> standard_output;  ///< a file or device that gets it
    std::optional<std::size_t> max_file_size;              ///< bytes; writing more fails as on a full disk
    std::optional<std::string> display;                    ///< value of DISPLAY
};

struct Outcome {
    int status = -1;  ///< exit status; -1 when a signal ended it
    std::string output;
    std::string errors;
};

/// Runs interleaf with \p arguments until it ends.
Outcome run_interleaf(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

/// Whether \p text has exactly one line, and it begins with "interleaf: ".
bool is_one_message(const std::string& text);

}  // namespace interleaf
