// The viewer: the interactive window.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "app/document/viewpoint.h"
#include "family/family.h"
#include "render/display.h"
#include "ui/widgets/appearance.h"

namespace interleaf {

struct ViewerOptions {
    std::optional<glm::ivec2> size;   ///< of the window, screen coordinates; by default the last size
    std::optional<glm::dvec2> at;     ///< initial point of the domain; needs a domain
    std::optional<double> time;       ///< initial time, in the unit of the timeline or the path; needs either
    std::optional<TimeSource> along;  ///< what drives the blend; another choice than the family's is an edit
    Display display;                  ///< initial display
    std::optional<Theme> theme{};     ///< of the window; by default the last one
    std::optional<Viewpoint> viewpoint;  ///< initial view; by default all keys
    std::optional<std::filesystem::path>
        picture;  ///< PNG file that receives the resting window, which then closes
    std::optional<std::filesystem::path> trace;  ///< file that receives a JSON line per change (trace.h)
    std::optional<std::filesystem::path> stats;  ///< file that receives a JSON line per frame (frame_stats.h)
};

/// Opens a window on \p family, and returns when the window is closed.
/// \param sources  the files of the family; empty for the built-in family
/// \param meshes   the window offers to fit these meshes, as if they had been dropped on it; may be empty
/// \throw UsageError    if the family lacks the domain, the timeline or the field that the options need
/// \throw DisplayError  if no window can be opened
/// \throw MachineError  if the picture, the trace or the stats cannot be written
void run_viewer(Family family, std::vector<std::filesystem::path> sources,
                std::vector<std::filesystem::path> meshes, const ViewerOptions& options);

}  // namespace interleaf
