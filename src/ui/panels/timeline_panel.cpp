#include "ui/panels/timeline_panel.h"

#include <algorithm>
#include <cmath>

#include <fmt/core.h>
#include <imgui.h>

#include "render/palette.h"
#include "ui/panels/keys_panel.h"
#include "ui/widgets/number_text.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// A button with a symbol drawn on it by \p draw(list, middle, size, color).
template <typename Draw>
bool symbol_button(const char* name, const char* tooltip, bool on, Draw draw) {
    const float side = ImGui::GetFrameHeight();
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const bool pressed = ImGui::Button(name, {side * 1.25F, side});
    if (ImGui::IsItemHovered()) {
        // Above: beside the pointer it would lie over the start of the track.
        ImGui::SetNextWindowPos({corner.x, corner.y - scaled(4)}, ImGuiCond_Always, {0, 1});
        ImGui::SetTooltip("%s", tooltip);
    }
    draw(*ImGui::GetWindowDrawList(), glm::vec2(corner.x + side * 0.625F, corner.y + side / 2), side * 0.25F,
         on ? colors::accent : colors::text);
    return pressed;
}

void draw_play(ImDrawList& list, glm::vec2 middle, float size, ImU32 color) {
    list.AddTriangleFilled({middle.x - size * 0.7F, middle.y - size},
                           {middle.x - size * 0.7F, middle.y + size}, {middle.x + size, middle.y}, color);
}

void draw_pause(ImDrawList& list, glm::vec2 middle, float size, ImU32 color) {
    const float width = size * 0.6F;
    list.AddRectFilled({middle.x - size * 0.8F, middle.y - size},
                       {middle.x - size * 0.8F + width, middle.y + size}, color);
    list.AddRectFilled({middle.x + size * 0.8F - width, middle.y - size},
                       {middle.x + size * 0.8F, middle.y + size}, color);
}

void draw_loop(ImDrawList& list, glm::vec2 middle, float size, ImU32 color) {
    constexpr float pi = 3.14159265F;
    list.PathArcTo(to_imgui(middle), size, -0.1F * pi, 1.55F * pi);
    list.PathStroke(color, ImDrawFlags_None, scaled(2));
    const float tip = size * 0.65F;
    list.AddTriangleFilled({middle.x - tip * 0.1F, middle.y - size - tip},
                           {middle.x - tip * 0.1F, middle.y - size + tip}, {middle.x + tip, middle.y - size},
                           color);
}

/// Time to pixels along the track and back.
struct TimeScale {
    double begin;
    double end;
    Rect track;

    float pixel(double time) const {
        const double part = end > begin ? (time - begin) / (end - begin) : 0;
        return track.x + track.width * static_cast<float>(part);
    }
    double time(float pixel) const {
        return begin +
               (end - begin) * std::clamp(static_cast<double>((pixel - track.x) / track.width), 0.0, 1.0);
    }
};

/// The time under the pointer; a key's own when it is near one.
double pointed_time(const Timeline& timeline, const TimeScale& scale, float pointer) {
    for (const TimelineKey& key : timeline.keys()) {
        if (std::abs(scale.pixel(key.time) - pointer) < scaled(4)) return key.time;
    }
    return scale.time(pointer);
}

/// The track, each interval shaded from key to key.
void draw_track(ImDrawList& list, const Timeline& timeline, const TimeScale& scale) {
    const float middle = scale.track.y + scale.track.height / 2;
    const float half = scaled(3);
    const auto keys = timeline.keys();
    list.AddRectFilled({scale.track.x - half, middle - half}, {scale.track.right() + half, middle + half},
                       colors::well, half);
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const ImU32 left = to_color(key_color(keys[i].key), 0.7F);
        const ImU32 right = to_color(key_color(keys[i + 1].key), 0.7F);
        list.AddRectFilledMultiColor({scale.pixel(keys[i].time), middle - half},
                                     {scale.pixel(keys[i + 1].time), middle + half}, left, right, right,
                                     left);
    }
}

void draw_marks(ImDrawList& list, const Timeline& timeline, const TimeScale& scale) {
    const float middle = scale.track.y + scale.track.height / 2;
    for (const TimelineKey& key : timeline.keys()) {
        const float x = scale.pixel(key.time);
        list.AddCircleFilled({x, middle}, scaled(6), colors::dark);
        list.AddCircleFilled({x, middle}, scaled(5), to_color(key_color(key.key)));
    }
}

/// Of the power of ten that is a hundredth of what the track spans, or less; seconds.
int readable_exponent(const TimeScale& scale) {
    const double span = scale.end > scale.begin ? scale.end - scale.begin : 1;
    return static_cast<int>(std::floor(std::log10(span / 100)));
}

/// The time under the pointer as a round number; before and after the track, too.
double readable_time(const TimeScale& scale, float pointer) {
    const double span = scale.end > scale.begin ? scale.end - scale.begin : 1;
    const double part = static_cast<double>((pointer - scale.track.x) / scale.track.width);
    return rounded_to_power(scale.begin + span * part, readable_exponent(scale));
}

/// The time under the pointer for the key at \p place, which stays between its neighbors.
double dragged_time(const Timeline& timeline, std::size_t place, const TimeScale& scale, float pointer) {
    const auto keys = timeline.keys();
    const int exponent = readable_exponent(scale);
    const double step = std::pow(10.0, exponent);
    double time = readable_time(scale, pointer);
    if (place + 1 < keys.size())
        time = std::min(time, rounded_to_power(keys[place + 1].time - step, exponent));
    if (place > 0) time = std::max(time, rounded_to_power(keys[place - 1].time + step, exponent));
    return time;
}

