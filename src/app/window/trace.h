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
#include "ui/dialogs/fit_dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// Where the pointer is, and the parts it can act on, in screen coordinates of the window.
struct TracePlaces {
    glm::vec2 window;  ///< size
    Rect view;
    Rect keys;                                     ///< the rows of keys in sight
    std::optional<Rect> domain;                    ///< the bounding box of the domain's vertices
    std::optional<Rect> timeline;                  ///< the track from begin to end
    glm::vec2 pointer;                             ///< where the user interface has seen it
    bool button_down;                              ///< any of the mouse, as seen there
    bool is_asking;                                ///< a question or the file browser is open
    bool takes_text;                               ///< what is typed goes into a field
    std::optional<Rect> popup;                     ///< the menu or question in front of all others
    std::optional<std::filesystem::path> browsed;  ///< the file browser's cursor, or its folder
    const FitDialog* offer;                        ///< to fit meshes; null for none
};

class Trace {
  public:
    /// \throw MachineError if the file cannot be written
    explicit Trace(const std::filesystem::path& path);

    /// Writes a line for \p frame, which has been shown \p seconds after GLFW was ready,
    /// if anything but these two is new. \throw MachineError if the file cannot be written
    void record(std::size_t frame, double seconds, const ViewerState& state, const SurfaceFigures& figures,
                glm::vec3 eye, const TracePlaces& places);

  private:
    std::filesystem::path path_;
    std::ofstream file_;
    std::string last_;
};

}  // namespace interleaf
