// What all widgets of a window share: its theme, the characters its typeface must have, and which sections are
// closed. Gui owns it; Dear ImGui's context leads to it.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>

#include <imgui.h>

#include "ui/widgets/theme.h"

namespace interleaf {

struct GuiState {
    Theme theme = Theme::dark;
    std::set<std::string, std::less<>> closed_sections{};  ///< titles
    std::map<std::string, std::string, std::less<>>
        command_keys{};          ///< texts of keys by the names of commands
    std::set<ImWchar> glyphs{};  ///< characters beyond those that the typeface always has
    bool lacks_glyphs = false;   ///< whether some of them are not in the typeface yet
};

/// The state of the present context; null for none, as in a test of one widget or without a window.
inline GuiState* gui_state() {
    return ImGui::GetCurrentContext() != nullptr ? static_cast<GuiState*>(ImGui::GetIO().UserData) : nullptr;
}

}  // namespace interleaf
