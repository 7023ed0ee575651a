// What is shown of each key by itself: its figures, and a small picture. Both are made once for each
// hierarchy, however the document changes.
#pragma once

#include <cstddef>
#include <vector>

#include "family/family.h"
#include "hierarchy/measure.h"
#include "render/gl_object.h"
#include "render/renderer.h"

namespace interleaf {

struct KeyPortrait {
    SharedHierarchy hierarchy;
    std::size_t leaves;
    unsigned deepest;  ///< level
    Extent extent;
    GlTexture picture;  ///< none until it has been drawn
};

class KeyPortraits {
  public:
    /// \pre a context is current
    KeyPortraits() = default;

    /// Brings the portraits in line with the keys of \p family; new pictures are still to be drawn. Textures
    /// of pictures that are no longer needed are deleted at once.
    void update(const Family& family);

    /// Draws the first picture that is missing among the keys from \p begin to \p end - 1, \p side pixels
    /// wide and high. \return whether there was one
    bool draw_next(std::size_t begin, std::size_t end, int side);

    /// One a key.
    const std::vector<KeyPortrait>& portraits() const { return portraits_; }

    /// Of all keys: what a camera views, so that it need not move while they morph.
    const Extent& extent() const { return extent_; }

  private:
    std::vector<KeyPortrait> portraits_;
    Extent extent_;
    Renderer renderer_;
};

}  // namespace interleaf
