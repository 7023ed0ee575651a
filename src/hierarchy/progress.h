// Progress reports of long work, and its cancellation.
#pragma once

#include <algorithm>
#include <exception>
#include <functional>
#include <string_view>

namespace interleaf {

/// Receives the progress of long work: the stage, and the fraction of the whole that is done, 0 to 1. Returns
/// false to cancel. An empty function is never called.
using Progress = std::function<bool(std::string_view stage, double part)>;

/// Maps the progress of a stage, 0 to 1, to the range from \p begin to \p end of the whole.
/// \param progress  must outlive the returned function
inline Progress part_of(const Progress& progress, double begin, double end) {
    if (!progress) return {};
    return [&progress, begin, end](std::string_view stage, double part) {
        return progress(stage, begin + (end - begin) * std::clamp(part, 0.0, 1.0));
    };
}

/// Thrown when progress returns false. At most about 50 ms of work lie between two calls.
struct Cancelled : std::exception {
    const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace interleaf
