// The viewer: the interactive window.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "family/family.h"
#include "render/display.h"

namespace interleaf {

struct ViewerOptions {
    int width = 1280;  ///< of the window, screen coordinates
    int height = 800;
    std::optional<glm::dvec2> at;  ///< where the point begins; needs a domain
    std::optional<double> time;    ///< where the timeline begins, seconds; needs one
    Display display;               ///< what is shown at first
    std::optional<std::filesystem::path>
        picture;  ///< a PNG of the window, written once it rests; then it closes
    std::optional<std::filesystem::path> trace;  ///< gets a JSON line at every change of state
    bool is_alone = false;  ///< leaves the user's settings and recoveries alone, and does not autosave
};

/// Opens a window on \p family, read from \p sources (none for the built-in family), and returns when it is
/// closed.
/// \throw UsageError   when the family lacks the domain or the timeline that the options need
/// \throw DisplayError when no window can be opened
/// \throw MachineError when the picture or the trace cannot be written
void run_viewer(Family family, std::vector<std::filesystem::path> sources, const ViewerOptions& options);

}  // namespace interleaf
