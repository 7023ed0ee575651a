#include "ui/panels/brush_bar.h"

#define GLFW_INCLUDE_NONE

#include <algorithm>
#include <cmath>

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "ui/widgets/command_keys.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Factors of the radius for one step of the wheel, and for one press of a key.
constexpr float wheel_factor = 1.12F;
constexpr float key_factor = 1.25F;

void explain(const std::string& text) {
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled) && !ImGui::IsItemActive())
        ImGui::SetTooltip("%s", text.c_str());
}

/// Puts the next item on the same line, if \p width is left there.
void continue_line(float width, float right) {
    ImGui::SameLine(0, scaled(14));
    if (ImGui::GetCursorScreenPos().x + width > right) ImGui::NewLine();
}

bool tool_button(bool is_on) {
    if (is_on) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    }
    const bool pressed = ImGui::Button("Refine brush");
    if (is_on) ImGui::PopStyleColor(2);
    explain(with_keys(
        is_on ? "Put the brush away" : "Bisect or coarsen the leaves of the selected key under the pointer",
        {"Refine brush"}));
    return pressed;
}

int level_field(const char* label, const char* name, int level, int deepest, float right) {
    const float width = scaled(92);
    continue_line(text_size(label).x + scaled(6) + width, right);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(0, scaled(6));
    ImGui::SetNextItemWidth(width);
    ImGui::InputInt(name, &level, 1, 4, ImGuiInputTextFlags_CharsDecimal);
    return std::clamp(level, 0, deepest);
}

void show_settings(const BrushShown& shown, BrushSettings& settings, float right) {
    const float width = scaled(110);
    continue_line(text_size("Radius").x + scaled(6) + width, right);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Radius");
    ImGui::SameLine(0, scaled(6));
    ImGui::SetNextItemWidth(width);
    float percent = 100 * settings.radius;
    if (ImGui::SliderFloat("##radius", &percent, 100 * shown.min_radius, 100 * shown.max_radius, "%.2g %%",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_AlwaysClamp))
        settings.radius = percent / 100;
    explain("In percent of the diagonal of the key's box: [ and ], or the wheel with Shift");
    settings.refined_level =
        level_field("Refine to level", "##refined", settings.refined_level, shown.deepest_level, right);
    explain("Drag: bisect until no leaf under the brush is coarser than this level (Shift+[ and Shift+])");
    settings.coarsened_level =
        level_field("Coarsen to level", "##coarsened", settings.coarsened_level, shown.deepest_level, right);
    explain("Shift + drag: remove vertices while the leaves around them are finer than this level");
}

void read_brush_keys(const BrushShown& shown, BrushSettings& settings) {
    const bool changes_level = ImGui::GetIO().KeyShift;
    for (const int step : {-1, 1}) {
        if (!is_key_pressed(step < 0 ? GLFW_KEY_LEFT_BRACKET : GLFW_KEY_RIGHT_BRACKET, KeyRepeat::yes))
            continue;
        if (changes_level)
            settings.refined_level = std::clamp(settings.refined_level + step, 0, shown.deepest_level);
        else
            settings.radius *= step < 0 ? 1 / key_factor : key_factor;
    }
}

/// Takes the wheel with a modifier for the radius.
void read_brush_wheel(BrushSettings& settings, ViewInput& input) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!input.hovered || !(io.KeyShift || io.KeyCtrl || io.KeyAlt)) return;
    // Dear ImGui may have turned the wheel sideways, as Shift does for scrolling.
    const float wheel = io.MouseWheel != 0 ? io.MouseWheel : io.MouseWheelH;
    settings.radius *= std::pow(wheel_factor, wheel);
    input.zoom = 1;
}

void read_stroke(const BrushShown& shown, const std::optional<BrushHold>& held, ViewInput& input,
                 BrushResult& result) {
    const ImGuiIO& io = ImGui::GetIO();
    result.begins = input.pressed && shown.is_over_surface && !io.KeyCtrl;
    if (result.begins)
        result.hold = BrushHold{input.pointer, io.KeyShift || io.KeyAlt};
    else if (held && input.held)
        result.hold = BrushHold{input.pointer, held->coarsens};
    if (shown.is_over_surface) input.view_all = false;
    if (!result.hold) return;
    result.from = result.begins ? input.pointer : held->pointer;
    input.orbit = input.pan = glm::vec2(0);
    input.view_all = false;
}

}  // namespace

BrushResult brush_bar(const Rect& view, const BrushShown& shown, const std::optional<BrushHold>& held,
                      ViewInput& input) {
    BrushResult result;
    const float margin = scaled(12);
    const float widest = view.width - 2 * margin;
    if (widest < scaled(60)) return result;
    ImGui::SetNextWindowPos({view.x + margin, view.y + margin});
    ImGui::SetNextWindowSizeConstraints({0, 0}, {widest, view.height});
    ImGui::SetNextWindowBgAlpha(shown.is_on ? 0.9F : 0);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, scaled(6));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {scaled(6), scaled(6)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    ImGui::PushFont(small_font());
    ImGui::Begin("brush", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                     ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoScrollbar);
    result.toggled = tool_button(shown.is_on);
    BrushSettings settings = shown.settings;
    const float right = view.right() - margin - scaled(6);
    const bool is_ready = *shown.hint == '\0';
    if (shown.is_on && is_ready) {
        show_settings(shown, settings, right);
    } else if (shown.is_on) {
        continue_line(text_size(shown.hint).x, right);
        ImGui::AlignTextToFramePadding();
        ImGui::TextUnformatted(shown.hint);
    }
    ImGui::End();
    ImGui::PopFont();
    ImGui::PopStyleVar(3);
    if (!shown.is_on || !is_ready) return result;
    if (shown.reads_keys) read_brush_keys(shown, settings);
    read_brush_wheel(settings, input);
    settings.radius = std::clamp(settings.radius, shown.min_radius, shown.max_radius);
    if (settings != shown.settings) result.settings = settings;
    read_stroke(shown, held, input, result);
    return result;
}

void draw_brush_circle(const Rect& view, glm::vec2 center, float radius, bool is_active) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.PushClipRect({view.x, view.y}, {view.right(), view.bottom()});
    const float line = scaled(is_active ? 2 : 1.5F);
    list.AddCircle(to_imgui(center), radius, colors::dark, 0, line + scaled(2));
    list.AddCircle(to_imgui(center), radius, is_active ? colors::accent : colors::white, 0, line);
    list.PopClipRect();
}

}  // namespace interleaf
