#include "ui/panels/parameter_domain_panel.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/core.h>
#include <glm/geometric.hpp>
#include <imgui.h>
#include <imgui_internal.h>

#include "family/family_time.h"
#include "ui/panels/domain_drawing.h"
#include "ui/panels/domain_view.h"
#include "ui/panels/keys_panel.h"
#include "ui/widgets/command_keys.h"
#include "ui/widgets/plot_frame.h"
#include "ui/widgets/section.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"
#include "ui/widgets/tooltip.h"

namespace interleaf {

namespace {

/// The path whose points the user can edit: the one that drives, while the domain is edited. Null for none.
const DomainPath* edited_path(const Family& family, const DomainPanel& panel) {
    return panel.edits && source_of_time(family) == TimeSource::path ? &*family.path : nullptr;
}

/// The selected point of the edited path.
std::optional<std::size_t> selected_point(const Family& family, const DomainPanel& panel) {
    const DomainPath* const path = edited_path(family, panel);
    return path != nullptr && panel.selected && *panel.selected < path->points().size() ? panel.selected
                                                                                        : std::nullopt;
}

/// The vertex nearest to the pointer; none if all are too far away.
std::optional<Index> vertex_near(const ParameterDomain& domain, const PlotFrame& frame, glm::vec2 pointer) {
    std::optional<Index> nearest;
    float distance = scaled(10);
    for (Index vertex = 0; vertex < domain.vertices().size(); ++vertex) {
        const float here = glm::distance(frame.pixel(domain.vertices()[vertex].at), pointer);
        if (here >= distance) continue;
        nearest = vertex;
        distance = here;
    }
    return nearest;
}

/// Offers the keys of the family in a menu, which marks \p present.
std::optional<std::size_t> choose_key(const Family& family, std::optional<std::size_t> present) {
    std::optional<std::size_t> chosen;
    for (std::size_t key = 0; key < family.keys.size(); ++key) {
        ImGui::PushID(static_cast<int>(key));
        if (name_item(family.keys[key].name, scaled(240), present == key)) chosen = key;
        ImGui::PopID();
    }
    return chosen;
}

void show_menu(const Family& family, const DomainPanel& panel, const DomainMenu& place,
               ParameterDomainResult& result) {
    if (const DomainPath* const path = edited_path(family, panel);
        path != nullptr && place.path && place.path->is_of(*path)) {
        show_path_menu(*path, *place.path, place.at, result.path);
        if (!place.path->is_line) return;
        ImGui::Separator();
    }
    if (place.vertex && *place.vertex < family.domain->vertices().size()) {
        heading("Key at this vertex");
        if (const auto key = choose_key(family, family.domain->vertices()[*place.vertex].key))
            result.assigned = VertexKey{*place.vertex, *key};
        ImGui::Separator();
        if (ImGui::MenuItem("Set place...")) result.asked_place = place.vertex;
        if (ImGui::MenuItem("Remove vertex")) result.removed = place.vertex;
    } else {
        heading("Add a vertex here, of key");
        if (const auto key = choose_key(family, std::nullopt)) result.added = AddedVertex{place.at, *key};
    }
}

/// What the pointer touches while the domain is edited: a point of the path, a vertex, or the path's line.
struct Touched {
    std::optional<Index> vertex;
    std::optional<PathPart> path;
};

Touched touched(const Family& family, const DomainPanel& panel, const PlotFrame& frame, glm::vec2 pointer) {
    Touched here;
    if (!panel.edits) return here;
    if (const DomainPath* const path = edited_path(family, panel))
        here.path = path_part_near(*path, frame, pointer);
    if (!here.path || here.path->is_line) here.vertex = vertex_near(*family.domain, frame, pointer);
    if (here.vertex) here.path.reset();
    return here;
}

/// The drag on the canvas, if there is one. The canvas is the last item and shows \p box.
std::optional<DomainDrag> follow_drag(const Family& family, const DomainPanel& panel, const DomainBox& box,
                                      const PlotFrame& frame) {
    if (!ImGui::IsItemActive()) return std::nullopt;
    if (panel.drag && !ImGui::IsItemActivated()) return panel.drag;
    const Touched here = touched(family, panel, frame, from_imgui(ImGui::GetIO().MousePos));
    return DomainDrag{box, here.vertex, here.path};
}

/// Drags the part of \p path that the mouse holds. From a line it draws out a new point, which it then holds;
/// its time is that of the line where the button was pressed.
void drag_path(const DomainPath& path, const PlotFrame& frame, ParameterDomainResult& result) {
    PathPart& held = *result.drag->path;
    if (!held.is_of(path)) return;
    if (!held.is_line && ImGui::IsItemActivated()) result.path.selected = held.place;
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left)) return;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::dvec2 to = frame.point(from_imgui(io.MousePos));
    if (held.is_line) {
        const glm::dvec2 pressed = frame.point(from_imgui(io.MouseClickedPos[ImGuiMouseButton_Left]));
        result.path.inserted = PathPoint{point_on_line(path, held.place, pressed).time, to};
        held = {held.place + 1, false};
    } else {
        result.path.moved = MovedPathPoint{held.place, to};
    }
}

