#include "app/pictures/morph_surface.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "family/family_fields.h"
#include "hierarchy/morph.h"

namespace interleaf {

namespace {

std::vector<std::string> names_of(const Family& family, const std::vector<std::size_t>& keys) {
    std::vector<std::string> names;
    names.reserve(keys.size());
    for (const std::size_t key : keys) names.push_back(family.keys[key].name);
    return names;
}

bool are_same(const std::vector<SharedHierarchy>& a, const std::vector<SharedHierarchy>& b) {
    return std::ranges::equal(a, b, [](const auto& x, const auto& y) { return x.is_same(y); });
}

}  // namespace

void MorphSurface::update(const Family& family, const Weights& weights, const FieldName* field,
                          std::span<const std::size_t> sources) {
    const std::vector<std::size_t> active = active_keys(weights);
    std::vector<SharedHierarchy> hierarchies;
    std::vector<std::size_t> keys;
    hierarchies.reserve(active.size());
    keys.reserve(active.size());
    for (const std::size_t key : active) {
        hierarchies.push_back(family.keys[key].hierarchy);
        keys.push_back(sources.empty() ? key : sources[key]);
    }
    if (keys == figures_.keys && are_same(hierarchies, hierarchies_)) {
        figures_.key_names = names_of(family, active);
        return update_field(family, weights, field);
    }

    const auto start = std::chrono::steady_clock::now();
    // Levels of detail get other hierarchies whenever they are cut again, so their unions are not kept.
    UnionCache::Result result =
        sources.empty() ? unions_.get(hierarchies) : UnionCache::Result{unions_.make(hierarchies), false};
    renderer_.upload(result.united->mesh, result.united->form, keys);
    union_ = std::move(result.united);  // if the upload fails, the old union stays with its figures
    const std::chrono::duration<double, std::milli> taken = std::chrono::steady_clock::now() - start;

    hierarchies_ = std::move(hierarchies);
    std::vector<std::string> names = names_of(family, active);
    figures_ = {.keys = std::move(keys),
                .key_names = std::move(names),
                .leaves = union_->mesh.leaf_count(),
                .vertices = union_->mesh.vertex_count(),
                .levels = renderer_.levels(),
                .origins = {renderer_.origins().begin(), renderer_.origins().end()},
                .rebuilds = figures_.rebuilds + 1,
                .waits = figures_.waits + (result.is_ready ? 0 : 1),
                .rebuild_milliseconds = taken.count(),
                .key_without_field = {}};
    wanted_field_.reset();
    update_field(family, weights, field);
}

void MorphSurface::update_field(const Family& family, const Weights& weights, const FieldName* field) {
    figures_.key_without_field.reset();
    if (field != nullptr)
        if (const auto key = key_without(family, weights, *field))
            figures_.key_without_field = family.keys[*key].name;
    if (field == nullptr ? !wanted_field_ : wanted_field_ == *field) return;
    field_.reset();
    wanted_field_.reset();
    if (field != nullptr) {
        wanted_field_ = *field;
        if (!figures_.key_without_field) field_ = united_field(family, weights, union_->mesh, *field);
    }
    renderer_.set_field(field_ ? &*field_ : nullptr);
}

void MorphSurface::expect(const Family& family, std::span<const std::vector<std::size_t>> key_sets) {
    std::vector<UnionCache::Keys> wanted;
    wanted.reserve(key_sets.size());
    for (const std::vector<std::size_t>& keys : key_sets) {
        UnionCache::Keys& hierarchies = wanted.emplace_back();
        for (const std::size_t key : keys) hierarchies.push_back(family.keys[key].hierarchy);
    }
    unions_.prepare(std::move(wanted));
}

bool MorphSurface::prepares(const Family& family, const Weights& weights) {
    std::vector<SharedHierarchy> hierarchies;
    hierarchies.reserve(weights.size());
    for (const Weight& weight : weights) hierarchies.push_back(family.keys[weight.key].hierarchy);
    if (union_ != nullptr && are_same(hierarchies, hierarchies_)) return false;
    unions_.prepare({hierarchies});
    return unions_.is_coming(hierarchies);
}

Extent MorphSurface::extent(const Weights& weights) const {
    return extent_of(morph(union_->mesh, weight_values(weights)));
}

std::optional<glm::vec3> MorphSurface::field_at(const Ray& ray, const Weights& weights) {
    if (!field_) return std::nullopt;
    const std::vector<float> factors = weight_values(weights);
    return value_where_hit(union_->mesh.triangles, morph(union_->mesh, factors), *field_, factors, ray);
}

std::optional<glm::vec3> value_where_hit(std::span<const Triangle> triangles,
                                         std::span<const glm::vec3> positions, const UnionField& field,
                                         std::span<const float> weights, const Ray& ray) {
    const std::optional<Hit> hit = first_hit(triangles, positions, ray);
    if (!hit) return std::nullopt;
    const std::size_t width = component_count(field.label.kind);
    glm::vec3 value(0);
    for (std::size_t key = 0; key < weights.size(); ++key)
        for (int corner = 0; corner < 3; ++corner) {
            const float* const at =
                &field.values[key][width * triangles[hit->triangle][static_cast<std::size_t>(corner)]];
            for (std::size_t c = 0; c < width; ++c)
                value[static_cast<int>(c)] += weights[key] * hit->barycentric[corner] * at[c];
        }
    return value;
}

}  // namespace interleaf
