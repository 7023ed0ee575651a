#include "ui/timeline/timeline_panel.h"

#include <algorithm>

#include <imgui.h>

#include "family/family_time.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Heights of the parts, and the distance between them; at scale 1.
constexpr float ruler_height = 15;
constexpr float track_height = 18;
constexpr float names_height = 22;
constexpr float track_gap = 5;
constexpr float min_curves_height = 20;

/// The view that follows the playhead: where it has left the view, the view turns to the page with it.
std::optional<TimeRange> following_view(const TimeScale& scale, TimeRange whole, double time) {
    const auto [begin, end] = scale.visible;
    if (begin <= time && time <= end) return std::nullopt;
    return panned(scale.visible, whole, time > end ? time - begin : time - end);
}

void show_remark(const Rect& area, std::string_view remark) {
    ImGui::PushFont(small_font());
    const float height = ImGui::GetTextLineHeight();
    const float top = area.y + std::max((area.height - height) / 2, 0.0F);
    const float width = std::min(text_size(remark).x, area.width - scaled(16));
    ImGui::GetWindowDrawList()->AddRectFilled({area.x + scaled(4), top - scaled(2)},
                                              {area.x + width + scaled(14), top + height + scaled(2)},
                                              colors::rim, scaled(3));
    draw_text({area.x + scaled(9), top}, width + 1, colors::notice, remark);
    ImGui::PopFont();
}

}  // namespace

TimeRange shown_times(TimeRange whole, const std::optional<TimeRange>& wanted) {
    if (!wanted || wanted->end <= whole.begin || wanted->begin >= whole.end) return whole;
    return {std::max(wanted->begin, whole.begin), std::min(wanted->end, whole.end)};
}

std::size_t curve_samples(float width) {
    return static_cast<std::size_t>(std::max(width / scaled(3), 8.0F));
}

TimelineResult timeline_panel(const Rect& rect, const Family& family, const TimelineState& state) {
    TimelineResult result;
    begin_panel("timeline", rect);
    const float padding = ImGui::GetStyle().WindowPadding.x;
    result.transport = show_transport(state.transport, rect.width - 2 * padding);

    const float margin = padding + scaled(14);
    const float top =
        rect.y + ImGui::GetStyle().WindowPadding.y + ImGui::GetFrameHeight() + scaled(track_gap);
    const float width = std::max(rect.width - 2 * margin, 1.0F);
    TrackLayout layout;
    layout.ruler = {rect.x + margin, top, width, scaled(ruler_height)};
    layout.track = {layout.ruler.x, layout.ruler.bottom(), width, scaled(track_height)};
    layout.names = {layout.ruler.x, layout.track.bottom(), width, scaled(names_height)};
    const float curves_top = layout.names.bottom() + scaled(track_gap);
    const float bottom = rect.bottom() - ImGui::GetStyle().WindowPadding.y;
    const float plots_height = state.plots != nullptr ? scaled(blend_plots_height) : 0;
    const Rect curves{layout.ruler.x, curves_top, width, bottom - plots_height - curves_top};
    const bool has_curves = curves.height >= scaled(min_curves_height);

    const TimeRange whole = interval_of(family, state.transport.source);
    const TimeScale scale{shown_times(whole, state.visible), layout.track};
    result.area = layout.track;
    result.track = show_track(layout, family, scale, whole,
                              {.time = state.transport.time,
                               .drives = state.drives,
                               .range = state.range,
                               .drag = state.drag,
                               .source = state.transport.source});
    if (has_curves) {
        ImGui::SetCursorScreenPos({curves.x, curves.y});
        mouse_area("curves", {curves.width, curves.height});
        if (ImGui::IsItemActive())
            result.track.seek_to =
                std::clamp(scale.time(ImGui::GetIO().MousePos.x), scale.visible.begin, scale.visible.end);
        if (const auto moved = moved_view(scale, whole)) result.track.visible = moved;
        draw_weight_curves(curves, scale, state.curves, state.transport.time,
                           state.drives ? state.weights : Weights{});
    }
    if (state.plots != nullptr && bottom - plots_height >= layout.names.y) {
        const float gap = scaled(track_gap);
        blend_plots({layout.ruler.x, bottom - plots_height + gap, width, plots_height - gap}, scale,
                    *state.plots, state.transport.time);
    }
    if (!state.drives) show_remark(has_curves ? curves : layout.names, state.remark);
    if (!result.track.visible && state.transport.playing && state.visible)
        result.track.visible = following_view(scale, whole, state.transport.time);
    end_panel();
    return result;
}

}  // namespace interleaf
