// Everything that is made from the state of the document to be seen: the surface or a comparison, the
// pictures of keys, the pictures beside a message.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "app/document/viewer_state.h"
#include "app/pictures/key_portraits.h"
#include "app/pictures/mismatch_pictures.h"
#include "app/window/comparison_view.h"
#include "app/window/frame_layout.h"
#include "app/window/redraw.h"
#include "app/window/surface_view.h"
#include "app/window/window_panels.h"
#include "family/family_fields.h"
#include "ui/gui.h"

namespace interleaf {

class DocumentViews {
  public:
    /// \pre a context is current
    DocumentViews() = default;

    /// Moves the cameras, and makes in \p state the choices of a comparison's panel.
    /// \pre \p actions were done in panels that showed \p state in \p layout
    void apply(const WindowActions& actions, ViewerState& state, const FrameLayout& layout);

    /// Brings everything in line with \p state. Takes its wishes for the camera and for shaders; what it
    /// displays becomes what its family has.
    void follow(ViewerState& state, const FrameLayout& layout, const Gui& gui);

    /// Draws pictures of keys that are missing among the rows that \p shown had in sight: one per frame, so
    /// that the window stays quick.
    /// \return whether there was one
    bool draw_portrait(const ShownWindow& shown, const Gui& gui);

    /// Draws the surface or the comparison behind the panels, and the value under the pointer before them.
    /// \param view  what the mouse did over the surface
    /// \return whether the pictures are as good as they get; otherwise draw again soon
    /// \pre follow() has been called for \p state
    bool draw(const ViewerState& state, const FrameLayout& layout, const std::optional<ViewInput>& view,
              const Gui& gui);

    /// The comparison that is shown instead of the document; null for none.
    const ComparisonView* comparison() const { return comparison_.is_shown() ? &comparison_ : nullptr; }

    const std::vector<KeyPortrait>& portraits() const { return portraits_.portraits(); }
    const std::vector<FamilyField>& fields() const { return fields_; }
    const SurfaceFigures& figures() const { return surface_.figures(); }
    const std::vector<MessagePicture>& message_pictures() const { return mismatch_pictures_.shown(); }

    /// Where the camera is.
    glm::vec3 eye() const;

  private:
    void reload_shaders(ViewerState& state);

    std::shared_ptr<const Family> family_;  ///< that fields and portraits are about
    std::vector<FamilyField> fields_;
    SurfaceView surface_;
    ComparisonView comparison_;
    KeyPortraits portraits_;
    MismatchPictures mismatch_pictures_;
};

}  // namespace interleaf
