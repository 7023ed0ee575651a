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
    std::optional<glm::ivec2> size;  ///< of the window, screen coordinates; by default as it was last
    std::optional<glm::dvec2> at;    ///< where the point begins; needs a domain
    std::optional<double> time;      ///< where the timeline begins, seconds; needs one
    Display display;                 ///< what is shown at first
    std::optional<std::filesystem::path>
        picture;  ///< a PNG of the window, written once it rests; then it closes
    std::optional<std::filesystem::path> trace;  ///< gets a JSON line at every change of state
};

/// Opens a window on \p family, read from \p sources (none for the built-in family), offers to fit \p meshes
/// as if they had been dropped on it, if there are any, and returns when it is closed.
/// \throw UsageError   when the family lacks the domain or the timeline that the options need
/// \throw DisplayError when no window can be opened
/// \throw MachineError when the picture or the trace cannot be written
void run_viewer(Family family, std::vector<std::filesystem::path> sources,
                std::vector<std::filesystem::path> meshes, const ViewerOptions& options);

}  // namespace interleaf
