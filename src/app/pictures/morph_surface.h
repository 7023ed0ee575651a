// The surface in the window: the union of the active keys on the GPU, rebuilt only when their set changes.
// Where a union is not made yet, or not sent to the GPU yet, the last surface stays, and the window goes on.
#pragma once

#include <chrono>
#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "app/pictures/union_cache.h"
#include "family/family.h"
#include "hierarchy/measure.h"
#include "hierarchy/nodes/node_path.h"
#include "render/palette.h"
#include "render/pick.h"
#include "render/renderer.h"

namespace interleaf {

/// Figures of the union that is shown, all from one state of the family. They include the names of the keys,
/// because the family may have changed when the figures are read.
struct SurfaceFigures {
    std::vector<std::size_t> keys;       ///< the united keys; a key occurs twice if two levels of it do
    std::vector<std::string> key_names;  ///< names of the united keys, in the same order
    std::size_t leaves = 0;
    std::size_t vertices = 0;
    LevelRange levels;
    std::vector<KeySet> origins;      ///< the sets of active keys that occur in the union
    std::size_t rebuilds = 0;         ///< number of unions that were shown
    std::size_t waits = 0;            ///< how many of them were not made ahead
    bool is_late = false;             ///< whether the shown surface is an earlier one
    double rebuild_milliseconds = 0;  ///< from the need for the last union until it was on the GPU
    std::optional<std::string> key_without_field;  ///< an active key without the shown field
};

class MorphSurface {
  public:
    /// \param maker  makes the unions; null for the usual one
    /// \pre a GL context is current
    explicit MorphSurface(UnionCache::Maker maker = nullptr) : unions_(UnionCache::usual_bytes, maker) {}

    /// Rebuilds the union if \p weights have other active keys than before, or \p family blends in another way.
    /// Unites \p field if it has changed or the union is new. Waits for a union no longer than a part of a frame,
    /// but for the first one: until it is there, all of the surface stays as it was, and figures() are late. Then
    /// call this function again.
    /// \param field   the field to show; null for none
    /// \param sources  the index by which the figures and the colors by origin refer to each key of \p family;
    ///     its own index if empty
    void update(const Family& family, const Weights& weights, const FieldName* field,
                std::span<const std::size_t> sources = {});

    /// Lets a worker make the unions of \p key_sets ahead, in this order, and sends the first one to the GPU
    /// ahead, a slice per call.
    /// \param key_sets  the active keys of blends that will soon be shown, as indices in \p family
    void expect(const Family& family, std::span<const std::vector<std::size_t>> key_sets);

    /// Lets a worker make the union of the active keys of \p weights, unless it is there, and sends a slice of it.
    /// \return whether that goes on; otherwise update() shows the surface at once
    bool prepares(const Family& family, const Weights& weights);

    /// The value of the field where \p ray first meets the surface: one number, or the linear light of a color.
    /// None if the ray misses the surface, or without a field.
    std::optional<glm::vec3> field_at(const Ray& ray);

    /// The leaf where \p ray first meets the surface; none if the ray misses it.
    std::optional<NodePath> leaf_at(const Ray& ray) const;

    /// The weights of the surface: those of the last update() that was not late.
    const std::vector<float>& weights() const { return weights_; }

    Extent extent() const;

    /// The shown union.
    /// \pre update() has been called
    const UnionMesh& mesh() const { return union_->mesh; }

    const SurfaceFigures& figures() const { return figures_; }
    Renderer& renderer() { return renderer_; }

  private:
    bool has_sent(const UnionCache::Prepared& united, std::size_t max_bytes);
    void send_ahead(std::span<const UnionCache::Keys> wanted);
    UnionCache::Result needed_union(const UnionCache::Keys& keys, bool is_kept);
    void update_field(const Family& family, const Weights& weights, const FieldName* field);

    UnionCache unions_;
    UnionCache::Prepared union_;  ///< the shown one; null before the first update()
    UnionCache::Prepared sent_;   ///< the one that is sent to the GPU; null for none
    bool has_waited_ = false;     ///< for the union that is needed now
    std::optional<std::chrono::steady_clock::time_point> needed_since_;  ///< none if no union is needed
    std::vector<float> weights_;
    std::optional<UnionField> field_;  ///< of the union; none if no field is shown
    UnionCache::Keys united_;          ///< the active keys, as they blend
    SurfaceFigures figures_;
    std::optional<FieldName> wanted_field_;
    Renderer renderer_;
};

/// The leaf of \p mesh, with \p positions, that \p ray first meets; none if it misses all.
std::optional<NodePath> leaf_where_hit(const UnionMesh& mesh, std::span<const glm::vec3> positions,
                                       const Ray& ray);

/// The value of \p field where \p ray first meets a surface, as MorphSurface::field_at() gives it.
/// \param weights  one per stream of \p field
std::optional<glm::vec3> value_where_hit(std::span<const Triangle> triangles,
                                         std::span<const glm::vec3> positions, const UnionField& field,
                                         std::span<const float> weights, const Ray& ray);

}  // namespace interleaf
