#include "ui/timeline/timeline_track.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <string>

#include <imgui.h>

#include "family/family_time.h"
#include "render/palette.h"
#include "ui/panels/keys_panel.h"
#include "ui/timeline/path_marks.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Distance between two labels of the ruler, and between two marks; at scale 1.
constexpr float label_distance = 76;
constexpr float mark_distance = 8;

/// A longer name is cut in the middle; at scale 1.
constexpr float max_name_width = 150;

/// A key within this distance of the pointer attracts it; at scale 1.
constexpr float snap_distance = 4;

/// The keys from the last one before \p visible to the first one after it.
struct VisibleKeys {
    std::span<const TimelineKey> keys;
    std::size_t first;  ///< place of keys.front() in the timeline
};

VisibleKeys visible_keys(const Timeline& timeline, TimeRange visible) {
    const auto all = timeline.keys();
    const auto begin = std::ranges::lower_bound(all, visible.begin, {}, &TimelineKey::time);
    const auto end = std::ranges::upper_bound(all, visible.end, {}, &TimelineKey::time);
    const auto first = static_cast<std::size_t>(begin - all.begin()) - (begin > all.begin() ? 1 : 0);
    const auto last = static_cast<std::size_t>(end - all.begin()) + (end < all.end() ? 1 : 0);
    return {all.subspan(first, last - first), first};
}

/// The time under the pointer; a key's own when it is near one.
/// \param timeline  null for none
double pointed_time(const Timeline* timeline, const TimeScale& scale, float pointer) {
    if (timeline != nullptr)
        for (const TimelineKey& key : visible_keys(*timeline, scale.visible).keys)
            if (std::abs(scale.pixel(key.time) - pointer) < scaled(snap_distance)) return key.time;
    return std::clamp(scale.time(pointer), scale.visible.begin, scale.visible.end);
}

/// The time under the pointer for the key or the point at \p place, which stays between its neighbors: a round
/// time if there is one. Without any, it keeps its time.
/// \param marks  with times, ascending
template <typename Mark>
double dragged_time(std::span<const Mark> marks, std::size_t place, const TimeScale& scale, float pointer) {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double low = place > 0 ? marks[place - 1].time : -infinity;
    const double high = place + 1 < marks.size() ? marks[place + 1].time : infinity;
    const int exponent = scale.readable_exponent();
    for (int finer = 0; finer <= 6; ++finer) {
        const double step = std::pow(10.0, exponent - finer);
        const double wanted = std::max(std::min(rounded_to_power(scale.time(pointer), exponent - finer),
                                                rounded_to_power(high - step, exponent - finer)),
                                       rounded_to_power(low + step, exponent - finer));
        if (low < wanted && wanted < high) return wanted;
    }
    return marks[place].time;
}

void draw_ruler(ImDrawList& list, const Rect& ruler, const TimeScale& scale, TimeUnit unit,
                const std::optional<TimeRange>& range) {
    ImGui::PushFont(small_font());
    for (const auto& [time, label] : time_ticks(scale, scaled(label_distance), unit)) {
        const float x = std::round(scale.pixel(time));
        const float height = scaled(label.empty() ? 3 : 5);
        list.AddLine({x, ruler.bottom() - height}, {x, ruler.bottom()}, colors::dim_text);
        const float left = std::clamp(x - text_size(label).x / 2, ruler.x - scaled(10),
                                      std::max(ruler.right() + scaled(10) - text_size(label).x, ruler.x));
        draw_text({left, ruler.y - scaled(2)}, text_size(label).x + 1, colors::dim_text, label);
    }
    ImGui::PopFont();
    if (!range) return;
    const float in = std::clamp(scale.pixel(range->begin), ruler.x, ruler.right());
    const float out = std::clamp(scale.pixel(range->end), ruler.x, ruler.right());
    list.AddRectFilled({in, ruler.bottom() - scaled(3)}, {out, ruler.bottom()}, colors::accent);
    for (const float x : {in, out})
        list.AddLine({x, ruler.y}, {x, ruler.bottom()}, colors::accent, scaled(2));
}

void draw_well(ImDrawList& list, const Rect& track) {
    const float middle = track.y + track.height / 2;
    const float half = scaled(3);
    list.AddRectFilled({track.x - half, middle - half}, {track.right() + half, middle + half}, colors::well,
                       half);
}

/// The points of a path as lines across the track.
void draw_points(ImDrawList& list, const DomainPath& path, const TimeScale& scale) {
    const float middle = scale.track.y + scale.track.height / 2;
    for (const PathPoint& point : path.points()) {
        const float x = scale.pixel(point.time);
        if (x < scale.track.x - 1 || x > scale.track.right() + 1) continue;
        list.AddLine({x, middle - scaled(4)}, {x, middle + scaled(4)}, colors::dim_text);
    }
}