/// Reads the mouse on the canvas, which is the last item.
void read_mouse(const Family& family, const DomainPanel& panel, const PlotFrame& frame,
                ParameterDomainResult& result) {
    const ParameterDomain& domain = *family.domain;
    const glm::vec2 pointer = from_imgui(ImGui::GetIO().MousePos);
    if (result.drag) {
        const auto vertex = result.drag->vertex;
        const DomainPath* const path = edited_path(family, panel);
        if (!panel.edits) {
            result.moved_to = frame.point(pointer);
        } else if (result.drag->path && path != nullptr) {
            drag_path(*path, frame, result);
        } else if (vertex && *vertex < domain.vertices().size() &&
                   ImGui::IsMouseDragging(ImGuiMouseButton_Left)) {
            result.moved_vertex = MovedVertex{*vertex, frame.point(pointer)};
        }
    }
    if (const auto key = dropped_key(family.keys.size())) {
        if (const auto vertex = vertex_near(domain, frame, pointer)) {
            result.assigned = VertexKey{*vertex, *key};
        } else {
            result.added = AddedVertex{frame.point(pointer), *key};
        }
    }
}

/// The direction of the arrow keys that were pressed, v up.
glm::dvec2 pressed_arrows() {
    const auto is_pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)) ? 1 : 0; };
    return {is_pressed(ImGuiKey_RightArrow) - is_pressed(ImGuiKey_LeftArrow),
            is_pressed(ImGuiKey_UpArrow) - is_pressed(ImGuiKey_DownArrow)};
}

/// Arrow keys move the point, or the selected point of the path, by a hundredth of the visible part; with Shift
/// by a thousandth.
/// \param visible  the visible part of the domain
void read_keys(const Family& family, const DomainPanel& panel, const DomainBox& visible,
               ParameterDomainResult& result) {
    const ImGuiIO& io = ImGui::GetIO();
    if (!panel.has_focus || !panel.reads_keys || io.KeyCtrl || io.KeyAlt) return;
    const std::optional<std::size_t> selected = selected_point(family, panel);
    if (selected && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Delete))) result.path.removed = selected;
    const glm::dvec2 arrows = pressed_arrows();
    if (arrows == glm::dvec2(0)) return;
    const glm::dvec2 size = visible.high - visible.low;
    const glm::dvec2 way = arrows * (std::max(size.x, size.y) * (io.KeyShift ? 0.001 : 0.01));
    if (selected)
        result.path.moved = MovedPathPoint{*selected, family.path->points()[*selected].at + way};
    else if (!panel.edits)
        result.moved_to = (panel.point ? panel.point->at : (visible.low + visible.high) / 2.0) + way;
}

