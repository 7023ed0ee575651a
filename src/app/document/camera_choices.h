// How the window's camera moves, and what commands ask of it. The camera itself belongs to the window.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "app/document/viewpoint.h"
#include "render/camera.h"

namespace interleaf {

/// The user's choices. They belong to the window: no edit of the document, and no step of undo.
struct CameraChoices {
    OrbitStyle orbit = OrbitStyle::turntable;
    Projection projection = Projection::perspective;
    UpAxis up = UpAxis::y;
    UpAxis chosen_up = UpAxis::y;  ///< the user's own choice, which the settings keep; viewpoints only set up
    bool spins = false;            ///< whether it turns slowly by itself
    bool shows_axes = true;        ///< in a corner of the view
    bool operator==(const CameraChoices&) const = default;
};

enum class ClipboardWish : std::uint8_t { none, copy_view, paste_view, copy_command };

/// Requests of commands, which the window carries out in the same frame.
struct CameraWishes {
    std::vector<std::function<void(Camera&)>> moves{};
    float zoom = 1;  ///< about the middle of the picture; above 1 is nearer
    std::optional<Viewpoint> viewpoint{};
    ClipboardWish clipboard = ClipboardWish::none;
};

}  // namespace interleaf
