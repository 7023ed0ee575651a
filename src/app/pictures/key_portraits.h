// Portraits of keys: the figures and a small picture of each key. Both are made once per hierarchy, however
// the document changes.
#pragma once

#include <cstddef>
#include <vector>

#include "family/family.h"
#include "hierarchy/measure.h"
#include "hierarchy/up_axis.h"
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

class KeyPortraits {
  public:
    /// \pre a GL context is current
    KeyPortraits() = default;

    /// Updates the portraits to the keys of \p family. draw_next() draws the new pictures. Textures of
    /// pictures that are no longer needed are deleted at once.
    void update(const Family& family);

    /// Chooses the background of the pictures and the axis that points up in them. draw_next() draws all of them
    /// anew when they change.
    void set_look(bool is_light, UpAxis up);

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
    bool is_light_ = false;
    UpAxis up_ = UpAxis::y;
    Renderer renderer_;
};

}  // namespace interleaf
