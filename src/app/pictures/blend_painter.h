// Paints blends of a family as pictures in memory: for files, films and previews, without a window.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "app/pictures/picture_legend.h"
#include "app/pictures/vector_arrows.h"
#include "app/pictures/warped_family.h"
#include "family/family.h"
#include "family/family_fields.h"
#include "family/warp.h"
#include "hierarchy/measure.h"
#include "hierarchy/union_mesh.h"
#include "render/camera.h"
#include "render/display.h"
#include "render/ground.h"
#include "render/occlusion.h"
#include "render/offscreen_target.h"
#include "render/renderer.h"

namespace interleaf {

class BlendPainter {
  public:
    /// \param family   must outlive this object
    /// \param width    pixels
    /// \param height   pixels
    /// \throw UsageError    if no key has a field that \p display shows, or if the keys cannot be raised by it
    /// \throw MachineError  if the machine cannot draw pictures of this size
    /// \pre a GL context is current
    BlendPainter(const Family& family, int width, int height, const Display& display);

    /// \throw UsageError if a key with a place in \p weights lacks the field that the display shows
    void require_field(const Weights& weights) const;

    /// The picture, with the arrows and the legend that the display asks for: 8-bit RGBA, sRGB-encoded, with straight
    /// alpha, top row first. It is a function of the arguments alone.
    /// \throw UsageError as require_field()
    std::vector<std::uint8_t> paint(const Weights& weights, const Camera& camera);

  private:
    void unite_keys(const Weights& weights);
    void draw_surface(const Weights& weights, const Camera& camera);
    const FamilyField* shown() const;
    std::optional<PictureLegend> legend_of_union() const;

    const Family& family_;
    std::vector<FamilyField> fields_;
    Display display_;
    Renderer renderer_;
    OffscreenTarget target_;
    Occlusion occlusion_;
    std::optional<Ground> ground_;  ///< none if it is not shown
    Box box_;                       ///< of all keys
    std::optional<Warp> warp_;
    WarpedFamily warped_;
    UnionMesh mesh_;
    VectorArrows arrows_;
    std::size_t unions_ = 0;               ///< number of unions so far
    std::vector<std::size_t> keys_;        ///< whose union the renderer has
    std::optional<PictureLegend> legend_;  ///< of that union; none if it is not shown
};

}  // namespace interleaf
