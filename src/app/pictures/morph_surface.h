// The surface in the window: the union of the active keys on the GPU, made anew only when their set changes.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "family/family.h"
#include "hierarchy/measure.h"
#include "render/palette.h"
#include "render/pick.h"
#include "render/renderer.h"

namespace interleaf {

/// What is known about the union that is shown, all of one state of the family. Keys have their names here,
/// since the family may have changed by the time that this is read.
struct SurfaceFigures {
    std::vector<std::size_t> keys;       ///< active, as indices of the family
    std::vector<std::string> key_names;  ///< of these, in their order
    std::size_t leaves = 0;
    std::size_t vertices = 0;
    LevelRange levels;
    std::vector<KeySet> origins;  ///< the sets of active keys that occur
    std::size_t rebuilds = 0;
    double rebuild_milliseconds = 0;               ///< of the last one: union, normal products, upload
    std::optional<std::string> key_without_field;  ///< an active key that lacks the field that is shown
};

class MorphSurface {
  public:
    /// \pre a context is current
    MorphSurface() = default;

    /// Rebuilds the union if the active keys of \p weights are others than before, and unites \p field, null
    /// for none, if it is another one than before or the union is new.
    void update(const Family& family, const Weights& weights, const FieldName* field);

    /// The field of the surface with \p weights where \p ray first meets it: one number, or the linear light
    /// of a color. None where it does not, and without a field.
    std::optional<glm::vec3> field_at(const Ray& ray, const Weights& weights);

    /// The extent of the surface with \p weights. \pre they are those of the last update()
    Extent extent(const Weights& weights) const;

    const SurfaceFigures& figures() const { return figures_; }
    Renderer& renderer() { return renderer_; }

  private:
    void update_field(const Family& family, const Weights& weights, const FieldName* field);

    UnionMesh mesh_;  ///< with the field that is shown as its only one
    NormalForm form_;
    std::vector<SharedHierarchy> hierarchies_;  ///< of the active keys
    SurfaceFigures figures_;
    std::optional<FieldName> wanted_field_;
    Renderer renderer_;
};

}  // namespace interleaf
