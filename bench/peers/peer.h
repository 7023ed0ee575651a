// What the peers that bisect the icosahedron have in common: its triangles, and how they measure time and
// memory.
#pragma once

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>

#include <unistd.h>

namespace interleaf::bench {

using Clock = std::chrono::steady_clock;

inline constexpr int root_count = 20;

/// As in src/shapes/icosahedron.cpp: the refinement edge is opposite the first corner.
inline constexpr int roots[root_count][3] = {{8, 0, 2},  {9, 2, 0},  {6, 0, 4},  {8, 4, 0},  {0, 6, 9},
                                             {10, 3, 1}, {11, 1, 3}, {4, 1, 6},  {1, 4, 10}, {11, 6, 1},
                                             {5, 2, 7},  {2, 5, 8},  {9, 7, 2},  {7, 3, 5},  {10, 5, 3},
                                             {3, 7, 11}, {8, 10, 4}, {10, 8, 5}, {11, 9, 6}, {9, 11, 7}};

/// Ends the program \p program with 1: the mesh is not what it has to be.
[[noreturn]] inline void fail(const char* program, const char* what) {
    std::fprintf(stderr, "%s: %s\n", program, what);
    std::exit(1);
}

inline double seconds_since(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Bytes of this process that lie in memory now.
inline double resident_bytes() {
    double total = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> total >> resident;
    return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

}  // namespace interleaf::bench
