#include "app/fitting/tile_places.h"

#include <algorithm>

#include <glm/geometric.hpp>

namespace interleaf {

std::vector<TilePlace> tile_places(std::span<const TileBody> bodies, const PlacingOptions& placing,
                                   const std::optional<SurfaceExtent>& reference) {
    struct Ball {
        glm::dvec3 center;
        double radius;
    };
    std::vector<Ball> balls;
    balls.reserve(bodies.size());
    for (const TileBody& body : bodies) {
        const SurfaceExtent& first = reference ? *reference : bodies.front().surface;
        const SurfaceExtent& own = body.surface;
        const double scale = placing.same_size && own.size > 0 ? first.size / own.size : 1;
        const glm::dvec3 center = placing.same_center ? first.center : own.center;
        balls.push_back({scale * (body.ball_center - own.center) + center, scale * body.ball_radius});
    }
    double reach = 0;
    for (const Ball& ball : balls)
        reach = std::max(reach, glm::distance(ball.center, balls.front().center) + ball.radius);
    std::vector<TilePlace> places(balls.size());
    if (!(reach > 0)) return places;
    for (std::size_t i = 0; i < balls.size(); ++i)
        places[i] = {glm::vec3((balls[i].center - balls.front().center) / reach),
                     static_cast<float>(balls[i].radius / reach)};
    return places;
}

}  // namespace interleaf
