// The tube consists of rings around the line, each rotated from the previous one by the smallest rotation,
// and of half balls at both ends.
#include "app/pictures/tube.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace interleaf {

namespace {

constexpr int sides = 12;
constexpr int cap_rings = 3;  // rings of a half ball, between pole and equator

constexpr float pi = std::numbers::pi_v<float>;

class TubeMaker {
  public:
    TubeMaker(std::span<const glm::vec3> points, float radius) : points_(points), radius_(radius) {}

    Tube make() && {
        axis_ = axis_at(0, {0, 0, 1});
        across_ = any_perpendicular(axis_);
        add_vertex(points_.front(), -axis_);
        for (int n = 1; n <= cap_rings; ++n) add_ring(points_.front(), lean(n) - pi / 2);
        for (std::size_t n = 0; n < points_.size(); ++n) {
            turn_to(axis_at(n, axis_));
            add_ring(points_[n], 0);
        }
        for (int n = cap_rings; n >= 1; --n) add_ring(points_.back(), pi / 2 - lean(n));
        add_vertex(points_.back(), axis_);
        join();
        return std::move(tube_);
    }

  private:
    static float lean(int n) { return static_cast<float>(n) * pi / 2 / (cap_rings + 1); }

    /// The direction of the line at point \p n, from the previous point to the next.
    glm::vec3 axis_at(std::size_t n, glm::vec3 otherwise) const {
        const glm::vec3 before = points_[n == 0 ? 0 : n - 1];
        const glm::vec3 behind = points_[n + 1 == points_.size() ? n : n + 1];
        return normalized_or(behind - before, otherwise);
    }

    void turn_to(glm::vec3 axis) {
        axis_ = axis;
        across_ = normalized_or(across_ - glm::dot(across_, axis) * axis, any_perpendicular(axis));
    }

    void add_vertex(glm::vec3 center, glm::vec3 normal) {
        tube_.positions.push_back(center + radius_ * normal);
        tube_.normals.push_back(normal);
    }

    /// \param lean  angle of the ring's normals towards the axis
    void add_ring(glm::vec3 center, float lean) {
        const glm::vec3 up = glm::cross(axis_, across_);
        for (int side = 0; side < sides; ++side) {
            const float angle = 2 * pi * static_cast<float>(side) / sides;
            const glm::vec3 aside = std::cos(angle) * across_ + std::sin(angle) * up;
            add_vertex(center, std::sin(lean) * axis_ + std::cos(lean) * aside);
        }
    }

    /// Triangles between each ring and the next, and about the poles.
    void join() {
        const auto last = static_cast<Index>(tube_.positions.size() - 1);
        const auto vertex = [](Index ring, Index side) { return 1 + ring * sides + side % sides; };
        const Index rings = (last - 1) / sides;
        for (Index side = 0; side < sides; ++side) {
            tube_.triangles.push_back({0, vertex(0, side + 1), vertex(0, side)});
            for (Index ring = 0; ring + 1 < rings; ++ring) {
                tube_.triangles.push_back(
                    {vertex(ring, side), vertex(ring, side + 1), vertex(ring + 1, side)});
                tube_.triangles.push_back(
                    {vertex(ring, side + 1), vertex(ring + 1, side + 1), vertex(ring + 1, side)});
            }
            tube_.triangles.push_back({vertex(rings - 1, side), vertex(rings - 1, side + 1), last});
        }
    }

    std::span<const glm::vec3> points_;
    float radius_;
    glm::vec3 axis_{0};
    glm::vec3 across_{0};
    Tube tube_;
};

}  // namespace

Tube tube_along(std::span<const glm::vec3> points, float radius) {
    return TubeMaker(points, radius).make();
}

glm::vec3 normalized_or(glm::vec3 vector, glm::vec3 otherwise) {
    const float length = glm::length(vector);
    return length > 0 && std::isfinite(length) ? vector / length : otherwise;
}

glm::vec3 any_perpendicular(glm::vec3 axis) {
    const glm::vec3 least = std::abs(axis.x) < 0.6F ? glm::vec3(1, 0, 0) : glm::vec3(0, 1, 0);
    return glm::normalize(glm::cross(axis, least));
}

}  // namespace interleaf
