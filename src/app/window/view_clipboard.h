// Copies the view as text or as a command, and pastes it.
#pragma once

#include <filesystem>
#include <span>

#include <glm/vec2.hpp>

#include "app/document/camera_choices.h"
#include "app/document/viewer_state.h"
#include "app/document/viewpoint.h"
#include "render/camera.h"

namespace interleaf {

/// What the window shows of the document.
struct SeenPicture {
    std::span<const std::filesystem::path> files;  ///< of the document; empty for the built-in family
    const Camera& camera;
    float line_scale = 1;  ///< of lines in the picture
    glm::ivec2 size{0};    ///< pixels
};

/// Lets the window show \p viewpoint from this frame on.
void take_viewpoint(ViewerState& state, const Viewpoint& viewpoint);

/// Carries out \p wish with the clipboard, and tells the user what was copied, or why nothing was pasted.
/// \pre Dear ImGui has begun a frame
void use_clipboard(ClipboardWish wish, ViewerState& state, const SeenPicture& seen, double now);

}  // namespace interleaf
