// The program ffmpeg, run beside this one: reads raw frames from its standard input.
#pragma once

#include <cstdint>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "io/file/file_descriptor.h"

namespace interleaf {

class EncoderProcess {
  public:
    /// Starts ffmpeg with \p arguments, in a process group of its own: an interrupt from the keyboard does not
    /// reach it.
    /// \throw MachineError if there is no ffmpeg, or it cannot be started
    explicit EncoderProcess(const std::vector<std::string>& arguments);
    EncoderProcess(const EncoderProcess&) = delete;
    EncoderProcess& operator=(const EncoderProcess&) = delete;

    /// Kills ffmpeg if it still runs.
    ~EncoderProcess();

    /// Writes to the standard input of ffmpeg, and waits until ffmpeg has taken the bytes.
    /// \return whether ffmpeg took them all; if not, it has ended
    bool write(std::span<const std::uint8_t> bytes);

    /// Ends the input and waits until ffmpeg has ended.
    /// \return whether ffmpeg reports success
    bool finish();

    /// Kills ffmpeg if it still runs, so that write() and finish() return soon. Can be called from another thread.
    void kill();

    /// The last line that ffmpeg has written to its standard error; may be empty.
    std::string last_message() const;

  private:
    FileDescriptor input_;     ///< our end of ffmpeg's standard input
    FileDescriptor messages_;  ///< a file in memory that takes ffmpeg's standard error
    std::mutex mutex_;         ///< held while the process is killed, or forgotten
    int process_ = -1;         ///< until the end of ffmpeg is known
};

}  // namespace interleaf
