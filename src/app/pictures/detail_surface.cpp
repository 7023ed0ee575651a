#include "app/pictures/detail_surface.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "family/family_fields.h"

namespace interleaf {

namespace {

ViewPoint view_point(const Camera& camera, float aspect) {
    const glm::mat3 axes = glm::transpose(glm::mat3(camera.view()));
    const float tangent = std::tan(glm::radians(vertical_field_degrees / 2));
    // Seen from far away, as an orthographic camera sees, everything has the same distance and direction.
    const float times = camera.projection() == Projection::perspective ? 1 : 100;
    const float height = tangent / times;
    return {.eye = camera.target() + axes[2] * (times * camera.distance()),
            .forward = -axes[2],
            .cosine = 1 / std::sqrt(1 + height * height * (1 + aspect * aspect))};
}

}  // namespace

bool DetailSurface::follow(const Family& family, const Weights& weights, const KeyDetails& details) {
    std::vector<SharedHierarchy> hierarchies;
    hierarchies.reserve(weights.size());
    for (const Weight& weight : weights) hierarchies.push_back(family.keys[weight.key].hierarchy);
    if (refinement_ && std::ranges::equal(hierarchies, hierarchies_,
                                          [](const auto& a, const auto& b) { return a.is_same(b); }))
        return true;
    std::vector<KeyDetails::Measured> measured;
    std::vector<const Hierarchy*> keys;
    std::vector<const KeyDetail*> key_details;
    measured.reserve(weights.size());
    keys.reserve(weights.size());
    key_details.reserve(weights.size());
    for (const SharedHierarchy& hierarchy : hierarchies) {
        measured.push_back(details.find(hierarchy));
        if (measured.back() == nullptr) return false;
        keys.push_back(&*hierarchy);
        key_details.push_back(measured.back().get());
    }
    refinement_.emplace(std::move(keys), std::move(key_details));
    hierarchies_ = std::move(hierarchies);
    measured_ = std::move(measured);
    subject_.reset();
    return true;
}

void DetailSurface::refine(const Family& family, const Weights& weights, const Camera& camera, float aspect,
                           const FieldName* field) {
    Subject subject{.keys = active_keys(weights),
                    .weights = weight_values(weights),
                    .camera = camera,
                    .aspect = aspect,
                    .field = field != nullptr ? std::optional(*field) : std::nullopt,
                    .names = {}};
    subject.names.reserve(weights.size());
    for (const Weight& weight : weights) subject.names.push_back(family.keys[weight.key].name);
    if (subject_ == subject) return;
    subject_.reset();

    const auto start = std::chrono::steady_clock::now();
    const std::vector<const Hierarchy*>& keys = refinement_->keys();
    view_mesh(refinement_->refine(subject.weights, view_point(camera, aspect), view_leaf_budget), keys,
              subject.weights, mesh_);
    renderer_.upload_blend(mesh_.mesh, mesh_.positions, mesh_.normals, subject.keys);
    figures_.key_without_field.reset();
    field_.reset();
    if (field != nullptr) {
        if (const auto key = key_without(family, weights, *field))
            figures_.key_without_field = family.keys[*key].name;
        else
            field_ = view_field(mesh_, keys, subject.weights, *field);
    }
    renderer_.set_field(field_ ? &*field_ : nullptr);
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;

    figures_.keys = subject.keys;
    figures_.key_names = subject.names;
    figures_.leaves = mesh_.mesh.leaf_count();
    figures_.vertices = mesh_.mesh.vertex_count();
    figures_.levels = renderer_.levels();
    figures_.origins = {renderer_.origins().begin(), renderer_.origins().end()};
    figures_.rebuild_milliseconds = taken.count();
    subject_ = std::move(subject);
    ++version_;
}

std::optional<glm::vec3> DetailSurface::field_at(const Ray& ray) const {
    if (!field_) return std::nullopt;
    return value_where_hit(mesh_.mesh.triangles, mesh_.positions, *field_, std::array{1.0F}, ray);
}

std::optional<NodePath> DetailSurface::leaf_at(const Ray& ray) const {
    return leaf_where_hit(mesh_.mesh, mesh_.positions, ray);
}

Extent DetailSurface::extent() const {
    return extent_of(mesh_.positions);
}

}  // namespace interleaf
