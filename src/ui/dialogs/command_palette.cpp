#include "ui/dialogs/command_palette.h"

#include <algorithm>
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE

#include <GLFW/glfw3.h>
#include <imgui.h>

#include "text/fuzzy_match.h"
#include "ui/widgets/modal.h"
#include "ui/widgets/row_clipper.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

constexpr float palette_rows = 12;

/// Added to the rank of a match in group and description: behind those in the name, but before letters that are
/// scattered in the name.
constexpr unsigned description_rank = 6;

float palette_row_height() {
    return ImGui::GetTextLineHeight() + scaled(9);
}

std::optional<unsigned> entry_rank(std::string_view search, const PaletteEntry& entry) {
    const auto in_name = match_rank(search, entry.name);
    const auto in_all = match_rank(search, entry.group + " " + entry.name + " " + entry.description);
    if (!in_all) return in_name;
    return in_name ? std::min(*in_name, *in_all + description_rank) : *in_all + description_rank;
}

void draw_palette_row(const PaletteEntry& entry, glm::vec2 corner, float width) {
    const bool is_possible = entry.obstacle.empty();
    const float inset = scaled(8);
    const float top = corner.y + std::round((palette_row_height() - ImGui::GetTextLineHeight()) / 2);
    const std::string& right = is_possible ? entry.shortcut : entry.obstacle;
    ImGui::PushFont(small_font());
    const float right_width = std::min(text_size(right).x, width * 0.5F);
    const float group_width = text_size(entry.group).x;
    const float small_top = top + scaled(1);
    draw_text({corner.x + width - inset - right_width, small_top}, right_width + 1, colors::dim_text, right);
    ImGui::PopFont();
    const float left = corner.x + inset;
    const float room = width - 2 * inset - (right_width > 0 ? right_width + scaled(16) : 0);
    const float name_width = text_size(entry.name).x;
    draw_text({left, top}, room, is_possible ? colors::text : colors::dim_text, entry.name);
    if (name_width + scaled(10) + group_width > room) return;
    ImGui::PushFont(small_font());
    draw_text({left + name_width + scaled(10), small_top}, group_width + 1, colors::dim_text, entry.group);
    ImGui::PopFont();
}

/// Shows what the selected entry does, or why it cannot be chosen.
void show_footer(const PaletteEntry* selected, float width) {
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    ImGui::PushFont(small_font());
    if (selected == nullptr)
        draw_text(corner, width, colors::notice, "Nothing matches");
    else if (selected->obstacle.empty())
        draw_text(corner, width, colors::dim_text, selected->description);
    else
        draw_text(corner, width, colors::notice, "Not possible now: " + selected->obstacle);
    ImGui::Dummy({width, ImGui::GetTextLineHeight()});
    ImGui::PopFont();
}

}  // namespace

std::vector<std::size_t> ranked_entries(std::string_view search, std::span<const PaletteEntry> entries) {
    struct Ranked {
        std::size_t entry;
        unsigned rank;
        bool is_impossible;
    };
    std::vector<Ranked> found;
    found.reserve(entries.size());
    for (std::size_t i = 0; i < entries.size(); ++i)
        if (const auto rank = entry_rank(search, entries[i]))
            found.push_back({i, *rank, !entries[i].obstacle.empty()});
    std::ranges::stable_sort(found, {},
                             [](const Ranked& entry) { return std::pair(entry.rank, entry.is_impossible); });
    std::vector<std::size_t> ranked;
    ranked.reserve(found.size());
    for (const Ranked& entry : found) ranked.push_back(entry.entry);
    return ranked;
}

void CommandPalette::open() {
    search_ = TextField();
    search_.set("");
    last_search_.clear();
    selected_ = 0;
    chosen_.reset();
    is_open_ = is_new_ = follows_ = true;
    is_closing_ = false;
}

void CommandPalette::read_keys(std::size_t count, std::size_t page) {
    if (is_key_pressed(GLFW_KEY_ESCAPE)) is_closing_ = true;
    if (count == 0) return;
    const std::size_t before = selected_;
    if (is_key_pressed(GLFW_KEY_UP, KeyRepeat::yes)) selected_ = selected_ > 0 ? selected_ - 1 : count - 1;
    if (is_key_pressed(GLFW_KEY_DOWN, KeyRepeat::yes)) selected_ = selected_ + 1 < count ? selected_ + 1 : 0;
    if (is_key_pressed(GLFW_KEY_PAGE_UP, KeyRepeat::yes)) selected_ -= std::min(selected_, page);
    if (is_key_pressed(GLFW_KEY_PAGE_DOWN, KeyRepeat::yes)) selected_ = std::min(selected_ + page, count - 1);
    if (selected_ != before) follows_ = true;
}

