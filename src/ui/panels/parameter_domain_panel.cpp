#include "ui/panels/parameter_domain_panel.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "render/palette.h"
#include "ui/panels/keys_panel.h"
#include "ui/widgets/plot_frame.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Fills a triangle with one color per vertex. Dear ImGui has no function for it, but its vertices carry
/// colors.
void fill_triangle(ImDrawList& list, const std::array<glm::vec2, 3>& corners,
                   const std::array<ImU32, 3>& fills) {
    const ImVec2 white = ImGui::GetFontTexUvWhitePixel();
    list.PrimReserve(3, 3);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        list.PrimVtx(to_imgui(corners[corner]), white, fills[corner]);
    }
}

void draw_triangles(ImDrawList& list, const ParameterDomain& domain, const PlotFrame& frame) {
    const auto pixel = [&](Index vertex) { return frame.pixel(domain.vertices()[vertex].at); };
    const auto fill = [&](Index vertex) {
        return to_color(0.78F * key_color(domain.vertices()[vertex].key));
    };
    for (const Triangle& t : domain.triangles()) {
        fill_triangle(list, {pixel(t[0]), pixel(t[1]), pixel(t[2])}, {fill(t[0]), fill(t[1]), fill(t[2])});
    }
    for (const Triangle& t : domain.triangles()) {
        list.AddTriangle(to_imgui(pixel(t[0])), to_imgui(pixel(t[1])), to_imgui(pixel(t[2])),
                         IM_COL32(12, 13, 16, 110), scaled(1));
    }
}

void draw_path(ImDrawList& list, std::span<const glm::dvec2> path, const PlotFrame& frame) {
    // Dear ImGui's indices have 16 bits, so one line has a limited number of points.
    constexpr int max_points = 4096;
    const auto stroke = [&] { list.PathStroke(IM_COL32(255, 255, 255, 150), ImDrawFlags_None, scaled(2)); };
    std::optional<glm::vec2> last;
    for (const glm::dvec2 at : path) {
        const glm::vec2 pixel = frame.pixel(at);
        if (last && glm::distance(*last, pixel) < 0.5F) continue;
        last = pixel;
        list.PathLineTo(to_imgui(pixel));
        if (list._Path.Size < max_points) continue;
        stroke();
        list.PathLineTo(to_imgui(pixel));
    }
    stroke();
}

/// Draws a vertex with its key's name, on the side away from the middle of the domain.
void draw_vertex(ImDrawList& list, glm::vec2 pixel, const Key& key, ImU32 color, const Rect& area,
                 float middle) {
    list.AddCircleFilled(to_imgui(pixel), scaled(5), colors::dark);
    list.AddCircleFilled(to_imgui(pixel), scaled(4), color);

    const float padding = scaled(4);
    const float room = area.width / 2 - 2 * padding;
    glm::vec2 size = text_size(key.name);
    size.x = std::min(size.x, room);
    const float gap = scaled(11);
    glm::vec2 corner{pixel.x - size.x / 2, pixel.y > middle + 1 ? pixel.y + gap : pixel.y - gap - size.y};
    corner.x =
        std::clamp(corner.x, area.x + padding, std::max(area.right() - padding - size.x, area.x + padding));
    list.AddRectFilled(to_imgui(corner - glm::vec2(padding, 0)),
                       to_imgui(corner + size + glm::vec2(padding, 1)), IM_COL32(12, 13, 16, 170), scaled(4));
    draw_text(corner, size.x + 1, colors::text, key.name);
}

void draw_point(ImDrawList& list, glm::vec2 pixel, bool held) {
    const ImVec2 at = to_imgui(pixel);
    list.AddCircle(at, scaled(held ? 9 : 8), colors::dark, 0, scaled(5));
    list.AddCircle(at, scaled(held ? 9 : 8), colors::white, 0, scaled(2.5F));
    list.AddCircleFilled(at, scaled(2), colors::white);
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
        if (ImGui::MenuItem(family.keys[key].name.c_str(), nullptr, present == key)) chosen = key;
        ImGui::PopID();
    }
    return chosen;
}

void show_menu(const Family& family, const DomainMenu& place, ParameterDomainResult& result) {
    if (place.vertex && *place.vertex < family.domain->vertices().size()) {
        heading("Key at this vertex");
        if (const auto key = choose_key(family, family.domain->vertices()[*place.vertex].key))
            result.assigned = VertexKey{*place.vertex, *key};
        ImGui::Separator();
        if (ImGui::MenuItem("Remove vertex")) result.removed = place.vertex;
    } else {
        heading("Add a vertex here, of key");
        if (const auto key = choose_key(family, std::nullopt)) result.added = AddedVertex{place.at, *key};
    }
}

/// The drag on the canvas, if there is one. The canvas is the last item and shows \p box.
std::optional<DomainDrag> follow_drag(const ParameterDomain& domain, const DomainPanel& panel,
                                      const DomainBox& box, const PlotFrame& frame) {
    if (!ImGui::IsItemActive()) return std::nullopt;
    if (panel.drag && !ImGui::IsItemActivated()) return panel.drag;
    const glm::vec2 pointer = from_imgui(ImGui::GetIO().MousePos);
    return DomainDrag{box, panel.edits ? vertex_near(domain, frame, pointer) : std::nullopt};
}

