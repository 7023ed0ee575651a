// Waits for curves that are measured on a thread.
#pragma once

#include <chrono>
#include <thread>

#include <doctest/doctest.h>

namespace interleaf::testing {

/// The curves of \p history when its work is done.
template <typename History>
auto measured(History& history) {
    for (int i = 0; i < 1000 && history.is_working(); ++i) {
        history.curves();
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
    }
    REQUIRE_FALSE(history.is_working());
    return history.curves();
}

}  // namespace interleaf::testing
