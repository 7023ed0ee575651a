// What tests ask of errors.
#pragma once

#include <functional>
#include <string>

#include "hierarchy/error.h"

namespace interleaf {

/// The text of the Error that \p action throws; "" if it throws nothing.
template <typename Error>
std::string text_of_thrown(const std::function<void()>& action) {
    try {
        action();
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

inline std::string input_error_of(const std::function<void()>& action) {
    return text_of_thrown<InputError>(action);
}

inline std::string machine_error_of(const std::function<void()>& action) {
    return text_of_thrown<MachineError>(action);
}

}  // namespace interleaf
