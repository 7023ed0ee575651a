#include "ui/panel_keyboard.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <array>
#include <cstddef>

#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

namespace interleaf {

namespace {

/// The windows of the panels, in the order in which F6 goes through them.
constexpr std::array<const char*, 3> panel_names{"left", "right", "timeline"};

bool is_shown(const char* name) {
    const ImGuiWindow* const window = ImGui::FindWindowByName(name);
    return window != nullptr && (window->Active || window->WasActive) && !window->Hidden;
}

}  // namespace

bool PanelKeyboard::step(int step) {
    if (step == 0) return false;
    // The place behind the last panel means no panel.
    constexpr std::size_t places = panel_names.size() + 1;
    const auto present = std::ranges::find(panel_names, panel_);
    auto place = static_cast<std::size_t>(present - panel_names.begin());
    do place = (place + (step > 0 ? 1 : places - 1)) % places;
    while (place < panel_names.size() && !is_shown(panel_names.at(place)));
    panel_ = place < panel_names.size() ? panel_names.at(place) : nullptr;
    ImGui::ClearActiveID();
    ImGuiWindow* const window = panel_ != nullptr ? ImGui::FindWindowByName(panel_) : nullptr;
    ImGui::FocusWindow(window);
    if (window == nullptr) return true;
    // Dear ImGui gives a focus only while its navigation is on.
    ImGui::GetIO().ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    ImGui::NavInitWindow(window, true);
    ImGuiContext& context = *ImGui::GetCurrentContext();
    context.NavDisableHighlight = false;
    context.NavDisableMouseHover = true;
    return true;
}

void PanelKeyboard::follow() {
    if (panel_ == nullptr) return;
    const ImGuiIO& io = ImGui::GetIO();
    const bool is_clicked = std::ranges::find(io.MouseClicked, true) != std::end(io.MouseClicked);
    const bool is_held = ImGui::IsAnyItemActive() || !ImGui::GetCurrentContext()->OpenPopupStack.empty();
    const bool leaves = io.KeysDown[GLFW_KEY_ESCAPE] && io.KeysDownDuration[GLFW_KEY_ESCAPE] < 0 && !is_held;
    if (is_clicked || leaves || !is_shown(panel_)) panel_ = nullptr;
}

}  // namespace interleaf
