// The surface in the window: the union of the active keys on the GPU, made anew only when their set changes.
#pragma once

#include <vector>

#include "family/family.h"
#include "render/palette.h"
#include "render/renderer.h"

namespace interleaf {

/// What is known about the union that is shown.
struct SurfaceFigures {
    std::vector<std::size_t> keys;  ///< active, as indices of the family
    std::size_t leaves = 0;
    std::size_t vertices = 0;
    LevelRange levels;
    std::vector<KeySet> origins;  ///< the sets of active keys that occur
    std::size_t rebuilds = 0;
    double rebuild_milliseconds = 0;  ///< of the last one: union, normal products, upload
};

class MorphSurface {
  public:
    /// \pre a context is current
    MorphSurface() = default;

    /// Rebuilds the union if the active keys of \p weights are others than before.
    void update(const Family& family, const Weights& weights);

    const SurfaceFigures& figures() const { return figures_; }
    Renderer& renderer() { return renderer_; }

  private:
    UnionMesh mesh_;
    NormalForm form_;
    std::vector<SharedHierarchy> hierarchies_;  ///< of the active keys
    SurfaceFigures figures_;
    Renderer renderer_;
};

}  // namespace interleaf
