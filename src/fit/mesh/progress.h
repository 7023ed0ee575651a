// How long work tells how far it is, and how it is told to stop.
#pragma once

#include <exception>
#include <functional>
#include <string_view>

namespace interleaf {

/// Told how far long work is: the stage and the part of the whole that is done, 0 to 1. Returns false to
/// cancel. An empty one is never asked.
using Progress = std::function<bool(std::string_view stage, double part)>;

/// Thrown when progress returns false; at most about 50 ms of work lie between two calls.
struct Cancelled : std::exception {
    const char* what() const noexcept override { return "cancelled"; }
};

}  // namespace interleaf
