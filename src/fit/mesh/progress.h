// How long work tells how far it is, and how it is told to stop.
#pragma once

#include <algorithm>
#include <exception>
#include <functional>
#include <string_view>

namespace interleaf {

/// Told how far long work is: the stage and the part of the whole that is done, 0 to 1. Returns false to
/// cancel. An empty one is never asked.
using Progress = std::function<bool(std::string_view stage, double part)>;

/// Reports what a stage reports as the part of the whole from \p begin to \p end.
/// \param progress  outlives the returned one
inline Progress part_of(const Progress& progress, double begin, double end) {
    if (!progress) return {};
    return [&progress, begin, end](std::string_view stage, double part) {
        return progress(stage, begin + (end - begin) * std::clamp(part, 0.0, 1.0));
    };
}

/// Thrown when progress returns false; at most about 50 ms of work lie between two calls.
struct Cancelled : std::exception {
    const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace interleaf
