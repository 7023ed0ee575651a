#include "ui/widgets/command_keys.h"

#include <cassert>

#include <fmt/core.h>

#include "ui/widgets/gui_state.h"

namespace interleaf {

std::string with_keys(std::string_view text, std::initializer_list<std::string_view> commands) {
    const GuiState* const state = gui_state();
    std::string keys;
    if (state != nullptr && !state->command_keys.empty()) {
        for (const std::string_view command : commands) {
            const auto found = state->command_keys.find(command);
            assert(found != state->command_keys.end());
            if (!found->second.empty())
                keys += fmt::format("{}{}", keys.empty() ? "" : " and ", found->second);
        }
    }
    return keys.empty() ? std::string(text) : fmt::format("{} ({})", text, keys);
}

}  // namespace interleaf
