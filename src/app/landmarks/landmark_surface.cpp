#include "app/landmarks/landmark_surface.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec4.hpp>

#include "fit/placement.h"
#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "render/image_texture.h"
#include "render/pick.h"
#include "render/plain_mesh.h"

namespace interleaf {
namespace {

/// A point this far behind the surface in front of it, in radii of the ball, is hidden.
constexpr float hidden_by = 0.04F;

glm::vec2 device_place(glm::vec2 place) {
    return {2 * place.x - 1, 1 - 2 * place.y};
}

}  // namespace

ShownBall ball_of(const SurfaceMesh& mesh) {
    ShownBall ball{.center = extent_of(mesh).center, .radius = 0};
    for (const glm::dvec3& position : mesh.positions)
        ball.radius = std::max(ball.radius, glm::distance(position, ball.center));
    if (!(ball.radius > 0)) ball.radius = 1;
    return ball;
}

void LandmarkSurface::set_mesh(std::shared_ptr<const SurfaceMesh> mesh) {
    mesh_ = std::move(mesh);
    ball_ = ball_of(*mesh_);
    in_ball_.clear();
    in_ball_.reserve(mesh_->positions.size());
    for (const glm::dvec3& position : mesh_->positions) in_ball_.push_back(ball_(position));
    shows_mesh_ = false;
    show_mesh();
    extent_to_view_ = extent_of(std::span<const glm::vec3>(in_ball_));
}

void LandmarkSurface::show_mesh() {
    if (std::exchange(shows_mesh_, true)) return;
    keys_.clear();
    upload(plain_mesh(mesh_->triangles, in_ball_));
}

void LandmarkSurface::show_keys(const std::vector<std::shared_ptr<const Hierarchy>>& keys,
                                const ShownBall& ball) {
    if (keys == keys_) return;
    const bool is_first = !has_mesh() && keys_.empty();
    keys_ = keys;
    shows_mesh_ = false;
    ball_ = ball;
    std::vector<Hierarchy> in_ball;
    in_ball.reserve(keys.size());
    std::vector<const Hierarchy*> shown;
    for (const auto& key : keys) {
        Hierarchy& moved = in_ball.emplace_back(*key);
        for (glm::vec3& position : moved.positions) position = ball(glm::dvec3(position));
        shown.push_back(&moved);
    }
    const UnionMesh united = unite(shown);
    upload(united);
    if (!is_first) return;
    const std::vector<std::span<const glm::vec3>> parts(united.positions.begin(), united.positions.end());
    extent_to_view_ = extent_of(parts);
}

void LandmarkSurface::upload(const UnionMesh& mesh) {
    if (!renderer_) renderer_ = std::make_unique<Renderer>();
    renderer_->upload(mesh, normal_form(mesh));
    drawn_.reset();
}

float LandmarkSurface::aspect() const {
    return drawn_ ? static_cast<float>(drawn_->size.x) / static_cast<float>(drawn_->size.y) : 1;
}

void LandmarkSurface::draw(glm::ivec2 size, const std::vector<float>& weights, Coloring coloring) {
    if (!renderer_) return;
    size = glm::max(size, glm::ivec2(1));
    if (const auto extent = std::exchange(extent_to_view_, std::nullopt))
        camera.view_all(*extent, static_cast<float>(size.x) / static_cast<float>(size.y));
    Drawn wanted{.size = size, .camera = camera, .weights = weights, .coloring = coloring};
    if (drawn_ == wanted) return;
    drawn_ = std::move(wanted);
    OffscreenTarget target(drawn_->size.x, drawn_->size.y, 4);
    Display display;
    display.coloring = coloring;
    renderer_->draw(target, camera, weights, display);
    texture_ = image_texture(target.width(), target.height(), target.read_rgba());
    depths_ = target.read_depths();
}

std::optional<glm::dvec3> LandmarkSurface::point_at(glm::vec2 place) const {
    if (!has_mesh()) return std::nullopt;
    const glm::vec2 at = device_place(place);
    const auto hit = first_hit(mesh_->triangles, in_ball_,
                               {camera.point_at(at, 0, aspect()), camera.point_at(at, 1, aspect())});
    if (!hit) return std::nullopt;
    const auto& [a, b, c] = mesh_->triangles[hit->triangle];
    const glm::dvec3 parts(hit->barycentric);
    return (parts.x * mesh_->positions[a] + parts.y * mesh_->positions[b] + parts.z * mesh_->positions[c]) /
           (parts.x + parts.y + parts.z);
}

LandmarkSurface::Projected LandmarkSurface::project(const glm::dvec3& position) const {
    const glm::vec3 point = ball_(position);
    const glm::vec4 clip = camera.projection(aspect()) * camera.view() * glm::vec4(point, 1);
    const glm::vec2 at(clip.x / clip.w, clip.y / clip.w);
    Projected projected{.place = {(at.x + 1) / 2, (1 - at.y) / 2}, .is_hidden = false};
    if (!drawn_ || depths_.empty()) return projected;
    const glm::ivec2 pixel(projected.place * glm::vec2(drawn_->size));
    if (pixel.x < 0 || pixel.y < 0 || pixel.x >= drawn_->size.x || pixel.y >= drawn_->size.y)
        return projected;
    const float depth = depths_[static_cast<std::size_t>(pixel.y) * static_cast<std::size_t>(drawn_->size.x) +
                                static_cast<std::size_t>(pixel.x)];
    if (depth >= 1) return projected;
    const glm::vec3 eye = camera.eye();
    projected.is_hidden =
        glm::distance(eye, point) > glm::distance(eye, camera.point_at(at, depth, aspect())) + hidden_by;
    return projected;
}

void LandmarkSurface::zoom(float factor, glm::vec2 place) {
    camera.zoom(factor, device_place(place), aspect());
}

}  // namespace interleaf
