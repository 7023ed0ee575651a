// The keyboard in the panels: which panel has it, and which of its parts is in focus. Dear ImGui's navigation does the
// rest: arrow keys move, Space presses or takes hold, Enter presses or lets type, Esc leaves.
#pragma once

namespace interleaf {

class PanelKeyboard {
  public:
    /// Gives the keyboard to the next shown panel (\p step 1) or to the previous one (-1). Between the last panel and
    /// the first one, no panel has the keyboard. With \p step 0 nothing happens.
    /// \return whether the keyboard goes elsewhere; then the panels find their focus only after several frames
    /// \pre within a frame
    bool step(int step);

    /// Takes the keyboard from the panels where the user has asked for it: by Esc, by a click, or because the panel
    /// is no longer shown. Call it before each frame.
    void follow();

    bool has_keyboard() const { return panel_ != nullptr; }

  private:
    const char* panel_ = nullptr;  ///< name of the panel's window; null for none
};

}  // namespace interleaf
