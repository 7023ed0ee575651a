#include "app/window/frame_stats.h"

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

FrameStats::FrameStats(const std::filesystem::path& path) : path_(path), file_(path) {
    if (!file_) throw MachineError(fmt::format("{}: cannot be written", path_.string()));
}

void FrameStats::record(std::size_t frame, double time, double milliseconds, std::size_t waits,
                        bool is_late) {
    const bool has_waited = waits != waits_;
    waits_ = waits;
    file_ << fmt::format(
                 "{{\"frame\":{},\"time\":{:.4f},\"milliseconds\":{:.3f},\"waited\":{},\"late\":{}}}\n",
                 frame, time, milliseconds, has_waited, is_late)
          << std::flush;
    if (!file_) throw MachineError(fmt::format("{}: cannot be written", path_.string()));
}

}  // namespace interleaf
