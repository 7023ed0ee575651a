#include "ui/panels/domain_view.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <imgui.h>

#include "ui/widgets/style.h"

namespace interleaf {

namespace {

/// The smallest visible part of the domain, as a fraction of its width.
constexpr double smallest_part = 1e-4;

bool contains(const DomainBox& box, const DomainBox& part) {
    return glm::all(glm::lessThanEqual(box.low, part.low)) &&
           glm::all(glm::lessThanEqual(part.high, box.high));
}

}  // namespace

DomainBox panned(const DomainBox& visible, const DomainBox& whole, glm::dvec2 offset) {
    const glm::dvec2 size = glm::min(visible.high - visible.low, whole.high - whole.low);
    const glm::dvec2 low = glm::clamp(visible.low + offset, whole.low, whole.high - size);
    return {low, low + size};
}

DomainBox zoomed(const DomainBox& visible, const DomainBox& whole, glm::dvec2 fixed, double factor) {
    const glm::dvec2 part = (visible.high - visible.low) / (whole.high - whole.low);
    const double larger = std::max(part.x, part.y);
    const double wanted = std::max(larger * factor, smallest_part);
    if (wanted >= 1) return whole;
    const glm::dvec2 place = glm::clamp((fixed - visible.low) / (visible.high - visible.low), 0.0, 1.0);
    const glm::dvec2 size = wanted * (whole.high - whole.low);
    const glm::dvec2 low = fixed - place * size;
    return panned({low, low + size}, whole, glm::dvec2(0));
}

DomainBox shown_part(const DomainBox& whole, const std::optional<DomainBox>& wanted) {
    if (!wanted) return whole;
    const glm::dvec2 smallest = smallest_part * (whole.high - whole.low) / 2.0;
    const bool is_usable = glm::all(glm::greaterThan(wanted->high - wanted->low, smallest));
    return is_usable ? panned(*wanted, whole, glm::dvec2(0)) : whole;
}

std::optional<DomainBox> moved_view(const PlotFrame& frame, const DomainBox& visible,
                                    const DomainBox& whole) {
    if (!ImGui::IsItemHovered()) return std::nullopt;
    const ImGuiIO& io = ImGui::GetIO();
    const glm::vec2 pointer = from_imgui(io.MousePos);
    std::optional<DomainBox> moved;
    if (io.MouseWheel != 0)
        moved = zoomed(visible, whole, frame.point(pointer), std::pow(0.8, io.MouseWheel));
    const glm::vec2 delta = from_imgui(io.MouseDelta);
    if (ImGui::IsMouseDown(ImGuiMouseButton_Middle) && (delta.x != 0 || delta.y != 0))
        moved = panned(visible, whole, frame.point(pointer - delta) - frame.point(pointer));
    if (moved && contains(*moved, whole) && contains(visible, whole)) return std::nullopt;
    return moved;
}

}  // namespace interleaf
