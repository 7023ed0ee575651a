#include "ui/panels/path_editing.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// Distances at scale 1: at which the pointer touches a point and a line, and between two drawn points.
constexpr float point_reach = 8;
constexpr float line_reach = 6;
constexpr float dot_distance = 7;

/// Where \p at projects to, from 0 at \p from to 1 at \p to.
double part_along(glm::dvec2 from, glm::dvec2 to, glm::dvec2 at) {
    const glm::dvec2 way = to - from;
    const double squared_length = glm::dot(way, way);
    return squared_length > 0 ? std::clamp(glm::dot(at - from, way) / squared_length, 0.0, 1.0) : 0.5;
}

void draw_dot(ImDrawList& list, glm::vec2 pixel, float radius, ImU32 color) {
    list.AddCircleFilled(to_imgui(pixel), radius + scaled(1), colors::dark);
    list.AddCircleFilled(to_imgui(pixel), radius, color);
}

}  // namespace

std::optional<PathPart> path_part_near(const DomainPath& path, const PlotFrame& frame, glm::vec2 pointer) {
    const auto points = path.points();
    std::optional<PathPart> nearest;
    float distance = scaled(point_reach);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float here = glm::distance(frame.pixel(points[i].at), pointer);
        if (here >= distance) continue;
        nearest = PathPart{i, false};
        distance = here;
    }
    if (nearest) return nearest;
    distance = scaled(line_reach);
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const glm::dvec2 from = frame.pixel(points[i].at);
        const glm::dvec2 to = frame.pixel(points[i + 1].at);
        const double part = part_along(from, to, pointer);
        const auto here = static_cast<float>(glm::distance(from + part * (to - from), glm::dvec2(pointer)));
        if (here >= distance) continue;
        nearest = PathPart{i, true};
        distance = here;
    }
    return nearest;
}

PathPoint point_on_line(const DomainPath& path, std::size_t place, glm::dvec2 at) {
    const PathPoint& from = path.points()[place];
    const PathPoint& to = path.points()[place + 1];
    const double part = part_along(from.at, to.at, at);
    return {from.time + part * (to.time - from.time), from.at + part * (to.at - from.at)};
}

void show_path_menu(const DomainPath& path, const PathPart& part, glm::dvec2 at, PathEdit& edit) {
    if (part.is_line) {
        if (ImGui::MenuItem("Insert path point here")) edit.inserted = point_on_line(path, part.place, at);
        return;
    }
    heading("Point of the path");
    if (ImGui::MenuItem("Set time...")) edit.asked_time = part.place;
    if (ImGui::MenuItem("Set place...")) edit.asked_place = part.place;
    if (ImGui::MenuItem("Remove point", "Del")) edit.removed = part.place;
}

void draw_path_points(const DomainPath& path, const PlotFrame& frame,
                      const std::optional<std::size_t>& selected, const std::optional<PathPart>& near,
                      glm::vec2 pointer) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto points = path.points();
    std::optional<glm::vec2> last;
    for (const PathPoint& point : points) {
        const glm::vec2 pixel = frame.pixel(point.at);
        if (last && glm::distance(*last, pixel) < scaled(dot_distance)) continue;
        last = pixel;
        draw_dot(list, pixel, scaled(3), colors::white);
    }
    if (near && near->is_line)
        draw_dot(list, frame.pixel(point_on_line(path, near->place, frame.point(pointer)).at), scaled(3),
                 colors::notice);
    if (near && !near->is_line) draw_dot(list, frame.pixel(points[near->place].at), scaled(5), colors::white);
    if (selected) draw_dot(list, frame.pixel(points[*selected].at), scaled(5), colors::notice);
}

}  // namespace interleaf
