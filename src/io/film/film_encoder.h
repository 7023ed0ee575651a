// Encodes a film: passes raw frames to the program ffmpeg, which runs beside this one, so that drawing and
// encoding overlap. The film replaces its target whole or not at all.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "io/file/safe_write.h"
#include "io/film/encoder_process.h"

namespace interleaf {

struct FilmFormat {
    std::string_view extension;  ///< ".mp4", in lower case
    std::string_view title;      ///< "H.264 film"
    bool has_even_sides;         ///< whether width and height must be even
    double max_rate;             ///< frames per second that its players keep up with
};

/// All formats of films.
std::span<const FilmFormat> film_formats();

/// The format with \p extension, such as ".mp4", in lower case; null if there is none.
const FilmFormat* film_format_with_extension(std::string_view extension);

struct FilmPicture {
    int width;    ///< pixels
    int height;   ///< pixels
    double rate;  ///< frames per second
};

/// \throw UsageError if \p format cannot hold a film of such pictures
void require_encodable(const FilmFormat& format, const FilmPicture& picture);

class FilmEncoder {
  public:
    /// Starts ffmpeg.
    /// \throw UsageError    as require_encodable()
    /// \throw MachineError  if there is no ffmpeg, or the target cannot be written
    FilmEncoder(const std::filesystem::path& file, const FilmFormat& format, const FilmPicture& picture);
    FilmEncoder(const FilmEncoder&) = delete;
    FilmEncoder& operator=(const FilmEncoder&) = delete;

    /// Ends ffmpeg. Without finish(), the target stays as it was.
    ~FilmEncoder();

    /// Whether add() would not wait.
    bool takes_frames();

    /// Appends a frame. Waits while several frames are on their way to ffmpeg.
    /// \param rgba  8 bits per channel, top row first
    /// \throw MachineError with the message of ffmpeg, if it has failed
    void add(std::vector<std::uint8_t> rgba);

    /// Waits until ffmpeg has written all frames, and moves the film to its place.
    /// \throw MachineError as add(), or if the film cannot be moved there
    /// \throw Cancelled    after cancel()
    void finish();

    /// Ends ffmpeg, so that a finish() in progress on another thread returns soon. The target stays as it was,
    /// unless the film is moved there just now.
    void cancel();

  private:
    void pass_frames_on();
    void end_frames();
    [[noreturn]] void throw_failure() const;

    std::filesystem::path file_;
    FileReplacement film_;
    EncoderProcess process_;

    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<std::vector<std::uint8_t>> waiting_;  ///< frames that the thread has not taken yet
    bool is_complete_ = false;                       ///< whether no frame follows
    bool is_cancelled_ = false;                      ///< whether the film is not wanted any more
    bool is_broken_ = false;                         ///< whether ffmpeg takes no more frames
    std::thread thread_;                             ///< passes the frames on
};

}  // namespace interleaf
