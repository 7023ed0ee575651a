// A message to the user in front of the window. A fault stays until the user dismisses it. A notice
// disappears by itself.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "family/synchronize_keys.h"

namespace interleaf {

enum class MessageKind : std::uint8_t {
    fault,   ///< an error, or a request to act
    notice,  ///< information
};

/// What a button in a notice leads to.
enum class MessageOffer : std::uint8_t {
    none,
    landmarks,  ///< the landmark window
    timeline,   ///< a time for the selected key
};

struct Message {
    std::string text;                                          ///< empty for no message
    std::shared_ptr<const MismatchedKeys> mismatch = nullptr;  ///< keys to show with it; null for none
    MessageKind kind = MessageKind::fault;
    MessageOffer offer = MessageOffer::none;  ///< of a notice
    double seen = 0;                          ///< when a notice appeared or was last hovered; seconds

    bool empty() const { return text.empty(); }
    bool is_fault() const { return !empty() && kind == MessageKind::fault; }
    void clear() { *this = {}; }
};

/// How long a notice stays after it appeared or was last hovered; seconds.
inline constexpr double notice_time = 10;

/// Whether \p message is a notice whose time has passed.
bool is_over(const Message& message, double now);

/// The message of \p error, with its keys if it is a MismatchError.
Message message_of(const std::runtime_error& error);

/// The text of \p error, or a general text if \p error has none.
std::string cause_of(const std::exception& error);

/// The message after the program has survived an unexpected \p error.
Message message_of_mishap(const std::exception& error);

}  // namespace interleaf
