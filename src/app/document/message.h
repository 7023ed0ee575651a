// A message to a person in front of the window: a fault, which stays until it is dismissed, or a notice,
// which goes by itself.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <stdexcept>
#include <string>

#include "family/synchronize_keys.h"

namespace interleaf {

enum class MessageKind : std::uint8_t {
    fault,   ///< something is wrong, or asks for something to be done
    notice,  ///< good to know
};

struct Message {
    std::string text;  ///< empty for no message
    std::shared_ptr<const MismatchedKeys> mismatch =
        nullptr;  ///< what it is about, to be shown; null for other things
    MessageKind kind = MessageKind::fault;
    double seen = 0;  ///< when a notice came, or was last pointed at; seconds

    bool empty() const { return text.empty(); }
    bool is_fault() const { return !empty() && kind == MessageKind::fault; }
    void clear() { *this = {}; }
};

/// How long a notice stays when it is not pointed at; seconds.
inline constexpr double notice_time = 10;

/// Whether \p message is a notice that has been there long enough.
bool is_over(const Message& message, double now);

/// What \p error says, and shows if it is a MismatchError.
Message message_of(const std::runtime_error& error);

/// What \p error says; in words where it has none of its own.
std::string cause_of(const std::exception& error);

/// What to say when \p error, which nothing was prepared for, has been lived through.
Message message_of_mishap(const std::exception& error);

}  // namespace interleaf