/// The keys of the track, each interval shaded from key to key.
void draw_keys(ImDrawList& list, const Timeline& timeline, const TimeScale& scale) {
    const Rect& track = scale.track;
    const float middle = track.y + track.height / 2;
    const float half = scaled(3);
    const auto keys = visible_keys(timeline, scale.visible).keys;
    list.PushClipRect({track.x - half, track.y}, {track.right() + half, track.bottom()}, true);
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const ImU32 left = to_color(key_color(keys[i].key), 0.7F);
        const ImU32 right = to_color(key_color(keys[i + 1].key), 0.7F);
        list.AddRectFilledMultiColor({scale.pixel(keys[i].time), middle - half},
                                     {scale.pixel(keys[i + 1].time), middle + half}, left, right, right,
                                     left);
    }
    list.PopClipRect();
    float last = -1e9F;
    for (const TimelineKey& key : keys) {
        const float x = scale.pixel(key.time);
        if (x < track.x - half || x > track.right() + half) continue;
        // Marks that would overlap become lines.
        if (x - last < scaled(mark_distance)) {
            list.AddLine({x, middle - scaled(5)}, {x, middle + scaled(5)}, to_color(key_color(key.key)));
            continue;
        }
        list.AddCircleFilled({x, middle}, scaled(6), colors::rim);
        list.AddCircleFilled({x, middle}, scaled(5), to_color(key_color(key.key)));
        last = x;
    }
}

void draw_playhead(ImDrawList& list, const TrackLayout& layout, const TimeScale& scale,
                   const TrackState& state) {
    const float x = scale.pixel(state.time);
    if (x < layout.track.x - 1 || x > layout.track.right() + 1) return;
    const ImU32 color = state.drives ? colors::ink : colors::dim_text;
    const float half = scaled(5);
    const float top = layout.ruler.bottom() - scaled(6);
    list.AddRectFilled({x - scaled(2), top}, {x + scaled(2), layout.track.bottom()}, colors::rim);
    list.AddRectFilled({x - scaled(1), top}, {x + scaled(1), layout.track.bottom()}, color);
    list.AddTriangleFilled({x - half, top - scaled(1)}, {x + half, top - scaled(1)}, {x, top + half}, color);
}

/// The menu of the right mouse button on the mark or the name of a key.
void show_key_menu(std::size_t place, TrackResult& result) {
    if (!ImGui::BeginPopup("time menu")) return;
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[0]);
    if (ImGui::MenuItem("Set time...")) result.asked_time = place;
    if (ImGui::MenuItem("Take off the timeline")) result.removed = place;
    ImGui::PopFont();
    ImGui::EndPopup();
}

/// The marks and names below the track: dragging one moves its key in time, the right mouse button has a
/// menu. Marks and names that would overlap are left out.
class NameRow {
  public:
    NameRow(const TrackLayout& layout, const Family& family, const TimeScale& scale, const TrackState& state,
            TrackResult& result)
        : layout_(layout), family_(family), scale_(scale), state_(state), result_(result) {}

    void show() {
        const auto [keys, first] = visible_keys(*family_.timeline, scale_.visible);
        ImGui::PushFont(small_font());
        for (std::size_t i = 0; i < keys.size(); ++i) show_key(keys[i], first + i);
        ImGui::PopFont();
    }

  private:
    void show_key(const TimelineKey& key, std::size_t place) {
        const float x = scale_.pixel(key.time);
        const bool is_held = state_.drag && state_.drag->place == place;
        if (x < layout_.track.x - 1 || x > layout_.track.right() + 1) return;
        if (x - last_mark_ < scaled(mark_distance) && !is_held) return;
        last_mark_ = x;
        const std::string name = shortened(family_.keys[key.key].name, scaled(max_name_width));
        const Rect& row = layout_.names;
        const float width = text_size(name).x;
        const float left = std::clamp(x - width / 2, row.x - scaled(12),
                                      std::max(row.right() + scaled(12) - width, row.x - scaled(12)));
        const bool has_name = left >= name_end_ + scaled(8) || is_held;
        const float half = scaled(5);
        const float name_top = row.y + scaled(8);

        ImGui::PushID(static_cast<int>(place));
        bool is_pointed = show_grip("mark", {x - half, row.y, 2 * half, scaled(8)}, key, place);
        if (has_name)
            is_pointed |= show_grip(
                "name", {left, name_top, std::max(width, 1.0F), ImGui::GetTextLineHeight()}, key, place);
        show_key_menu(place, result_);
        ImGui::PopID();

        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImU32 color = to_color(key_color(key.key));
        list.AddTriangleFilled({x - half + 1, row.y + scaled(7)}, {x + half - 1, row.y + scaled(7)},
                               {x, row.y + scaled(1)}, is_pointed ? colors::ink : color);
        if (!has_name) return;
        draw_text({left, name_top}, width + 1, is_pointed ? colors::text : colors::dim_text, name);
        name_end_ = left + width;
    }

