// The pictures of a message about keys that do not match: the key, and the key it should match.
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/pictures/mismatch_picture.h"
#include "family/synchronize_keys.h"
#include "render/gl_object.h"
#include "render/renderer.h"
#include "ui/dialogs/message_panel.h"

namespace interleaf {

class MismatchPictures {
  public:
    /// Draws the pictures of \p keys, \p size pixels each, unless they are drawn already. If \p keys is null,
    /// drops the pictures.
    /// \pre a GL context is current
    void update(const std::shared_ptr<const MismatchedKeys>& keys, glm::ivec2 size);

    /// The pictures; none without keys, or if the keys are too large to be drawn here.
    const std::vector<MessagePicture>& shown() const { return shown_; }

  private:
    void draw(const Key& key, const RootPlace& place, glm::ivec2 size);

    std::shared_ptr<const MismatchedKeys> keys_;
    std::optional<Renderer> renderer_;  ///< exists while there is something to draw
    std::vector<GlTexture> textures_;
    std::vector<MessagePicture> shown_;
};

}  // namespace interleaf
