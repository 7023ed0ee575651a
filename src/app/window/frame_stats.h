// The duration of every frame, for measurements of playback: a file that receives one JSON line per frame.
#pragma once

#include <cstddef>
#include <filesystem>
#include <fstream>

namespace interleaf {

class FrameStats {
  public:
    /// \throw MachineError if the file cannot be written
    explicit FrameStats(const std::filesystem::path& path);

    /// Writes {"frame", "time", "milliseconds", "waited", "late"}.
    /// \param time          begin of the frame, seconds since the program was ready
    /// \param milliseconds  duration of the frame
    /// \param waits         number of unions so far that were not made ahead
    /// \param is_late       whether the frame shows the last picture, because a union is missing
    /// \throw MachineError if the file cannot be written
    void record(std::size_t frame, double time, double milliseconds, std::size_t waits, bool is_late);

  private:
    std::filesystem::path path_;
    std::ofstream file_;
    std::size_t waits_ = 0;  ///< at the last record
};

}  // namespace interleaf
