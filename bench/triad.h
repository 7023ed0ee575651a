// The triad of STREAM (J. D. McCalpin, 1995): the speed of memory that other figures are compared with.
#pragma once

#include <algorithm>
#include <cstddef>

#include "json_line.h"

#include "hierarchy/buffer.h"

namespace interleaf::bench {

/// Bytes per second of a = b + factor * c, counted as in STREAM, over arrays of \p count floats in total. The
/// minimum over \p runs runs counts.
inline double triad_rate(std::size_t count, int runs) {
    Buffer<float> a(count / 3), b(count / 3, 1.0F), c(count / 3, 2.0F);
    std::fill(a.begin(), a.end(), 0.0F);
    const double seconds = min_seconds_of(runs, [&] {
        for (std::size_t n = 0; n < a.size(); ++n) a[n] = b[n] + 3.0F * c[n];
    });
    return a.back() == 7.0F ? 3 * sizeof(float) * static_cast<double>(a.size()) / seconds : 0;
}

}  // namespace interleaf::bench