void CommandPalette::choose(std::span<const PaletteEntry> entries, const std::vector<std::size_t>& ranked,
                            std::size_t row) {
    selected_ = row;
    if (!entries[ranked[row]].obstacle.empty()) return;
    chosen_ = ranked[row];
    is_closing_ = true;
}

void CommandPalette::show_rows(std::span<const PaletteEntry> entries, const std::vector<std::size_t>& ranked,
                               float height) {
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild("entries", {0, height}, false, ImGuiWindowFlags_NoNav);
    ImGui::PopStyleVar();
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const float row_height = palette_row_height();
    if (std::exchange(follows_, false)) {
        const float top = row_height * static_cast<float>(selected_);
        const float scroll = ImGui::GetScrollY();
        ImGui::SetScrollY(std::clamp(scroll, top + row_height - height, top));
    }
    const float width = ImGui::GetContentRegionAvail().x;
    RowClipper clipper(ranked.size(), row_height);
    while (clipper.Step()) {
        const auto end = static_cast<std::size_t>(clipper.DisplayEnd);
        for (auto row = static_cast<std::size_t>(clipper.DisplayStart); row < end; ++row) {
            const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
            ImGui::PushID(static_cast<int>(row));
            // Under the pointer, a row that is not selected must not look selected.
            const ImGuiCol hovered = row == selected_ ? ImGuiCol_HeaderHovered : ImGuiCol_FrameBg;
            ImGui::PushStyleColor(ImGuiCol_HeaderHovered, ImGui::GetStyleColorVec4(hovered));
            const bool is_clicked = ImGui::Selectable("##entry", row == selected_, 0, {width, row_height});
            ImGui::PopStyleColor();
            ImGui::PopID();
            if (is_clicked) choose(entries, ranked, row);
            draw_palette_row(entries[ranked[row]], corner, width);
        }
    }
    ImGui::PopStyleVar();
    ImGui::EndChild();
}

std::optional<std::size_t> CommandPalette::show(const Rect& area, std::span<const PaletteEntry> entries) {
    if (!is_open_) return std::nullopt;
    const float spacing = ImGui::GetStyle().ItemSpacing.y;
    const float frame = 2 * scaled(14) + ImGui::GetFrameHeight() + scaled(13) + 2 * spacing;
    const float margin =
        std::min(scaled(36), std::max((area.height - frame - 3 * palette_row_height()) / 2, 0.0F));
    const float room = area.height - 2 * margin - frame;
    const float row = palette_row_height();
    const float rows = std::clamp(std::floor(room / row), 1.0F, palette_rows);
    const float height = frame + rows * row;
    if (begin_modal("commands", {area.x, area.y, area.width, height + 2 * margin}, {scaled(600), height})) {
        const float width = ImGui::GetContentRegionAvail().x;
        const TextFieldResult typed =
            search_.show("##search", "Search commands, keys and recent files", width, true);
        const std::vector<std::size_t> ranked = ranked_entries(search_.text(), entries);
        if (search_.text() != last_search_) {
            selected_ = 0;
            follows_ = true;
            last_search_ = search_.text();
        }
        selected_ = std::min(selected_, ranked.empty() ? 0 : ranked.size() - 1);
        if (!std::exchange(is_new_, false)) read_keys(ranked.size(), static_cast<std::size_t>(rows));
        show_rows(entries, ranked, rows * row);
        if (typed.entered && !ranked.empty()) choose(entries, ranked, selected_);
        if (typed.entered) search_.refocus();
        show_footer(ranked.empty() ? nullptr : &entries[ranked[selected_]], width);
        const bool is_beside = !ImGui::IsWindowHovered(ImGuiHoveredFlags_RootAndChildWindows |
                                                       ImGuiHoveredFlags_AllowWhenBlockedByActiveItem);
        if (is_beside && ImGui::IsMouseClicked(ImGuiMouseButton_Left)) is_closing_ = true;
        end_modal(is_closing_);
    }
    if (!is_closing_) return std::nullopt;
    is_open_ = is_closing_ = false;
    return std::exchange(chosen_, std::nullopt);
}

}  // namespace interleaf
