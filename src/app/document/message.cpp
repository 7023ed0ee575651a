#include "app/document/message.h"

#include <new>

#include <fmt/core.h>

namespace interleaf {

Message message_of(const std::runtime_error& error) {
    const auto* const mismatch = dynamic_cast<const MismatchError*>(&error);
    return {error.what(), mismatch == nullptr ? nullptr : mismatch->keys};
}

std::string cause_of(const std::exception& error) {
    const bool is_memory = dynamic_cast<const std::bad_alloc*>(&error) != nullptr;
    return is_memory ? "there is not enough memory" : error.what();
}

Message message_of_mishap(const std::exception& error) {
    return {fmt::format(
        "What you did last could not be done: {}. What is not saved has been put aside for recovery.",
        cause_of(error))};
}

bool is_over(const Message& message, double now) {
    return !message.empty() && message.kind == MessageKind::notice && now - message.seen > notice_time;
}

}  // namespace interleaf
