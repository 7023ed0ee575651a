// Turns the texts of the film dialog into a film.
#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "app/document/session.h"
#include "app/pictures/film.h"
#include "io/film/film_encoder.h"
#include "render/camera.h"
#include "render/display.h"
#include "ui/dialogs/film_dialog.h"

namespace interleaf {

/// The choices that the dialog begins with: the whole time of \p session, or the part between its in and out
/// points; a still blend lasts some seconds.
/// \param picture_size  of the view, pixels; for a single picture. A film has a usual size.
FilmChoices first_choices(const Session& session, std::optional<glm::ivec2> picture_size = std::nullopt);

struct FilmPlan {
    Film film;
    glm::ivec2 size{0};  ///< pixels, of the picture at its scale
    Display display;     ///< of its frames
    std::string fault;   ///< what is wrong with the choices; the other members count only if it is empty
};

/// \param session  what drives its blend drives the film; if that is no time, all frames show its blend
/// \param camera   the camera of frame 0
/// \param format   null for a single picture, which is the blend of \p session
FilmPlan plan_of(const FilmChoices& choices, const Session& session, const Camera& camera,
                 const FilmFormat* format);

}  // namespace interleaf
