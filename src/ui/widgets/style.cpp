#include "ui/widgets/style.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <imgui_internal.h>

#include "ui/widgets/typeface.h"

namespace interleaf {

namespace {

constexpr float text_height = 15;
constexpr float small_text_height = 13;

ImVec4 color(int red, int green, int blue, int alpha = 255) {
    const auto part = [](int value) { return static_cast<float>(value) / 255.0F; };
    return {part(red), part(green), part(blue), part(alpha)};
}

void set_colors(ImGuiStyle& style) {
    ImVec4* const c = style.Colors;
    c[ImGuiCol_Text] = ImGui::ColorConvertU32ToFloat4(colors::text);
    c[ImGuiCol_TextDisabled] = ImGui::ColorConvertU32ToFloat4(colors::dim_text);
    c[ImGuiCol_WindowBg] = color(30, 33, 40);
    c[ImGuiCol_PopupBg] = color(36, 40, 48);
    c[ImGuiCol_MenuBarBg] = color(24, 26, 32);
    c[ImGuiCol_Border] = color(14, 15, 19);
    c[ImGuiCol_FrameBg] = color(46, 51, 61);
    c[ImGuiCol_FrameBgHovered] = color(60, 67, 80);
    c[ImGuiCol_FrameBgActive] = color(54, 102, 163);
    c[ImGuiCol_Button] = color(46, 51, 61);
    c[ImGuiCol_ButtonHovered] = color(60, 67, 80);
    c[ImGuiCol_ButtonActive] = color(54, 102, 163);
    c[ImGuiCol_Header] = color(48, 76, 112);
    c[ImGuiCol_HeaderHovered] = color(52, 88, 134);
    c[ImGuiCol_HeaderActive] = color(54, 102, 163);
    c[ImGuiCol_CheckMark] = ImGui::ColorConvertU32ToFloat4(colors::accent);
    c[ImGuiCol_ModalWindowDimBg] = color(0, 0, 0, 0);  // begin_modal() dims the background itself
    c[ImGuiCol_Separator] = color(48, 53, 63);
    c[ImGuiCol_ScrollbarBg] = color(0, 0, 0, 0);
    c[ImGuiCol_ScrollbarGrab] = color(62, 68, 80);
    c[ImGuiCol_ScrollbarGrabHovered] = color(78, 86, 101);
    c[ImGuiCol_ScrollbarGrabActive] = color(92, 164, 255);
    c[ImGuiCol_NavHighlight] = ImGui::ColorConvertU32ToFloat4(colors::accent);
    c[ImGuiCol_TextSelectedBg] = color(54, 102, 163, 160);
}

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

void make_fonts(float scale, float density) {
    static constexpr ImWchar ranges[] = {0x20,   0x24f,       // Latin
                                         0x370,  0x4ff,       // Greek, Cyrillic
                                         0x2010, 0x2044, 0};  // dashes, ellipsis
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    const auto bytes = typeface();
    for (const float height : {text_height, small_text_height}) {
        ImFontConfig config;
        config.FontDataOwnedByAtlas = false;
        // With FontDataOwnedByAtlas off, Dear ImGui does not write to the bytes; its parameter merely lacks
        // the const.
        void* const data =
            const_cast<unsigned char*>(bytes.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
        io.Fonts->AddFontFromMemoryTTF(data, static_cast<int>(bytes.size()),
                                       std::round(height * scale * density), &config, ranges);
    }
    io.FontGlobalScale = 1 / density;
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
    ImGui::Dummy({0, scaled(6)});
}

void heading(std::string_view title, std::string_view remark) {
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
    const float right = position.x + max_width;
    // Descenders reach below the line.
    const ImVec2 end{right, position.y + ImGui::GetTextLineHeight() + scaled(3)};
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), to_imgui(position), end, right, right, text.data(),
                              text.data() + text.size(), nullptr);
    ImGui::PopStyleColor();
}

glm::vec2 text_size(std::string_view text) {
    return from_imgui(ImGui::CalcTextSize(text.data(), text.data() + text.size()));
}

void wrapped_text(std::string_view text, ImU32 color) {
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
