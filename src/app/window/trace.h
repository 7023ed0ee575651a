// The trace: a file that gets one JSON line whenever what the window shows has changed, for tests and for
// reports of faults.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/document/viewer_state.h"
#include "app/pictures/morph_surface.h"
#include "app/window/window_panels.h"
#include "ui/dialogs/fit_dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// What a frame has seen and shown.
struct FrameRecord {
    const ShownWindow& shown;
    glm::vec3 eye;                                 ///< of the camera
    glm::vec2 pointer;                             ///< where Dear ImGui has seen it
    bool is_coarse;                                ///< the picture of the surface can be drawn better
    bool button_down;                              ///< any button of the mouse, as seen there
    bool is_asking;                                ///< a question or the file browser has the keyboard
    bool takes_text;                               ///< a field gets what is typed
    std::optional<Rect> popup;                     ///< the menu or question in front of all others
    std::optional<std::filesystem::path> browsed;  ///< the file browser's cursor, or its folder
    const FitDialog* offer;                        ///< to fit meshes; null for none
};

class Trace {
  public:
    /// \throw MachineError if the file cannot be written
    explicit Trace(const std::filesystem::path& path);

    /// Writes a line for \p frame, which has been shown \p seconds after GLFW was ready, if anything but
    /// these two is new. \throw MachineError if the file cannot be written
    void record(std::size_t frame, double seconds, const ViewerState& state, const SurfaceFigures& figures,
                const FrameRecord& record);

  private:
    std::filesystem::path path_;
    std::ofstream file_;
    std::string last_;
};

}  // namespace interleaf
