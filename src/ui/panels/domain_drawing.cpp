#include "ui/panels/domain_drawing.h"

#include <algorithm>
#include <array>

#include <glm/geometric.hpp>
#include <imgui.h>

#include "render/palette.h"
#include "ui/widgets/short_name.h"
#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Diameter of a key's picture, and the distance to the next vertex that gives it room; at scale 1.
constexpr float picture_size = 38;
constexpr float picture_room = 58;

/// With more visible vertices than this, no picture has room.
constexpr std::size_t max_key_pictures = 64;

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

void draw_line(ImDrawList& list, std::span<const glm::dvec2> path, const PlotFrame& frame, ImU32 color,
               float width) {
    // Dear ImGui's indices have 16 bits, so one line has a limited number of points.
    constexpr int max_points = 4096;
    const auto stroke = [&] { list.PathStroke(color, ImDrawFlags_None, scaled(width)); };
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

bool is_inside(const Rect& area, glm::vec2 pixel) {
    return area.x <= pixel.x && pixel.x <= area.right() && area.y <= pixel.y && pixel.y <= area.bottom();
}

bool overlap(const Rect& a, const Rect& b) {
    return a.x < b.right() && b.x < a.right() && a.y < b.bottom() && b.y < a.bottom();
}

/// A vertex that is in the drawing.
struct VisibleVertex {
    glm::vec2 pixel;
    std::size_t key;
};

std::vector<VisibleVertex> visible_vertices(const DomainDrawing& drawing) {
    std::vector<VisibleVertex> visible;
    for (const DomainVertex& vertex : drawing.family.domain->vertices()) {
        const glm::vec2 pixel = drawing.frame.pixel(vertex.at);
        if (is_inside(drawing.area, pixel)) visible.push_back({pixel, vertex.key});
    }
    return visible;
}

bool has_room(const std::vector<VisibleVertex>& vertices, const VisibleVertex& vertex) {
    return vertices.size() <= max_key_pictures &&
           std::ranges::none_of(vertices, [&](const VisibleVertex& other) {
               return &other != &vertex && glm::distance(other.pixel, vertex.pixel) < scaled(picture_room);
           });
}

/// Draws the vertex, and the picture of its key if there is one.
/// \param picture  texture; 0 for none
/// \return the radius
float draw_mark(ImDrawList& list, const VisibleVertex& vertex, unsigned picture) {
    const ImU32 color = to_color(key_color(vertex.key));
    const float radius = scaled(picture == 0 ? 4 : picture_size / 2);
    list.AddCircleFilled(to_imgui(vertex.pixel), radius + scaled(1), colors::dark);
    if (picture == 0) {
        list.AddCircleFilled(to_imgui(vertex.pixel), radius, color);
        return radius;
    }
    list.AddImageRounded(texture_id(picture), to_imgui(vertex.pixel - radius),
                         to_imgui(vertex.pixel + radius), {0, 0}, {1, 1}, colors::white, radius);
    list.AddCircle(to_imgui(vertex.pixel), radius, color, 0, scaled(2));
    return radius;
}

/// The place of a name of \p size at a vertex, on the side away from \p middle.
Rect name_place(const VisibleVertex& vertex, float radius, glm::vec2 size, const Rect& area, float middle) {
    const float padding = scaled(4);
    const float gap = radius + scaled(radius > scaled(5) ? 2 : 7);
    glm::vec2 corner{vertex.pixel.x - size.x / 2,
                     vertex.pixel.y > middle + 1 ? vertex.pixel.y + gap : vertex.pixel.y - gap - size.y};
    corner.x =
        std::clamp(corner.x, area.x + padding, std::max(area.right() - padding - size.x, area.x + padding));
    return {corner.x - padding, corner.y, size.x + 2 * padding, size.y + 1};
}

}  // namespace

void draw_domain(const DomainDrawing& drawing) {
    draw_triangles(*ImGui::GetWindowDrawList(), *drawing.family.domain, drawing.frame);
}

void draw_path(const DomainDrawing& drawing, std::span<const glm::dvec2> path) {
    // A dark rim, so that the line is also seen along the border of the domain in the light theme.
    ImDrawList& list = *ImGui::GetWindowDrawList();
    draw_line(list, path, drawing.frame, colors::path_rim, 4.5F);
    draw_line(list, path, drawing.frame, colors::path_line, 2);
}

std::vector<std::size_t> draw_vertices(const DomainDrawing& drawing) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const std::vector<VisibleVertex> vertices = visible_vertices(drawing);
    const float middle = drawing.frame.rect().y + drawing.frame.rect().height / 2;
    std::vector<std::size_t> pictured;
    std::vector<Rect> taken;
    std::vector<float> radii;
    radii.reserve(vertices.size());
    for (const VisibleVertex& vertex : vertices) {
        unsigned picture = 0;
        if (has_room(vertices, vertex) && vertex.key < drawing.pictures.size()) {
            pictured.push_back(vertex.key);
            picture = drawing.pictures[vertex.key];
        }
        radii.push_back(draw_mark(list, vertex, picture));
    }
    ImGui::PushFont(small_font());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const std::string& name = drawing.family.keys[vertices[i].key].name;
        const float room = drawing.area.width / 2 - scaled(8);
        glm::vec2 size = text_size(name);
        size.x = std::min(size.x, room);
        const Rect place = name_place(vertices[i], radii[i], size, drawing.area, middle);
        if (std::ranges::any_of(taken, [&](const Rect& other) { return overlap(place, other); })) continue;
        taken.push_back(place);
        list.AddRectFilled({place.x, place.y}, {place.right(), place.bottom()}, colors::label, scaled(4));
        draw_name({place.x + scaled(4), place.y}, size.x, colors::text, name);
    }
    ImGui::PopFont();
    return pictured;
}

void draw_vertex_rings(const DomainDrawing& drawing, std::optional<Index> near) {
    const auto vertices = drawing.family.domain->vertices();
    for (Index v = 0; v < vertices.size(); ++v)
        ImGui::GetWindowDrawList()->AddCircle(to_imgui(drawing.frame.pixel(vertices[v].at)),
                                              scaled(near == v ? 8 : 6), colors::notice, 0, scaled(1.5F));
}

void draw_domain_point(glm::vec2 pixel, bool is_held) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 at = to_imgui(pixel);
    list.AddCircle(at, scaled(is_held ? 9 : 8), colors::dark, 0, scaled(5));
    list.AddCircle(at, scaled(is_held ? 9 : 8), colors::white, 0, scaled(2.5F));
    list.AddCircleFilled(at, scaled(2), colors::white);
}

}  // namespace interleaf