/// Shows the context menu of the canvas, which is the last item.
void show_canvas_menu(const Family& family, const DomainPanel& panel, const PlotFrame& frame,
                      ParameterDomainResult& result) {
    result.menu = panel.menu;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        const glm::vec2 pointer = from_imgui(ImGui::GetIO().MousePos);
        const Touched here = touched(family, panel, frame, pointer);
        result.menu = DomainMenu{here.path ? std::nullopt : vertex_near(*family.domain, frame, pointer),
                                 here.path, frame.point(pointer)};
        ImGui::OpenPopup("domain menu");
    }
    if (!ImGui::BeginPopup("domain menu")) return;
    if (result.menu) show_menu(family, panel, *result.menu, result);
    ImGui::EndPopup();
}

/// \return whether it was pressed
bool recording_button(bool is_recording, float width) {
    if (is_recording) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool is_pressed =
        ImGui::Button(is_recording ? "End recording##path" : "Record path##path", {width, 0});
    if (is_recording) ImGui::PopStyleColor();
    tooltip(with_keys(
        is_recording ? "The drag becomes the path" : "Then drag the point: its way becomes a path over time",
        {"Record path"}));
    return is_pressed;
}

/// The row of buttons below the domain.
void show_buttons(const DomainPanel& panel, const DomainBox& whole, float width,
                  ParameterDomainResult& result) {
    const float gap = ImGui::GetStyle().ItemSpacing.x;
    const float part = panel.view ? std::floor((width - gap) * 0.6F) : width;
    result.toggles_recording = recording_button(panel.is_recording, part);
    if (!panel.view) return;
    ImGui::SameLine();
    if (ImGui::Button("Show all##domain", {width - gap - part, 0})) result.view = whole;
    tooltip(with_keys("Show the whole domain", {"Show whole domain"}));
}

std::string remark_of(const Family& family, const DomainPanel& panel) {
    if (const auto selected = selected_point(family, panel))
        return fmt::format("point {} of {}, {:.6g} s", *selected + 1, family.path->points().size(),
                           family.path->points()[*selected].time);
    if (edited_path(family, panel) != nullptr) return with_keys("drag vertices, path", {"Edit domain"});
    if (panel.edits) return with_keys("drag vertices", {"Edit domain"});
    if (panel.is_recording) return "drag the point";
    return panel.point ? fmt::format("{:.3f}, {:.3f}", panel.point->at.x, panel.point->at.y) : std::string();
}

/// The heading above the domain. A click on the coordinates asks for others.
/// \return whether the domain is to be shown below it
bool show_heading(const Family& family, const DomainPanel& panel, ParameterDomainResult& result) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float right = corner.x + ImGui::GetContentRegionAvail().x;
    const std::string remark = remark_of(family, panel);
    const bool is_open = section(
        "Parameter domain", remark,
        "Each vertex is a key. The point blends the keys of its triangle: drag it, or click to place it.\n"
        "The wheel zooms. Right-click to add, move or remove vertices.");
    if (panel.edits || panel.is_recording || remark.empty()) return is_open;
    const ImVec2 after = ImGui::GetCursorScreenPos();
    ImGui::PushFont(small_font());
    const glm::vec2 size = text_size(remark);
    ImGui::PopFont();
    ImGui::SetCursorScreenPos({right - size.x, corner.y});
    if (mouse_area("place", {size.x, size.y})) result.asks_for_place = true;
    if (ImGui::IsItemHovered()) {
        ImGui::GetWindowDrawList()->AddLine({right - size.x, corner.y + size.y}, {right, corner.y + size.y},
                                            colors::dim_text);
        ImGui::SetTooltip("%s", with_keys("Type the place of the point", {"Go to place"}).c_str());
    }
    ImGui::SetCursorScreenPos(after);
    return is_open;
}

