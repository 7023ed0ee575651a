#include "ui/browser/breadcrumbs.h"

#include <algorithm>
#include <string>

#include <imgui.h>

#include "text/shown_text.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

constexpr const char* ellipsis = "…";
constexpr const char* separator = "›";

std::string label_of(const fs::path& folder) {
    return folder.has_filename() ? shown_name(folder.filename().native()) : "/";
}

float padding() {
    return scaled(6);
}

float gap() {
    return text_size(separator).x + scaled(4);
}

/// Shows a folder as a button of this width. An ellipsis cuts off a longer text.
bool crumb(std::size_t index, const std::string& label, float width, bool is_last, bool is_focused) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImGui::PushID(static_cast<int>(index));
    const bool clicked = ImGui::InvisibleButton("crumb", {width, ImGui::GetFrameHeight()});
    ImGui::PopID();
    const bool is_hovered = ImGui::IsItemHovered();
    if (is_hovered)
        ImGui::GetWindowDrawList()->AddRectFilled(ImGui::GetItemRectMin(), ImGui::GetItemRectMax(),
                                                  ImGui::GetColorU32(ImGuiCol_ButtonHovered), scaled(4));
    draw_text({corner.x + padding(), corner.y + ImGui::GetStyle().FramePadding.y}, width - 2 * padding() + 1,
              is_last || is_hovered ? colors::text : colors::dim_text, label);
    if (is_focused) draw_focus();
    return clicked;
}

}  // namespace

std::vector<fs::path> folders_on_the_way(const fs::path& folder) {
    std::vector<fs::path> folders;
    fs::path path;
    for (const fs::path& part : folder) {
        path /= part;
        if (!part.empty()) folders.push_back(path);
    }
    return folders;
}

std::optional<std::size_t> breadcrumbs(const std::vector<fs::path>& folders, float width,
                                       std::optional<std::size_t> focused) {
    std::optional<std::size_t> clicked;
    std::vector<float> widths;
    widths.reserve(folders.size());
    for (const fs::path& folder : folders) widths.push_back(text_size(label_of(folder)).x + 2 * padding());
    const float ellipsis_width = text_size(ellipsis).x + 2 * padding();
    std::size_t first = folders.size() - 1;
    float used = std::min(widths.back(), width - ellipsis_width - gap());
    while (first > 0 && used + gap() + widths[first - 1] + (first > 1 ? ellipsis_width + gap() : 0) <= width)
        used += gap() + widths[--first];
    if (first > 0 && focused && *focused < first) focused = first - 1;

    for (std::size_t i = first > 0 ? first - 1 : 0; i < folders.size(); ++i) {
        const bool is_rest = i < first;
        const bool is_last = i + 1 == folders.size();
        const float room = std::max(std::min(widths[i], width), 1.0F);
        const float shown_width = is_rest                 ? ellipsis_width
                                  : is_last && first == i ? std::min(room, used)
                                                          : room;
        if (crumb(i, is_rest ? ellipsis : label_of(folders[i]), std::max(shown_width, 1.0F), is_last,
                  focused == i))
            clicked = i;
        if (is_last) break;
        ImGui::SameLine(0, 0);
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        draw_text({corner.x + scaled(2), corner.y + ImGui::GetStyle().FramePadding.y}, gap(),
                  colors::dim_text, separator);
        ImGui::Dummy({gap(), ImGui::GetFrameHeight()});
        ImGui::SameLine(0, 0);
    }
    return clicked;
}

}  // namespace interleaf
