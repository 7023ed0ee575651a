// A message to a person in front of the window: what is wrong, or how near fitted keys are to their meshes.
#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "family/synchronise_keys.h"

namespace interleaf {

struct Message {
    std::string text;                                ///< empty for no message
    std::shared_ptr<const MismatchedKeys> mismatch;  ///< what it is about, to be shown; null for other things

    bool empty() const { return text.empty(); }
    void clear() { *this = {}; }
};

/// What \p error says, and shows if it is a MismatchError.
Message message_of(const std::runtime_error& error);

}  // namespace interleaf