/// Reads the mouse on the canvas, which is the last item.
void read_mouse(const Family& family, const DomainPanel& panel, const PlotFrame& frame,
                ParameterDomainResult& result) {
    const ParameterDomain& domain = *family.domain;
    const glm::vec2 pointer = from_imgui(ImGui::GetIO().MousePos);
    if (result.drag) {
        const auto vertex = result.drag->vertex;
        if (!panel.edits) {
            result.moved_to = frame.point(pointer);
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

/// Shows the context menu of the canvas, which is the last item.
void show_canvas_menu(const Family& family, const DomainPanel& panel, const PlotFrame& frame,
                      ParameterDomainResult& result) {
    result.menu = panel.menu;
    if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) {
        const glm::vec2 pointer = from_imgui(ImGui::GetIO().MousePos);
        result.menu = DomainMenu{vertex_near(*family.domain, frame, pointer), frame.point(pointer)};
        ImGui::OpenPopup("domain menu");
    }
    if (!ImGui::BeginPopup("domain menu")) return;
    if (result.menu) show_menu(family, *result.menu, result);
    ImGui::EndPopup();
}

/// \return whether it was pressed
bool recording_button(bool is_recording, float width) {
    if (is_recording) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    const bool is_pressed =
        ImGui::Button(is_recording ? "End recording##path" : "Record path##path", {width, 0});
    if (is_recording) ImGui::PopStyleColor();
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s", is_recording ? "The drag becomes the path (P)"
                                             : "Then drag the point: its way becomes a path over time (P)");
    return is_pressed;
}

}  // namespace

ParameterDomainResult parameter_domain_panel(const Family& family, const DomainPanel& panel) {
    const ParameterDomain& domain = *family.domain;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float heading_height = ImGui::GetTextLineHeightWithSpacing();

    // Leave room for the names of the vertices above and below, and for half of the point at the sides.
    const float margin = scaled(30);
    const float side_margin = scaled(14);
    const float width = ImGui::GetContentRegionAvail().x;
    const Rect widest{corner.x + side_margin, corner.y + heading_height + margin, width - 2 * side_margin,
                      std::min(scaled(260), 0.4F * ImGui::GetWindowHeight())};
    const DomainBox box = panel.drag ? panel.drag->box : box_of(domain.vertices());
    const Rect plot = PlotFrame(box, widest).rect();
    const Rect area{corner.x, corner.y + heading_height, width, std::round(plot.height) + 2 * margin};
    const PlotFrame frame(box, {plot.x, widest.y, plot.width, plot.height});

    ImGui::SetCursorScreenPos({area.x, area.y});
    ImGui::InvisibleButton("domain", {area.width, area.height});
    const bool held = ImGui::IsItemActive() && !panel.edits;
    const glm::vec2 pointer = from_imgui(ImGui::GetIO().MousePos);
    const bool is_hovered = ImGui::IsItemHovered();
    ParameterDomainResult result;
    result.plot = frame.rect();
    result.snap = glm::distance(frame.point({0, 0}), frame.point({scaled(6), 0}));
    result.drag = follow_drag(domain, panel, box, frame);
    read_mouse(family, panel, frame, result);
    show_canvas_menu(family, panel, frame, result);

    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, colors::well, scaled(4));
    if (panel.edits)
        list.AddRect({area.x, area.y}, {area.right(), area.bottom()}, colors::notice, scaled(4), 0,
                     scaled(1));
    draw_triangles(list, domain, frame);
    draw_path(list, panel.path, frame);
    ImGui::PushFont(small_font());
    const float middle = frame.rect().y + frame.rect().height / 2;
    const auto near = panel.edits && is_hovered ? vertex_near(domain, frame, pointer) : std::nullopt;
    for (Index v = 0; v < domain.vertices().size(); ++v) {
        const DomainVertex& vertex = domain.vertices()[v];
        draw_vertex(list, frame.pixel(vertex.at), family.keys[vertex.key], to_color(key_color(vertex.key)),
                    area, middle);
        if (panel.edits)
            list.AddCircle(to_imgui(frame.pixel(vertex.at)), scaled(near == v ? 8 : 6), colors::notice, 0,
                           scaled(1.5F));
    }
    ImGui::PopFont();
    if (panel.point && !panel.edits) draw_point(list, frame.pixel(panel.point->at), held);

    const ImVec2 after = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(corner);
    heading("Parameter domain", panel.edits          ? "drag vertices (D)"
                                : panel.is_recording ? "drag the point"
                                : panel.point
                                    ? fmt::format("{:.3f}, {:.3f}", panel.point->at.x, panel.point->at.y)
                                    : std::string());
    ImGui::SetCursorScreenPos(after);
    result.toggles_recording = recording_button(panel.is_recording, width);
    return result;
}

}  // namespace interleaf