    /// An area by which the key is dragged.
    bool show_grip(const char* id, const Rect& area, const TimelineKey& key, std::size_t place) {
        ImGui::SetCursorScreenPos({area.x, area.y});
        mouse_area(id, {area.width, area.height});
        const bool is_held = state_.drag && state_.drag->place == place;
        const bool is_pointed = ImGui::IsItemHovered();
        if (is_pointed || is_held) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        if (is_pointed && !ImGui::IsItemActive())
            ImGui::SetTooltip("%s, %s\nDrag to move it in time", family_.keys[key.key].name.c_str(),
                              time_text(key.time, unit_name_of(family_, TimeSource::keys)).c_str());
        if (ImGui::IsItemActive()) result_.drag = is_held ? *state_.drag : TimeDrag{place, scale_.visible};
        ImGui::OpenPopupOnItemClick("time menu", ImGuiPopupFlags_MouseButtonRight);
        return is_pointed || is_held;
    }

    const TrackLayout& layout_;
    const Family& family_;
    const TimeScale& scale_;
    const TrackState& state_;
    TrackResult& result_;
    float last_mark_ = -1e9F;
    float name_end_ = -1e9F;
};

/// The menu of the right mouse button on the ruler and the track.
void show_range_menu(const TimeScale& scale, TimeRange whole, const TrackState& state, TrackResult& result) {
    if (!ImGui::BeginPopupContextItem("range menu")) return;
    const double time =
        std::clamp(scale.readable_time(ImGui::GetMousePosOnOpeningCurrentPopup().x), whole.begin, whole.end);
    if (ImGui::MenuItem("Set in point here")) result.range = RangeEdit{.in = time};
    if (ImGui::MenuItem("Set out point here")) result.range = RangeEdit{.out = time};
    if (ImGui::MenuItem("Play whole timeline", nullptr, false, state.range.has_value()))
        result.range = RangeEdit{.clears = true};
    ImGui::Separator();
    if (ImGui::MenuItem("Show all times", nullptr, false, scale.visible != whole)) result.visible = whole;
    ImGui::EndPopup();
}

}  // namespace

std::optional<TimeRange> moved_view(const TimeScale& scale, TimeRange whole) {
    if (!ImGui::IsItemHovered()) return std::nullopt;
    const ImGuiIO& io = ImGui::GetIO();
    const double length = scale.visible.end - scale.visible.begin;
    const double per_pixel = length / static_cast<double>(std::max(scale.track.width, 1.0F));
    TimeRange visible = scale.visible;
    if (io.MouseWheel != 0 && !io.KeyShift)
        visible = zoomed(visible, whole, scale.time(io.MousePos.x), std::pow(0.8, io.MouseWheel));
    if (io.MouseWheel != 0 && io.KeyShift) visible = panned(visible, whole, -0.1 * length * io.MouseWheel);
    if (io.MouseWheelH != 0) visible = panned(visible, whole, -0.1 * length * io.MouseWheelH);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle))
        visible = panned(visible, whole, -per_pixel * static_cast<double>(io.MouseDelta.x));
    return visible == scale.visible ? std::nullopt : std::optional(visible);
}

TrackResult show_track(const TrackLayout& layout, const Family& family, const TimeScale& scale,
                       TimeRange whole, const TrackState& state) {
    TrackResult result;
    const Timeline* const timeline = state.source == TimeSource::keys ? &*family.timeline : nullptr;
    const float margin = scaled(14);
    const float pointer = ImGui::GetIO().MousePos.x;
    ImGui::SetCursorScreenPos({layout.ruler.x - margin, layout.ruler.y});
    mouse_area("track", {layout.ruler.width + 2 * margin, layout.track.bottom() - layout.ruler.y});
    if (ImGui::IsItemActive()) result.seek_to = pointed_time(timeline, scale, pointer);
    result.visible = moved_view(scale, whole);
    show_range_menu(scale, whole, state, result);
    if (const auto key = dropped_key(family.keys.size()); key && timeline != nullptr)
        result.added = KeyTime{*key, scale.readable_time(pointer)};

    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_ruler(list, layout.ruler, scale, unit_of(family, state.source), state.range);
    draw_well(list, layout.track);
    if (timeline != nullptr)
        draw_keys(list, *timeline, scale);
    else
        draw_points(list, *family.path, scale);
    draw_playhead(list, layout, scale, state);
    if (timeline != nullptr)
        NameRow(layout, family, scale, state, result).show();
    else
        show_path_marks(layout, *family.path, scale, state, result);
    if (result.drag && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        const TimeScale drag_scale{result.drag->visible, scale.track};
        const std::size_t place = result.drag->place;
        const double to = timeline != nullptr
                              ? dragged_time(timeline->keys(), place, drag_scale, pointer)
                              : dragged_time(family.path->points(), place, drag_scale, pointer);
        result.moved = MovedTime{place, to};
    }
    return result;
}

}  // namespace interleaf
