#include "ui/panels/keys_panel.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include <fmt/core.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include "render/palette.h"
#include "text/fuzzy_match.h"
#include "ui/widgets/command_keys.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/row_clipper.h"
#include "ui/widgets/section.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

constexpr const char* keys_meaning =
    "The surfaces that are blended. Click a key to show it alone, double-click to rename it,\n"
    "drag it in the list, to the timeline or into the domain. Active keys are bright.";
constexpr const char* payload_type = "key";
constexpr const char* menu_name = "key menu";

/// A longer list has a search.
constexpr std::size_t max_unsearched_keys = 12;

float key_row_height() {
    return key_picture_side() + scaled(6);
}

std::string figures_text(const KeyRow& key) {
    return fmt::format("{} leaves, {} {}", grouped(key.leaves), key.deepest,
                       key.deepest == 1 ? "level" : "levels");
}

void draw_picture(ImDrawList& list, const KeyRow& row, glm::vec2 corner) {
    const float side = key_picture_side();
    const ImVec2 end{corner.x + side, corner.y + side};
    list.AddRectFilled(to_imgui(corner), end, colors::well, scaled(4));
    if (row.picture == 0) return;
    list.AddImageRounded(texture_id(row.picture), to_imgui(corner), end, {0, 0}, {1, 1}, colors::white,
                         scaled(4));
}

void draw_row(const KeyRow& row, std::size_t key, glm::vec2 corner, float width, bool is_active,
              bool is_selected) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float inset = scaled(3);
    draw_picture(list, row, corner + inset);
    const float left = corner.x + inset + key_picture_side() + scaled(10);
    const float line = ImGui::GetTextLineHeight();
    const float top = corner.y + std::round(key_row_height() / 2 - line) - scaled(1);
    const float dot = scaled(4);
    list.AddCircleFilled({left + dot, top + line / 2 + 1}, dot,
                         to_color(key_color(key), is_active ? 1.0F : 0.45F));
    const float name_left = left + scaled(15);
    draw_name({name_left, top}, corner.x + width - name_left - scaled(6),
              is_active || is_selected ? colors::text : colors::dim_text, row.name);
    ImGui::PushFont(small_font());
    draw_text({left, top + line + scaled(2)}, corner.x + width - left - scaled(6),
              is_selected ? colors::text : colors::dim_text, figures_text(row));
    ImGui::PopFont();
}

void drag_row(const KeysPanel& panel, std::size_t key, KeysPanelResult& result) {
    if (ImGui::BeginDragDropSource()) {
        ImGui::SetDragDropPayload(payload_type, &key, sizeof key);
        ImGui::TextUnformatted(panel.keys[key].name.c_str());
        ImGui::EndDragDropSource();
    }
    if (const auto dropped = dropped_key(panel.keys.size())) {
        result.dragged = dropped;
        result.dropped_on = key;
    }
}

bool is_active_key(const KeysPanel& panel, std::size_t key) {
    return std::ranges::find(panel.weights, key, &Weight::key) != panel.weights.end();
}

bool has_search(const KeysPanel& panel) {
    return panel.search.is_shown || panel.keys.size() > max_unsearched_keys;
}

/// The keys that the search lets through, in their order.
std::vector<std::size_t> shown_keys(const KeysPanel& panel) {
    std::vector<std::size_t> shown;
    shown.reserve(panel.keys.size());
    const bool searches = has_search(panel);
    for (std::size_t key = 0; key < panel.keys.size(); ++key) {
        if (searches && panel.search.only_active && !is_active_key(panel, key)) continue;
        if (searches && !contains_words(panel.search.text, panel.keys[key].name)) continue;
        shown.push_back(key);
    }
    return shown;
}

/// Shows the field to search in, and the button that shows only active keys. Enter chooses the first key, Esc
/// ends the search.
void show_search(const KeysPanel& panel, std::span<const std::size_t> rows, KeysPanelResult& result) {
    KeySearch search = panel.search;
    const float gap = scaled(2);
    const float button = text_size("Active").x + 2 * ImGui::GetStyle().FramePadding.x;
    if (panel.takes_focus) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - button - gap);
    const bool is_entered = ImGui::InputTextWithHint("##search", with_keys("Find key", {"Find"}).c_str(),
                                                     &search.text, ImGuiInputTextFlags_EnterReturnsTrue);
    if (is_entered && !rows.empty()) result.chosen = rows.front();
    if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) search = {};
    ImGui::SameLine(0, gap);
    const bool only_active = search.only_active;
    if (only_active) {
        ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    }
    if (ImGui::Button("Active", {button, 0})) search.only_active = !only_active;
    if (only_active) ImGui::PopStyleColor(2);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Show only the keys of the blend");
    if (search != panel.search) result.search = search;
}

/// Shows the context menu of the row that is the last item, with the spacing of menus.
void show_row_menu(const KeysPanel& panel, ImVec2 spacing, KeysPanelResult& result) {
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, spacing);
    if (ImGui::BeginPopupContextItem(menu_name)) {
        result.menu_entry = menu_entries(panel.menu);
        ImGui::EndPopup();
    }
    ImGui::PopStyleVar();
}

/// Scrolls the list, which is the current window, to the key with the largest weight when that changes, unless
/// the row is visible or the pointer is over the list.
/// \param shown  the keys of the rows
void follow_active(const KeysPanel& panel, std::span<const std::size_t> shown) {
    const auto largest = std::ranges::max_element(panel.weights, {}, &Weight::value);
    if (largest == panel.weights.end()) return;
    int& followed = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("followed"), 0);
    const auto key = static_cast<int>(largest->key);
    if (key == followed || ImGui::IsWindowHovered()) return;
    followed = key;
    const auto row = std::ranges::find(shown, largest->key);
    if (row == shown.end()) return;
    const float top = key_row_height() * static_cast<float>(row - shown.begin());
    const float height = ImGui::GetWindowHeight();
    const float scroll = ImGui::GetScrollY();
    if (top < scroll || top + key_row_height() > scroll + height)
        ImGui::SetScrollY(std::max(top - (height - key_row_height()) / 2, 0.0F));
}