/// The menu of the right mouse button on the name that is the last item.
void show_time_menu(std::size_t place, TimelineResult& result) {
    if (!ImGui::BeginPopupContextItem("time menu")) return;
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts[0]);
    if (ImGui::MenuItem("Set time...")) result.asked_time = place;
    if (ImGui::MenuItem("Take off the timeline")) result.removed = place;
    ImGui::PopFont();
    ImGui::EndPopup();
}

/// The names below the marks: dragging one moves its key in time, the right mouse button has a menu.
void show_names(const Family& family, const TimeScale& scale, const std::optional<TimeDrag>& drag,
                TimelineResult& result) {
    const Timeline& timeline = *family.timeline;
    const auto keys = timeline.keys();
    float label_end = scale.track.x - scaled(40);
    ImGui::PushFont(small_font());
    for (std::size_t place = 0; place < keys.size(); ++place) {
        const std::string& name = family.keys[keys[place].key].name;
        const float width = text_size(name).x;
        const float left =
            std::clamp(scale.pixel(keys[place].time) - width / 2, scale.track.x - scaled(12),
                       std::max(scale.track.right() + scaled(12) - width, scale.track.x - scaled(12)));
        // A name that would overlap the previous name is left out; its mark stays.
        const bool is_held = drag && drag->place == place;
        if (left < label_end + scaled(8) && !is_held) continue;
        const glm::vec2 corner{left, scale.track.bottom() + scaled(1)};
        ImGui::SetCursorScreenPos(to_imgui(corner));
        ImGui::PushID(static_cast<int>(place));
        ImGui::InvisibleButton("name", {std::max(width, 1.0F), ImGui::GetTextLineHeight()});
        const bool is_pointed = ImGui::IsItemHovered() || is_held;
        if (is_pointed) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
        if (ImGui::IsItemActive()) result.drag = is_held ? *drag : TimeDrag{place, scale.begin, scale.end};
        show_time_menu(place, result);
        ImGui::PopID();
        draw_text(corner, width + 1, is_pointed ? colors::text : colors::dim_text, name);
        label_end = left + width;
    }
    ImGui::PopFont();
    if (result.drag && ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
        const TimeScale drag_scale{result.drag->begin, result.drag->end, scale.track};
        const double to = dragged_time(timeline, result.drag->place, drag_scale, ImGui::GetIO().MousePos.x);
        result.moved = MovedTime{result.drag->place, to};
    }
}

void draw_playhead(ImDrawList& list, const TimeScale& scale, double time, bool drives) {
    const float x = scale.pixel(time);
    const ImU32 color = drives ? colors::white : colors::dim_text;
    const float half = scaled(5);
    const float top = scale.track.y;
    list.AddRectFilled({x - scaled(2), top}, {x + scaled(2), scale.track.bottom()}, colors::dark);
    list.AddRectFilled({x - scaled(1), top}, {x + scaled(1), scale.track.bottom()}, color);
    list.AddTriangleFilled({x - half, top - scaled(1)}, {x + half, top - scaled(1)}, {x, top + half}, color);
}

}  // namespace

TimelineResult timeline_panel(const Rect& rect, const Family& family, const TimelineState& state) {
    TimelineResult result;
    const Timeline& timeline = *family.timeline;
    begin_panel("timeline", rect);

    const float heading_top = ImGui::GetCursorPosY();
    ImGui::SetCursorPosY(heading_top + ImGui::GetTextLineHeightWithSpacing());
    result.toggle_playing = symbol_button("##play", state.playing ? "Pause (Space)" : "Play (Space)", false,
                                          state.playing ? draw_pause : draw_play);
    ImGui::SameLine(0, scaled(4));
    result.toggle_loop = symbol_button("##loop", "Loop (L)", state.loops, draw_loop);
    ImGui::SameLine(0, scaled(26));

    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float margin = scaled(14);
    const float width = std::max(rect.right() - corner.x - margin - ImGui::GetStyle().WindowPadding.x, 1.0F);
    const float height = ImGui::GetFrameHeight();
    result.track = {corner.x, corner.y, width, height};
    const TimeScale scale{timeline.begin(), timeline.end(), result.track};
    ImGui::SetCursorScreenPos({corner.x - margin, corner.y});
    ImGui::InvisibleButton("track", {width + 2 * margin, height});
    if (ImGui::IsItemActive()) result.seek_to = pointed_time(timeline, scale, ImGui::GetIO().MousePos.x);
    if (const auto key = dropped_key(family.keys.size()))
        result.added = KeyTime{*key, readable_time(scale, ImGui::GetIO().MousePos.x)};

    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_track(list, timeline, scale);
    draw_marks(list, timeline, scale);
    draw_playhead(list, scale, state.time, state.drives);
    show_names(family, scale, state.drag, result);

    ImGui::SetCursorPosY(heading_top);
    heading("Timeline", fmt::format("{:.2f} / {:.2f} s", state.time, timeline.end()));
    if (!state.drives) {
        ImGui::PushFont(small_font());
        const float left = corner.x;
        const float room = rect.right() - left - scaled(120);
        draw_text({left, rect.y + heading_top}, room, colors::notice, state.remark);
        ImGui::PopFont();
    }
    end_panel();
    return result;
}

}  // namespace interleaf
