#include "app/window/window_panels.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>

#include "app/brushing/brush_stroke.h"
#include "app/document/shown_shading.h"
#include "app/pictures/detail_surface.h"
#include "family/family_time.h"
#include "family/new_family.h"
#include "ui/panels/detail_panel.h"
#include "ui/panels/display_panel.h"
#include "ui/panels/status_line.h"
#include "ui/splitters.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

std::vector<MenuEntry> entries_of(const ViewerState& state, const Shortcuts& shortcuts) {
    std::vector<MenuEntry> entries;
    entries.reserve(commands().size());
    for (const Command& command : commands()) entries.push_back(menu_entry(command, state, shortcuts));
    return entries;
}

Submenu recent_menu(std::span<const std::filesystem::path> files) {
    Submenu menu{
        .menu = "File", .after = command_of(CommandId::open).name, .name = "Open recent", .items = {}};
    for (const std::filesystem::path& file : files) menu.items.push_back(file.string());
    return menu;
}

/// The points of the path, if it drives; otherwise those through which a linear timeline passes. None for other
/// interpolations, whose weights are hardly ever those of a point.
std::vector<glm::dvec2> path_through_domain(const Family& family) {
    std::vector<glm::dvec2> path;
    if (!family.domain) return path;
    if (source_of_time(family) == TimeSource::path) {
        for (const PathPoint& point : family.path->points()) path.push_back(point.at);
        return path;
    }
    if (!family.timeline) return path;
    if (family.timeline->interpolation().basis != Basis::linear) return path;
    for (const TimelineKey& key : family.timeline->keys()) {
        if (const auto at = family.domain->point_of(family.timeline->at(key.time))) path.push_back(*at);
    }
    return path;
}

const char* remark_of(const Session& session) {
    if (session.driver() == Driver::weights)
        return "Sliders set the weights: scrub or press Space to follow the timeline again";
    if (session.driver() == Driver::key)
        return "One key is shown alone: scrub or press Space to follow the timeline again";
    return source_of_time(session.family()) == TimeSource::path
               ? "Point moved off the path: scrub or press Space to follow it again"
               : "Point moved off the timeline's path: scrub or press Space to follow it again";
}

KeysPanelResult show_keys(const WindowContent& shown) {
    const ViewerState& state = shown.state;
    const auto& keys = state.document.family().keys;
    std::vector<KeyRow> rows;
    for (std::size_t key = 0; key < std::min(keys.size(), shown.portraits.size()); ++key) {
        rows.push_back({.name = keys[key].name,
                        .leaves = shown.portraits[key].leaves,
                        .deepest = shown.portraits[key].deepest,
                        .picture = shown.portraits[key].picture.name()});
    }
    std::vector<MenuEntry> entries;
    for (const Command* const command : key_commands())
        entries.push_back(menu_entry(*command, state, shown.shortcuts));
    return keys_panel({.keys = rows,
                       .weights = state.session.weights(),
                       .selected = state.selected_key,
                       .menu = entries,
                       .search = state.key_search,
                       .takes_focus = state.find_wanted && !state.help_shown},
                      0.5F * shown.layout.panels.view.height);
}

void show_keys_and_display(const WindowContent& shown, WindowResult& result) {
    result.actions.keys = show_keys(shown);
    result.layout.keys = result.actions.keys->list;
    section_gap();
    const SurfaceFigures& figures = shown.figures;
    const Display& display = shown.state.session.display;
    DisplayPanelResult wanted = display_panel(display, {.levels = figures.levels,
                                                        .origins = figures.origins,
                                                        .active_keys = figures.keys,
                                                        .active_names = figures.key_names,
                                                        .fields = shown.fields,
                                                        .key_without_field = figures.key_without_field,
                                                        .curves = shown.field_curves,
                                                        .time = shown.state.session.time(),
                                                        .measured = shown.measured_scale,
                                                        .shading = shown_shading(shown.state.session),
                                                        .is_flat = shown.is_flat});
    if (wanted.display != display) result.actions.display = std::move(wanted.display);
    result.actions.asks_for_unit = wanted.asks_for_unit;
    result.legend_keys = figures.key_names;
}