void draw_canvas(const Family& family, const DomainPanel& panel, const DomainDrawing& drawing,
                 bool is_hovered, ParameterDomainResult& result) {
    const auto& [x, y, width, height] = drawing.area;
    const ImVec2 corner{x, y};
    const ImVec2 end{drawing.area.right(), drawing.area.bottom()};
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(corner, end, colors::well, scaled(4));
    list.PushClipRect(corner, end, true);
    draw_domain(drawing);
    draw_path(drawing, panel.path);
    result.pictured = draw_vertices(drawing);
    if (panel.edits) {
        const glm::vec2 pointer = from_imgui(ImGui::GetIO().MousePos);
        const Touched here = is_hovered ? touched(family, panel, drawing.frame, pointer) : Touched{};
        draw_vertex_rings(drawing, here.vertex);
        if (const DomainPath* const path = edited_path(family, panel))
            draw_path_points(*path, drawing.frame, selected_point(family, panel), here.path, pointer);
    } else if (panel.point) {
        draw_domain_point(drawing.frame.pixel(panel.point->at), result.drag.has_value());
    }
    list.PopClipRect();
    if (panel.edits) list.AddRect(corner, end, colors::notice, scaled(4), 0, scaled(1));
    if (panel.has_focus) list.AddRect(corner, end, colors::accent, scaled(4), 0, scaled(2));
}

}  // namespace

ParameterDomainResult parameter_domain_panel(const Family& family, const DomainPanel& panel) {
    ParameterDomainResult result;
    if (!show_heading(family, panel, result)) return result;
    const ImVec2 corner = ImGui::GetCursorScreenPos();

    // Leave room for pictures and names of the vertices.
    const float margin = scaled(38);
    const float side_margin = scaled(24);
    const float width = ImGui::GetContentRegionAvail().x;
    // The height must not depend on the scrollbar of the panel: the panel would show and hide it in turns.
    const ImGuiStyle& style = ImGui::GetStyle();
    const float narrow = ImGui::GetWindowWidth() - 2 * style.WindowPadding.x - style.ScrollbarSize;
    const Rect widest{corner.x + (width - narrow) / 2 + side_margin, corner.y + margin,
                      narrow - 2 * side_margin,
                      std::max(0.5F * ImGui::GetWindowHeight() - margin, scaled(60))};
    const DomainBox whole = box_of(family.domain->vertices());
    const DomainBox box = panel.drag ? panel.drag->box : shown_part(whole, panel.view);
    const Rect plot = PlotFrame(box, widest).rect();
    const Rect area{corner.x, corner.y, width, std::round(plot.height) + 2 * margin};
    const PlotFrame frame(box, {plot.x, widest.y, plot.width, plot.height});

    ImGui::SetCursorScreenPos({area.x, area.y});
    mouse_area("domain", {area.width, area.height});
    const bool is_hovered = ImGui::IsItemHovered();
    const glm::vec2 low = frame.pixel(whole.low);
    const glm::vec2 high = frame.pixel(whole.high);
    result.plot = {low.x, high.y, high.x - low.x, low.y - high.y};
    result.snap = glm::distance(frame.point({0, 0}), frame.point({scaled(6), 0}));
    if (ImGui::IsMouseClicked(ImGuiMouseButton_Left) && is_hovered != panel.has_focus)
        result.focus = is_hovered;
    ImGui::SetItemUsingMouseWheel();
    result.drag = follow_drag(family, panel, box, frame);
    if (!result.drag) result.view = moved_view(frame, box, whole);
    read_mouse(family, panel, frame, result);
    read_keys(family, panel, box, result);
    show_canvas_menu(family, panel, frame, result);

    draw_canvas(family, panel,
                {family, frame, area, panel.edits ? std::span<const unsigned>() : panel.pictures}, is_hovered,
                result);

    show_buttons(panel, whole, width, result);
    return result;
}

bool domain_offer() {
    if (!section("Parameter domain", "none",
                 "A plane with a key at each vertex, whose point blends the keys around it."))
        return false;
    const bool is_wanted = ImGui::Button("New domain", {ImGui::GetContentRegionAvail().x, 0});
    tooltip(with_keys("Place the keys in a plane, and blend them by a point between them", {"New domain"}));
    return is_wanted;
}

}  // namespace interleaf
