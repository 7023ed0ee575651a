// The speed of memory, from which bench/run computes the bounds of refinement and coarsening: the triad of
// STREAM beyond the caches, and the first touch of new pages, which the kernel clears. Prints one line of
// JSON.
#include <algorithm>
#include <cstddef>

#include "json_line.h"
#include "triad.h"

#include "hierarchy/large_memory.h"

namespace {

using namespace interleaf;

constexpr int runs = 5;
constexpr std::size_t triad_floats = 120'000'000;  // 480 MB, larger than any cache
constexpr std::size_t fresh_bytes = std::size_t{256} << 20;

/// Bytes per second at which new pages become usable. Touches them as an array of a mesh does: in large
/// blocks, with huge pages where the machine has them.
double fresh_rate() {
    double least = 1e300;
    for (int run = 0; run < runs; ++run) {
        void* const memory = allocate_memory(fresh_bytes);
        const double seconds = bench::seconds_of([&] {
            for (std::size_t place = 0; place < fresh_bytes; place += 4096)
                static_cast<volatile char*>(memory)[place] = 1;
        });
        free_memory(memory, fresh_bytes);
        least = std::min(least, seconds);
    }
    return fresh_bytes / least;
}

}  // namespace

int main() {
    bench::print_line({{"triad_bytes_per_second", bench::triad_rate(triad_floats, runs)},
                       {"fresh_bytes_per_second", fresh_rate()}});
    return 0;
}
