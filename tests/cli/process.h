// Runs the interleaf program as a shell does, without a display, and captures its output.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "messages.h"

namespace interleaf {

struct Surroundings {
    std::optional<std::filesystem::path> standard_output;  ///< a file or device that receives the output
    std::optional<std::size_t> max_file_size;              ///< bytes; writing more fails as on a full disk
    std::optional<std::string> display;                    ///< value of DISPLAY
};

struct Outcome {
    int status = -1;  ///< exit status; -1 if a signal ended the program
    std::string output;
    std::string errors;
};

/// Runs interleaf with \p arguments until it ends.
Outcome run_interleaf(const std::vector<std::string>& arguments, const Surroundings& surroundings = {});

/// Whether \p text is exactly one line that begins with "interleaf: ".
bool is_one_message(const std::string& text);

}  // namespace interleaf
