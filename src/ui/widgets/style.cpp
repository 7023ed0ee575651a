#include "ui/widgets/style.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <imgui_internal.h>

#include "ui/widgets/glyphs.h"

namespace interleaf {

namespace {

void set_sizes(ImGuiStyle& style) {
    style.WindowPadding = {12, 10};
    style.FramePadding = {8, 4};
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {8, 4};
    style.CellPadding = {4, 2};
    style.ScrollbarSize = 10;
    style.WindowRounding = 0;
    style.PopupRounding = 4;
    style.FrameRounding = 4;
    style.GrabRounding = 4;
    style.WindowBorderSize = 1;
    style.FrameBorderSize = 0;
}

}  // namespace

void apply_style(float scale, float density) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    set_colors(style);
    set_sizes(style);
    style.ScaleAllSizes(scale);
    style.WindowMinSize = {1, 1};  // rounded down, the size could be too small for Dear ImGui
    make_fonts(scale, density);
}

float scaled(float length) {
    const ImGuiIO& io = ImGui::GetIO();
    return std::round(length * io.Fonts->Fonts[0]->FontSize * io.FontGlobalScale / text_height);
}

ImFont* small_font() {
    return ImGui::GetIO().Fonts->Fonts[1];
}

ImTextureID texture_id(unsigned name) {
    // The identifier is a pointer that holds the bits of the name.
    ImTextureID texture = nullptr;
    const std::uintptr_t bits = name;
    std::memcpy(static_cast<void*>(&texture), &bits, sizeof texture);
    return texture;
}

ImU32 to_color(glm::vec3 color, float alpha) {
    return ImGui::ColorConvertFloat4ToU32({color.r, color.g, color.b, alpha});
}

ImVec2 to_imgui(glm::vec2 point) {
    return {point.x, point.y};
}

glm::vec2 from_imgui(ImVec2 point) {
    return {point.x, point.y};
}

void begin_panel(const char* name, const Rect& rect) {
    ImGui::SetNextWindowPos({rect.x, rect.y});
    ImGui::SetNextWindowSize({rect.width, rect.height});
    ImGui::Begin(name, nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavFocus);
}

void end_panel() {
    if (shows_focus() && ImGui::IsWindowFocused(ImGuiFocusedFlags_RootAndChildWindows)) {
        const ImVec2 corner = ImGui::GetWindowPos();
        const ImVec2 size = ImGui::GetWindowSize();
        const float line = scaled(2);
        ImDrawList& list = *ImGui::GetWindowDrawList();
        list.PushClipRectFullScreen();
        list.AddRect({corner.x + line / 2, corner.y + line / 2},
                     {corner.x + size.x - line / 2, corner.y + size.y - line / 2}, colors::accent, 0, 0,
                     line);
        list.PopClipRect();
    }
    ImGui::End();
}

bool mouse_area(const char* name, glm::vec2 size, ImGuiButtonFlags flags) {
    ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
    const bool pressed = ImGui::InvisibleButton(name, to_imgui(size), flags);
    ImGui::PopItemFlag();
    return pressed;
}

bool shows_focus() {
    const ImGuiContext& context = *ImGui::GetCurrentContext();
    return (context.IO.ConfigFlags & ImGuiConfigFlags_NavEnableKeyboard) != 0 && !context.NavDisableHighlight;
}

void section_gap() {
    ImGui::Dummy({0, scaled(3)});
}

void heading(std::string_view title, std::string_view remark) {
    need_glyphs(title);
    ImGui::PushFont(small_font());
    ImGui::PushStyleColor(ImGuiCol_Text, colors::dim_text);
    ImGui::TextUnformatted(title.data(), title.data() + title.size());
    if (!remark.empty()) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - text_size(remark).x);
        ImGui::TextUnformatted(remark.data(), remark.data() + remark.size());
    }
    ImGui::PopStyleColor();
    ImGui::PopFont();
}

void draw_text(glm::vec2 position, float max_width, ImU32 color, std::string_view text) {
    need_glyphs(text);
    const float right = position.x + max_width;
    // Descenders reach below the line.
    const ImVec2 end{right, position.y + ImGui::GetTextLineHeight() + scaled(3)};
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), to_imgui(position), end, right, right, text.data(),
                              text.data() + text.size(), nullptr);
    ImGui::PopStyleColor();
}

glm::vec2 text_size(std::string_view text) {
    need_glyphs(text);
    return from_imgui(ImGui::CalcTextSize(text.data(), text.data() + text.size()));
}

void wrapped_text(std::string_view text, ImU32 color) {
    need_glyphs(text);
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(text.data(), text.data() + text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

float wrapped_height(std::string_view text, float width) {
    return text.empty() ? 0 : ImGui::CalcTextSize(text.data(), text.data() + text.size(), false, width).y;
}

}  // namespace interleaf
