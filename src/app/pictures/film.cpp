#include "app/pictures/film.h"

#include <algorithm>

namespace interleaf {

Weights weights_of_frame(const Film& film, const Family& family, std::size_t number) {
    return film.source ? weights_at(family, film.frames.at(number), *film.source) : film.still;
}

Camera camera_of_frame(const Film& film, std::size_t number) {
    const std::size_t steps = film.is_loop ? film.frames.count : film.frames.count - 1;
    const double part = static_cast<double>(number) / static_cast<double>(std::max<std::size_t>(steps, 1));
    Camera camera = film.camera;
    camera.turn(static_cast<float>(film.turn * part));
    return camera;
}

}  // namespace interleaf