void show_detail(const WindowContent& shown, WindowResult& result) {
    const Display& display = shown.state.session.display;
    const DetailChoice choice{display.detail, display.follows_camera};
    const DetailChoice wanted = detail_panel(choice, shown.figures.leaves, shown.follows_camera);
    if (wanted == choice) return;
    result.actions.display = display;
    result.actions.display->detail = wanted.detail;
    result.actions.display->follows_camera = wanted.follows_camera;
}

void show_domain(const WindowContent& shown, WindowResult& result) {
    const ViewerState& state = shown.state;
    const std::vector<glm::dvec2> path = path_through_domain(state.document.family());
    std::vector<unsigned> pictures;
    pictures.reserve(shown.portraits.size());
    for (const KeyPortrait& portrait : shown.portraits) pictures.push_back(portrait.picture.name());
    result.actions.domain =
        parameter_domain_panel(state.document.family(), {.point = state.session.point(),
                                                         .path = path,
                                                         .is_recording = state.recording.has_value(),
                                                         .edits = state.edits_domain,
                                                         .has_focus = state.domain_has_focus,
                                                         .reads_keys = shown.has_keyboard,
                                                         .selected = state.selected_path_point,
                                                         .view = state.shown_domain,
                                                         .pictures = pictures,
                                                         .drag = shown.holds.domain,
                                                         .menu = shown.holds.domain_menu});
    result.layout.domain = result.actions.domain->plot;
}

TransportState transport_of(const Session& session) {
    const Family& family = session.family();
    return {.time = session.time(),
            .end = session.playback().end(),
            .unit = unit_of(family, source_of_time(family).value_or(TimeSource::keys)),
            .unit_name = unit_name_of(family, source_of_time(family).value_or(TimeSource::keys)),
            .playing = session.is_playing(),
            .plays_back = session.plays_back(),
            .repeat = session.playback().repeat(),
            .speed = session.playback().speed(),
            .frame_rate = session.frame_rate,
            .interpolation = family.timeline ? family.timeline->interpolation() : Interpolation{},
            .blend = family.blend,
            .source = source_of_time(family).value_or(TimeSource::keys),
            .has_both_sources = family.timeline && family.path};
}

std::optional<TimeRange> in_and_out_of(const Playback& playback) {
    return playback.has_range() ? std::optional(playback.range()) : std::nullopt;
}

void show_timeline(const WindowContent& shown, WindowResult& result) {
    const Session& session = shown.state.session;
    result.actions.timeline = timeline_panel(shown.layout.panels.timeline, shown.state.document.family(),
                                             {.transport = transport_of(session),
                                              .drives = session.driver() == Driver::timeline,
                                              .remark = remark_of(session),
                                              .range = in_and_out_of(session.playback()),
                                              .visible = shown.state.shown_times,
                                              .drag = shown.holds.time,
                                              .curves = shown.curves,
                                              .plots = shown.state.plots_blend ? shown.blend_curves : nullptr,
                                              .weights = session.weights()});
    result.layout.timeline = result.actions.timeline->area;
}

InspectorResult show_inspector(const InspectedNode& node, const Shortcuts& table, const Rect& view) {
    constexpr std::array commands_of_steps = {CommandId::go_to_parent,          CommandId::go_to_sibling,
                                              CommandId::go_to_first_child,     CommandId::go_to_second_child,
                                              CommandId::cross_refinement_edge, CommandId::cross_second_edge,
                                              CommandId::cross_third_edge};
    static_assert(commands_of_steps.size() == all_node_steps.size());
    std::array<std::string, commands_of_steps.size()> shortcuts;
    std::ranges::transform(commands_of_steps, shortcuts.begin(),
                           [&](CommandId id) { return table.text(command_of(id)); });
    return inspector_panel(node, shortcuts, view);
}

void show_brush(const WindowContent& shown, WindowResult& result) {
    const Brush& brush = shown.state.brush;
    result.actions.brush = brush_bar(shown.layout.panels.view,
                                     {.is_on = brush.is_on,
                                      .hint = brush_hint(shown.state),
                                      .is_over_surface = shown.is_over_surface,
                                      .reads_keys = shown.has_keyboard,
                                      .settings = {brush.radius, brush.refined_level, brush.coarsened_level},
                                      .min_radius = min_brush_radius,
                                      .max_radius = max_brush_radius,
                                      .deepest_level = max_brush_level},
                                     shown.holds.brush, *result.actions.view);
}

