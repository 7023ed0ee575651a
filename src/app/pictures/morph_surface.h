// The surface in the window: the union of the active keys on the GPU, rebuilt only when their set changes.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "app/pictures/union_cache.h"
#include "family/family.h"
#include "hierarchy/measure.h"
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
    double rebuild_milliseconds = 0;  ///< of the last rebuild: the wait for the union, and its upload
    std::optional<std::string> key_without_field;  ///< an active key without the shown field
};

class MorphSurface {
  public:
    /// \pre a GL context is current
    MorphSurface() = default;

    /// Rebuilds the union if \p weights have other active keys than before. Unites \p field if it has changed
    /// or the union is new.
    /// \param field   the field to show; null for none
    /// \param sources  the index by which the figures and the colors by origin refer to each key of \p family;
    ///     its own index if empty
    void update(const Family& family, const Weights& weights, const FieldName* field,
                std::span<const std::size_t> sources = {});

    /// Lets a worker make the unions of \p key_sets ahead, in this order.
    /// \param key_sets  the active keys of blends that will soon be shown, as indices in \p family
    void expect(const Family& family, std::span<const std::vector<std::size_t>> key_sets);

    /// The value of the field where \p ray first meets the surface with \p weights: one number, or the linear
    /// light of a color. None if the ray misses the surface, or without a field.
    std::optional<glm::vec3> field_at(const Ray& ray, const Weights& weights);

    /// The extent of the surface with \p weights.
    /// \pre \p weights are those of the last update()
    Extent extent(const Weights& weights) const;

    /// The shown union.
    /// \pre update() has been called
    const UnionMesh& mesh() const { return union_->mesh; }

    const SurfaceFigures& figures() const { return figures_; }
    Renderer& renderer() { return renderer_; }

  private:
    void update_field(const Family& family, const Weights& weights, const FieldName* field);

    UnionCache unions_;
    UnionCache::Prepared union_;                ///< the shown one; null before the first update()
    std::optional<UnionField> field_;           ///< of the union; none if no field is shown
    std::vector<SharedHierarchy> hierarchies_;  ///< of the active keys
    SurfaceFigures figures_;
    std::optional<FieldName> wanted_field_;
    Renderer renderer_;
};

}  // namespace interleaf
