// Progress reports of the measuring of keys for their levels of detail.
#pragma once

#include <functional>

namespace interleaf {

/// Receives the fraction of the work that is done, 0 to 1. It may throw, which ends the work. An empty function
/// is never called.
using DetailProgress = std::function<void(double part)>;

/// Maps the progress of a stage, 0 to 1, to the range from \p begin to \p end of the whole.
/// \param progress  must outlive the returned function
inline DetailProgress detail_part(const DetailProgress& progress, double begin, double end) {
    if (!progress) return {};
    return [&progress, begin, end](double part) { progress(begin + (end - begin) * part); };
}

}  // namespace interleaf
