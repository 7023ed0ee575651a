#include "ui/widgets/plot_frame.h"

#include <algorithm>

#include <glm/common.hpp>

namespace interleaf {

PlotFrame::PlotFrame(std::span<const DomainVertex> vertices, const Rect& area)
    : min_(vertices.front().at), max_(min_) {
    for (const DomainVertex& vertex : vertices) {
        min_ = glm::min(min_, vertex.at);
        max_ = glm::max(max_, vertex.at);
    }
    const glm::dvec2 extent = max_ - min_;
    scale_ = std::min(area.width / extent.x, area.height / extent.y);
    const glm::dvec2 middle{area.x + area.width / 2, area.y + area.height / 2};
    corner_ = middle - scale_ * extent / 2.0;
}

glm::vec2 PlotFrame::pixel(glm::dvec2 point) const {
    return corner_ + scale_ * glm::dvec2(point.x - min_.x, max_.y - point.y);
}

glm::dvec2 PlotFrame::point(glm::vec2 pixel) const {
    const glm::dvec2 offset = (glm::dvec2(pixel) - corner_) / scale_;
    return {min_.x + offset.x, max_.y - offset.y};
}

Rect PlotFrame::rect() const {
    const glm::vec2 size = scale_ * (max_ - min_);
    return {static_cast<float>(corner_.x), static_cast<float>(corner_.y), size.x, size.y};
}

}  // namespace interleaf
