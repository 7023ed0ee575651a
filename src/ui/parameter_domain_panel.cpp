#include "ui/parameter_domain_panel.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <imgui.h>

#include "render/palette.h"
#include "ui/plot_frame.h"
#include "ui/style.h"

namespace interleaf {

namespace {

/// ImDrawList has no triangle with a colour a vertex, but its vertices carry one and are interpolated.
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
    for (const glm::dvec2 at : path) list.PathLineTo(to_imgui(frame.pixel(at)));
    list.PathStroke(IM_COL32(255, 255, 255, 150), ImDrawFlags_None, scaled(2));
}

/// A vertex with its key's name, on the side that is away from the middle of the domain.
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

}  // namespace

ParameterDomainResult parameter_domain_panel(const Family& family, const std::optional<DomainPoint>& point,
                                             std::span<const glm::dvec2> path) {
    const ParameterDomain& domain = *family.domain;
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    const float heading_height = ImGui::GetTextLineHeightWithSpacing();

    // The names of the vertices need room above and below, half of the point to the sides.
    const float margin = scaled(30);
    const float side_margin = scaled(14);
    const float width = ImGui::GetContentRegionAvail().x;
    const Rect widest{corner.x + side_margin, corner.y + heading_height + margin, width - 2 * side_margin,
                      std::min(scaled(260), 0.4F * ImGui::GetWindowHeight())};
    const Rect plot = PlotFrame(domain.vertices(), widest).rect();
    const Rect area{corner.x, corner.y + heading_height, width, std::round(plot.height) + 2 * margin};
    const PlotFrame frame(domain.vertices(), {plot.x, widest.y, plot.width, plot.height});

    ImGui::SetCursorScreenPos({area.x, area.y});
    ImGui::InvisibleButton("domain", {area.width, area.height});
    const bool held = ImGui::IsItemActive();
    ParameterDomainResult result{.moved_to = std::nullopt, .plot = frame.rect()};
    // Shown where it will be after this frame, so that it does not trail behind the pointer.
    std::optional<DomainPoint> shown = point;
    if (held) {
        result.moved_to = frame.point(from_imgui(ImGui::GetIO().MousePos));
        shown = domain.locate(*result.moved_to, point ? point->triangle : no_index);
    }

    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({area.x, area.y}, {area.right(), area.bottom()}, colors::well, scaled(4));
    draw_triangles(list, domain, frame);
    draw_path(list, path, frame);
    ImGui::PushFont(small_font());
    const float middle = frame.rect().y + frame.rect().height / 2;
    for (const DomainVertex& vertex : domain.vertices()) {
        draw_vertex(list, frame.pixel(vertex.at), family.keys[vertex.key], to_color(key_color(vertex.key)),
                    area, middle);
    }
    ImGui::PopFont();
    if (shown) draw_point(list, frame.pixel(shown->at), held);

    const ImVec2 after = ImGui::GetCursorScreenPos();
    ImGui::SetCursorScreenPos(corner);
    heading("Parameter domain",
            shown ? fmt::format("{:.3f}, {:.3f}", shown->at.x, shown->at.y) : std::string());
    ImGui::SetCursorScreenPos(after);
    return result;
}

}  // namespace interleaf