void show_document(const WindowContent& shown, WindowResult& result) {
    const Family& family = shown.state.document.family();
    const Weights& weights = shown.state.session.weights();
    const Layout& panels = shown.layout.panels;
    result.weights = weights;
    if (shown.state.camera.shows_axes) result.actions.axes = axes_widget(panels.view, shown.camera_axes);
    result.actions.view = view_area(panels.view);
    for (std::size_t n = 0; n < shown.layout.key_views.size(); ++n)
        result.actions.key_views.push_back(
            view_area(shown.layout.key_views[n], fmt::format("key {}", n).c_str()));
    show_brush(shown, result);
    if (panels.left) {
        begin_panel("left", *panels.left);
        show_keys_and_display(shown, result);
        end_panel();
    }
    begin_panel("right", panels.right);
    if (family.domain) {
        show_domain(shown, result);
        section_gap();
    } else if (can_have_new_domain(family)) {
        result.actions.wants_domain = domain_offer();
        section_gap();
    }
    show_detail(shown, result);
    section_gap();
    result.actions.blend = show_blend(shown.state);
    if (!panels.left) {
        section_gap();
        show_keys_and_display(shown, result);
    }
    end_panel();
    if (shown.state.session.has_time()) show_timeline(shown, result);
    if (shown.inspected != nullptr)
        result.actions.inspector = show_inspector(*shown.inspected, shown.shortcuts, panels.view);
    status_line(panels.status,
                {.active_keys = weights.size(),
                 .leaves = shown.figures.leaves,
                 .max_leaves = shown.follows_camera ? std::optional(view_leaf_budget) : std::nullopt,
                 .vertices = shown.figures.vertices,
                 .measured_part = shown.measured_part,
                 .rebuild_milliseconds = shown.figures.rebuild_milliseconds,
                 .frame_milliseconds = shown.frame_milliseconds,
                 .report = shown.state.brush.report});
    result.actions.panel_sizes = splitters(panels, shown.state.appearance.panels, shown.layout.scale);
}

void show_message(const WindowContent& shown, const Rect& view, WindowActions& actions) {
    const Message& message = shown.state.message;
    if (message.is_fault()) {
        actions.dismisses_message = message_panel(message.text, shown.pictures, view);
        return;
    }
    const char* const offer = message.offer == MessageOffer::landmarks  ? "Set landmarks..."
                              : message.offer == MessageOffer::timeline ? "Put on timeline..."
                                                                        : nullptr;
    const NoticeResult notice = notice_panel(message.text, offer, view);
    actions.takes_offer = notice.pressed;
    actions.points_at_notice = notice.pointed_at;
    actions.dismisses_message = notice.dismissed;
}

}  // namespace

MenuEntry menu_entry(const Command& command, const ViewerState& state, const Shortcuts& shortcuts) {
    return {.menu = command.menu,
            .name = command.label != nullptr ? command.label(state) : std::string(command.name),
            .shortcut = shortcuts.text(command),
            .description = command.description,
            .on = command.is_on != nullptr && command.is_on(state),
            .enabled = is_enabled(command, state)};
}

std::vector<const Command*> key_commands() {
    std::vector<const Command*> selected;
    for (const Command& command : commands())
        if (command.scope == CommandScope::selected_key) selected.push_back(&command);
    return selected;
}

WindowResult show_window(const WindowContent& shown) {
    WindowResult result;
    result.layout = shown.layout;
    result.layout.view = shown.comparison != nullptr ? shown.layout.content : shown.layout.panels.view;
    result.family = shown.state.document.snapshot();
    const std::vector<MenuEntry> entries = entries_of(shown.state, shown.shortcuts);
    result.actions.menu =
        menu_bar(entries, recent_menu(shown.recent_files), shown.title, shown.state.menu_wanted);
    if (shown.comparison != nullptr)
        result.actions.comparison = shown.comparison->show(shown.state, shown.has_keyboard);
    else
        show_document(shown, result);
    if (shown.state.help_shown)
        result.actions.help = help_overlay(
            {.entries = entries, .search = shown.state.help_search, .takes_focus = shown.state.find_wanted},
            shown.layout.content);
    show_message(shown, result.layout.view, result.actions);
    return result;
}

}  // namespace interleaf
