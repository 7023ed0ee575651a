#include "app/pictures/node_outline.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

namespace interleaf {
namespace {

/// Length of the parts of a line that are seen or hidden as a whole, pixels.
constexpr float part_length = 3;
constexpr float max_parts = 400;  // per edge of a leaf

glm::vec3 position_of(const SurfacePoint& point, const NodeOutline::Positions& positions) {
    glm::dvec3 sum(0);
    for (unsigned corner = 0; corner < 3; ++corner)
        if (const double part = point.barycentric[static_cast<int>(corner)]; part != 0)
            sum += part * glm::dvec3(positions(point.vertices.at(corner)));
    return sum;
}

/// The outline lies on the surface, and the depth of a pixel is that of its middle. So a neighboring pixel may
/// show the point.
bool is_seen(const glm::vec4& place, const PictureDepths& picture) {
    for (const glm::vec2 step :
         {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(-1, 0), glm::vec2(0, 1), glm::vec2(0, -1)})
        if (is_visible(place + glm::vec4(step, 0, 0), picture)) return true;
    return false;
}

/// Adds lines point by point, and begins a new one where the next part is hidden and the last was not, or the
/// reverse.
class OutlinePen {
  public:
    OutlinePen(Outline& outline, bool is_refinement_edge)
        : outline_(outline), is_refinement_edge_(is_refinement_edge) {}

    void lift() { is_down_ = false; }

    void draw(glm::vec2 from, glm::vec2 to, bool is_hidden) {
        if (!is_down_ || outline_.lines.back().is_hidden != is_hidden)
            outline_.lines.push_back({{from}, is_refinement_edge_, is_hidden});
        outline_.lines.back().points.push_back(to);
        is_down_ = true;
    }

  private:
    Outline& outline_;
    bool is_refinement_edge_;
    bool is_down_ = false;
};

}  // namespace

void NodeOutline::follow(const UnionMesh& mesh, MeshNumber number, const std::optional<NodePath>& node) {
    if (!node) {
        node_.reset();
        index_.reset();
        return;
    }
    if (index_ && number == number_ && node == node_) return;
    if (!index_ || number != number_) index_.emplace(mesh);
    number_ = number;
    node_ = node;
    sides_ = index_->boundary(*node);
}

std::array<glm::vec3, 3> NodeOutline::corners(const Positions& positions) const {
    std::array<glm::vec3, 3> corners{};
    for (std::size_t side = 0; side < 3; ++side)
        corners.at((side + 1) % 3) = position_of(sides_.at(side).front(), positions);
    return corners;
}

Outline NodeOutline::outline(const Positions& positions, const Camera& camera,
                             const PictureDepths& picture) const {
    const float aspect = static_cast<float>(picture.width) / static_cast<float>(picture.height);
    const glm::mat4 to_clip = camera.projection(aspect) * camera.view();
    Outline outline;
    for (std::size_t side = 0; side < sides_.size(); ++side) {
        OutlinePen pen(outline, side == refinement_side);
        glm::vec3 from = position_of(sides_.at(side).front(), positions);
        for (std::size_t point = 1; point < sides_.at(side).size(); ++point) {
            const glm::vec3 to = position_of(sides_.at(side)[point], positions);
            const glm::vec4 begin = placed_in_picture(to_clip, from, picture);
            const glm::vec4 end = placed_in_picture(to_clip, to, picture);
            if (!(begin.w > 0) || !(end.w > 0)) {
                pen.lift();
                from = to;
                continue;
            }
            const float length = glm::distance(glm::vec2(begin), glm::vec2(end));
            const float parts = std::clamp(std::ceil(length / part_length), 1.0F, max_parts);
            glm::vec4 last = begin;
            for (float part = 1; part <= parts; ++part) {
                const glm::vec4 next = placed_in_picture(to_clip, glm::mix(from, to, part / parts), picture);
                pen.draw(glm::vec2(last), glm::vec2(next), !is_seen((last + next) / 2.0F, picture));
                last = next;
            }
            from = to;
        }
        const glm::vec4 corner =
            placed_in_picture(to_clip, position_of(sides_.at((side + 1) % 3).back(), positions), picture);
        if (corner.w > 0) outline.corners.at(side) = glm::vec2(corner);
    }
    return outline;
}

}  // namespace interleaf
