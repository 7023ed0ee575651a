// Dear ImGui without a window: a test acts as the mouse, and looks at what would be drawn.
#pragma once

#include <vector>

#include <glm/vec2.hpp>

#include "ui/widgets/gui_state.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class HeadlessGui {
  public:
    /// \param size  size of the display
    explicit HeadlessGui(glm::vec2 size);
    ~HeadlessGui();
    HeadlessGui(const HeadlessGui&) = delete;
    HeadlessGui& operator=(const HeadlessGui&) = delete;

    /// Begins a frame with the pointer at \p pointer and the left button up or down.
    void begin_frame(glm::vec2 pointer, bool is_button_down);

    /// Begins the second pass of the frame, as Gui::begin_drawing() does.
    void begin_drawing();

    void end_frame();

    /// Whether the last frame draws something in \p color within \p area.
    /// \param color  packed as Dear ImGui packs it
    bool has_color(unsigned color, const Rect& area) const;

  private:
    GuiState state_;
};

}  // namespace interleaf
