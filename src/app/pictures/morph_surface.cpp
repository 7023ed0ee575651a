#include "app/pictures/morph_surface.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <utility>

#include "family/family_fields.h"
#include "hierarchy/leaf_path.h"
#include "hierarchy/morph.h"

namespace interleaf {

namespace {

std::vector<std::string> names_of(const Family& family, const std::vector<std::size_t>& keys) {
    std::vector<std::string> names;
    names.reserve(keys.size());
    for (const std::size_t key : keys) names.push_back(family.keys[key].name);
    return names;
}

/// The longest time in a frame to wait for a union; half of a frame of 60 Hz.
constexpr std::chrono::milliseconds longest_wait{8};

/// What a frame sends to the GPU at most, in bytes: about 4 ms where the processor is the GPU.
constexpr std::size_t slice_bytes = std::size_t{4} << 20;

}  // namespace

void MorphSurface::update(const Family& family, const Weights& weights, const FieldName* field,
                          std::span<const std::size_t> sources) {
    const std::vector<std::size_t> active = active_keys(weights);
    UnionCache::Keys wanted({}, family.blend);
    std::vector<std::size_t> keys;
    wanted.hierarchies.reserve(active.size());
    keys.reserve(active.size());
    for (const std::size_t key : active) {
        wanted.hierarchies.push_back(family.keys[key].hierarchy);
        keys.push_back(sources.empty() ? key : sources[key]);
    }
    if (keys == figures_.keys && UnionCache::are_same(wanted, united_)) {
        needed_since_.reset();
        has_waited_ = false;
        figures_.is_late = false;
        figures_.key_names = names_of(family, active);
        weights_ = weight_values(weights);
        return update_field(family, weights, field);
    }

    if (!needed_since_) needed_since_ = std::chrono::steady_clock::now();
    const bool is_kept = sources.empty();
    UnionCache::Result result = needed_union(wanted, is_kept);
    has_waited_ = has_waited_ || !result.is_ready;
    // A union that is not kept could not be sent in later frames.
    const std::size_t max_bytes =
        is_kept && union_ != nullptr ? slice_bytes : std::numeric_limits<std::size_t>::max();
    figures_.is_late = result.united == nullptr || !has_sent(result.united, max_bytes);
    if (figures_.is_late) return;
    renderer_.show_sent(keys);
    sent_.reset();
    union_ = std::move(result.united);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - *std::exchange(needed_since_, std::nullopt);

    united_ = std::move(wanted);
    std::vector<std::string> names = names_of(family, active);
    figures_ = {.keys = std::move(keys),
                .key_names = std::move(names),
                .leaves = union_->mesh.leaf_count(),
                .vertices = union_->mesh.vertex_count(),
                .levels = renderer_.levels(),
                .origins = {renderer_.origins().begin(), renderer_.origins().end()},
                .rebuilds = figures_.rebuilds + 1,
                .waits = figures_.waits + (std::exchange(has_waited_, false) ? 1 : 0),
                .is_late = false,
                .rebuild_milliseconds = taken.count(),
                .key_without_field = {}};
    wanted_field_.reset();
    weights_ = weight_values(weights);
    update_field(family, weights, field);
}

/// \param is_kept  whether the keys come again; levels of detail are other hierarchies whenever they are cut
UnionCache::Result MorphSurface::needed_union(const UnionCache::Keys& keys, bool is_kept) {
    if (!is_kept) return {unions_.make(keys), false};
    return union_ == nullptr ? unions_.get(keys) : unions_.get_within(keys, longest_wait);
}

/// Sends at most about \p max_bytes more of \p united to the GPU.
/// \return whether all of it is there
bool MorphSurface::has_sent(const UnionCache::Prepared& united, std::size_t max_bytes) {
    if (sent_ != united) {
        sent_.reset();
        renderer_.begin_upload(united);
        sent_ = united;
    }
    return renderer_.send(max_bytes);
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
        std::vector<SharedHierarchy>& hierarchies =
            wanted.emplace_back(std::vector<SharedHierarchy>(), family.blend).hierarchies;
        hierarchies.reserve(keys.size());
        for (const std::size_t key : keys) hierarchies.push_back(family.keys[key].hierarchy);
    }
    if (!figures_.is_late) send_ahead(wanted);
    unions_.prepare(std::move(wanted));
}

/// Sends a slice of the first union of \p wanted that is not shown, if it is made.
void MorphSurface::send_ahead(std::span<const UnionCache::Keys> wanted) {
    for (const UnionCache::Keys& keys : wanted) {
        const UnionCache::Prepared united = unions_.peek(keys);
        if (united != nullptr && united == union_) continue;
        if (united != nullptr) has_sent(united, slice_bytes);
        return;
    }
}

bool MorphSurface::prepares(const Family& family, const Weights& weights) {
    UnionCache::Keys wanted({}, family.blend);
    wanted.hierarchies.reserve(weights.size());
    for (const Weight& weight : weights) wanted.hierarchies.push_back(family.keys[weight.key].hierarchy);
    if (union_ != nullptr && UnionCache::are_same(wanted, united_)) return false;
    unions_.prepare({wanted});
    if (const UnionCache::Prepared united = unions_.peek(wanted)) return !has_sent(united, slice_bytes);
    return unions_.is_coming(wanted);
}

Extent MorphSurface::extent() const {
    return extent_of(morph(union_->mesh, weights_));
}

std::optional<glm::vec3> MorphSurface::field_at(const Ray& ray) {
    if (!field_) return std::nullopt;
    return value_where_hit(union_->mesh.triangles, morph(union_->mesh, weights_), *field_, weights_, ray);
}

std::optional<NodePath> MorphSurface::leaf_at(const Ray& ray) const {
    if (union_ == nullptr) return std::nullopt;
    return leaf_where_hit(union_->mesh, morph(union_->mesh, weights_), ray);
}

std::optional<NodePath> leaf_where_hit(const UnionMesh& mesh, std::span<const glm::vec3> positions,
                                       const Ray& ray) {
    const std::optional<Hit> hit = first_hit(mesh.triangles, positions, ray);
    if (!hit) return std::nullopt;
    const LeafPath leaf = leaf_paths(mesh.tags)[hit->triangle];
    return NodePath{leaf.root, mesh.tags[hit->triangle].level(), leaf.path};
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
