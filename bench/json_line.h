// The output of a benchmark program: one JSON object on one line.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdio>

#include <nlohmann/json.hpp>

namespace interleaf::bench {

/// Prints \p figures on a line of their own.
inline void print_line(const nlohmann::ordered_json& figures) {
    std::puts(figures.dump().c_str());
}

/// Seconds that \p work takes.
template <typename Work>
double seconds_of(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The minimum over \p runs runs, because other work on the machine only adds to the time.
template <typename Work>
double min_seconds_of(int runs, Work&& work) {
    double least = seconds_of(work);
    for (int run = 1; run < runs; ++run) least = std::min(least, seconds_of(work));
    return least;
}

}  // namespace interleaf::bench
