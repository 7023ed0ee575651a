// The trace, for tests and for fault reports: a file that receives one JSON line whenever the content of the
// window changes.
#pragma once

#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "app/document/viewer_state.h"
#include "app/landmarks/landmark_editing.h"
#include "app/pictures/morph_surface.h"
#include "app/window/window_panels.h"
#include "render/camera.h"
#include "ui/dialogs/fit_dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The input that a frame has read, and the content that it has shown.
struct FrameRecord {
    const WindowResult& shown;
    glm::vec3 eye;              ///< of the camera
    const Camera& camera;       ///< of the document's surface
    glm::vec2 pointer;          ///< its position for Dear ImGui, screen coordinates
    bool follows_camera;        ///< whether the detail of the surface does
    bool rests;                 ///< no frame is due until something happens: what is shown is final
    bool button_down;           ///< whether any mouse button is down for Dear ImGui
    bool is_asking;             ///< whether a question or the file browser has the keyboard
    bool takes_text;            ///< whether a text field receives the typed text
    std::optional<Rect> popup;  ///< the frontmost menu or question
    std::optional<std::filesystem::path> browsed;  ///< the file browser's cursor, or its folder
    std::string_view picture_row;              ///< of the dialog of a picture or a film that has the keyboard
    const FitDialog* offer;                    ///< the offer to fit meshes; null for none
    const LandmarkEditing* landmarks;          ///< the landmark window; null unless it is open
    std::vector<std::string> opengl_messages;  ///< complaints of OpenGL since the last record
};

class Trace {
  public:
    /// \throw MachineError if the file cannot be written
    explicit Trace(const std::filesystem::path& path);

    /// Writes a line, unless it differs from the last line only in \p frame and \p seconds. Each line has the
    /// first complaints of OpenGL so far, so that a reader of some lines misses none.
    /// \param frame    number of the frame
    /// \param seconds  time at which the frame was shown, seconds since GLFW was ready
    /// \throw MachineError if the file cannot be written
    void record(std::size_t frame, double seconds, const ViewerState& state, const SurfaceFigures& figures,
                const FrameRecord& record);

  private:
    std::filesystem::path path_;
    std::ofstream file_;
    std::string last_;
    std::vector<std::string> opengl_messages_;  ///< the first ones so far, each once
};

}  // namespace interleaf