/// Chooses the key whose row, which is the last item, has got the focus by arrow keys from another row.
void choose_focused(const KeysPanel& panel, std::size_t key, int& focused, KeysPanelResult& result) {
    const int here = static_cast<int>(key) + 1;
    if (focused != 0 && focused != here && panel.selected != key) {
        result.chosen = key;
    } else {
        focused = here;  // the first row with the focus is not chosen by that
    }
}

/// \param shown  the keys of the rows
void show_rows(const KeysPanel& panel, std::span<const std::size_t> shown, KeysPanelResult& result) {
    const ImVec2 spacing = ImGui::GetStyle().ItemSpacing;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, 0});
    const float width = ImGui::GetContentRegionAvail().x;
    int& focused = *ImGui::GetStateStorage()->GetIntRef(ImGui::GetID("focused"), 0);
    bool has_focus = false;
    RowClipper clipper(shown.size(), key_row_height());
    while (clipper.Step()) {
        const auto begin = static_cast<std::size_t>(clipper.DisplayStart);
        const auto end = static_cast<std::size_t>(clipper.DisplayEnd);
        for (const std::size_t key : shown.subspan(begin, end - begin)) {
            result.visible.push_back(key);
            const bool is_active = is_active_key(panel, key);
            ImGui::PushID(static_cast<int>(key));
            const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
            // Under the pointer, a row that is not selected must not look selected.
            const ImGuiCol hovered = panel.selected == key ? ImGuiCol_HeaderHovered : ImGuiCol_FrameBg;
            ImGui::PushStyleColor(ImGuiCol_HeaderHovered, ImGui::GetStyleColorVec4(hovered));
            const bool is_clicked =
                ImGui::Selectable("##row", panel.selected == key, ImGuiSelectableFlags_AllowDoubleClick,
                                  {width, key_row_height()});
            ImGui::PopStyleColor();
            if (is_clicked && ImGui::GetIO().KeyCtrl) {
                result.toggled = key;
            } else if (is_clicked) {
                result.chosen = key;
                if (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) result.renamed = key;
            }
            if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) result.chosen = key;
            if (shows_focus() && ImGui::IsItemFocused()) {
                has_focus = true;
                choose_focused(panel, key, focused, result);
            }
            drag_row(panel, key, result);
            show_row_menu(panel, spacing, result);
            draw_row(panel.keys[key], key, corner, width, is_active, panel.selected == key);
            ImGui::PopID();
        }
    }
    if (!has_focus) focused = 0;
    ImGui::PopStyleVar();
}

}  // namespace

float key_picture_side() {
    return scaled(32);
}

std::optional<std::size_t> dropped_key(std::size_t key_count) {
    if (!ImGui::BeginDragDropTarget()) return std::nullopt;
    std::optional<std::size_t> key;
    if (const ImGuiPayload* const payload = ImGui::AcceptDragDropPayload(payload_type)) {
        key.emplace();
        std::memcpy(&*key, payload->Data, sizeof *key);
    }
    ImGui::EndDragDropTarget();
    if (key && *key >= key_count) key.reset();  // the family has changed since the drag began
    return key;
}

KeysPanelResult keys_panel(const KeysPanel& panel, float height) {
    KeysPanelResult result;
    const std::vector<std::size_t> rows = shown_keys(panel);
    const std::string count = rows.size() == panel.keys.size()
                                  ? fmt::format("{}", panel.keys.size())
                                  : fmt::format("{} of {}", rows.size(), panel.keys.size());
    if (panel.takes_focus) open_section("Keys");
    if (!section("Keys", count, keys_meaning)) return result;
    if (has_search(panel)) show_search(panel, rows, result);
    const float wanted = key_row_height() * static_cast<float>(std::max<std::size_t>(rows.size(), 1));
    const float shown = std::min(wanted, std::max(height, key_row_height()));
    const glm::vec2 corner = from_imgui(ImGui::GetCursorScreenPos());
    // In a narrow window the panel scrolls, and the list may not be visible.
    const float bottom = std::min(corner.y + shown, ImGui::GetWindowDrawList()->GetClipRectMax().y);
    const float top = std::max(corner.y, ImGui::GetWindowDrawList()->GetClipRectMin().y);
    result.list = {corner.x, top, ImGui::GetContentRegionAvail().x, std::max(bottom - top, 0.0F)};
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::BeginChild("key list", {0, shown}, false, ImGuiWindowFlags_NavFlattened);
    ImGui::PopStyleVar();
    if (result.search) ImGui::SetScrollY(0);
    if (rows.empty()) ImGui::TextDisabled("No key matches");
    if (wanted > shown) follow_active(panel, rows);
    show_rows(panel, rows, result);
    ImGui::EndChild();
    const float gap = scaled(2);
    const float width = (ImGui::GetContentRegionAvail().x - gap) / 2;
    result.add = ImGui::Button("Add...", {width, 0});
    tooltip(with_keys("Add keys or meshes from files", {"Add keys"}));
    ImGui::SameLine(0, gap);
    result.keep_blend = ImGui::Button("Keep blend", {width, 0});
    tooltip(with_keys("Add the shown surface as a key", {"Keep blend"}));
    return result;
}

}  // namespace interleaf
