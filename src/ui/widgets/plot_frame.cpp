#include "ui/widgets/plot_frame.h"

#include <algorithm>

namespace interleaf {

PlotFrame::PlotFrame(const DomainBox& box, const Rect& area) : box_(box) {
    const glm::dvec2 extent = box_.high - box_.low;
    scale_ = std::min(area.width / extent.x, area.height / extent.y);
    const glm::dvec2 middle{area.x + area.width / 2, area.y + area.height / 2};
    corner_ = middle - scale_ * extent / 2.0;
}

glm::vec2 PlotFrame::pixel(glm::dvec2 point) const {
    return corner_ + scale_ * glm::dvec2(point.x - box_.low.x, box_.high.y - point.y);
}

glm::dvec2 PlotFrame::point(glm::vec2 pixel) const {
    const glm::dvec2 offset = (glm::dvec2(pixel) - corner_) / scale_;
    return {box_.low.x + offset.x, box_.high.y - offset.y};
}

Rect PlotFrame::rect() const {
    const glm::vec2 size = scale_ * (box_.high - box_.low);
    return {static_cast<float>(corner_.x), static_cast<float>(corner_.y), size.x, size.y};
}

}  // namespace interleaf
