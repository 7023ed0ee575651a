#include "app/message.h"

namespace interleaf {

Message message_of(const std::runtime_error& error) {
    const auto* const mismatch = dynamic_cast<const MismatchError*>(&error);
    return {error.what(), mismatch == nullptr ? nullptr : mismatch->keys};
}

}  // namespace interleaf
