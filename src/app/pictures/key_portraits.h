// Portraits of keys: the figures and a small picture of each key. Both are made once per hierarchy, however
// the document changes.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "family/family.h"
#include "hierarchy/field.h"
#include "hierarchy/measure.h"
#include "hierarchy/up_axis.h"
#include "render/color_map.h"
#include "render/gl_object.h"
#include "render/renderer.h"

namespace interleaf {

struct KeyPortrait {
    SharedHierarchy hierarchy;
    std::size_t leaves;
    unsigned deepest;  ///< the deepest level
    Extent extent;
    GlTexture picture;    ///< none until drawn
    bool is_old = false;  ///< the picture shows the key in this place before an edit
};

struct PortraitLook {
    bool is_light = false;  ///< the background
    UpAxis up = UpAxis::y;
    std::optional<FieldName> field{};  ///< shown on flat keys, which look alike without it; none for no field
    ColorScale scale{};                ///< of a scalar field
    bool operator==(const PortraitLook&) const = default;
};

class KeyPortraits {
  public:
    /// \pre a GL context is current
    KeyPortraits() = default;

    /// Updates the portraits to the keys of \p family. draw_next() draws the new pictures. Textures of
    /// pictures that are no longer needed are deleted at once.
    void update(const Family& family);

    /// Chooses how the pictures look. draw_next() draws anew those that this changes.
    void set_look(const PortraitLook& look);

    /// Draws the first missing picture among the keys from \p begin to \p end - 1.
    /// \param side  width and height of the picture, in pixels
    /// \return      whether a picture was missing
    bool draw_next(std::size_t begin, std::size_t end, int side);

    /// One per key.
    const std::vector<KeyPortrait>& portraits() const { return portraits_; }

    /// The extent of all keys. A camera that shows it need not move while the keys morph.
    const Extent& extent() const { return extent_; }

  private:
    void keep_old_pictures(std::vector<KeyPortrait>& portraits);

    std::vector<KeyPortrait> portraits_;
    Extent extent_;
    PortraitLook look_;
    Renderer renderer_;
};

}  // namespace interleaf
