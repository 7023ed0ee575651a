#include "app/pictures/film_plan.h"

#include <cmath>
#include <optional>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "family/family_time.h"
#include "hierarchy/error.h"
#include "text/parsed_number.h"

namespace interleaf {
namespace {

constexpr int max_picture_side = 16384;
constexpr double still_seconds = 5;
constexpr double max_scale = 16;

std::optional<glm::ivec2> typed_size(const std::string& text) {
    const std::size_t times = text.find('x');
    if (times == std::string::npos) return std::nullopt;
    const auto width = parsed_number<int>(text.substr(0, times));
    const auto height = parsed_number<int>(text.substr(times + 1));
    const auto is_allowed = [](std::optional<int> side) {
        return side && *side >= 1 && *side <= max_picture_side;
    };
    if (!is_allowed(width) || !is_allowed(height)) return std::nullopt;
    return glm::ivec2(*width, *height);
}

bool fits(glm::dvec2 size) {
    return size.x >= 1 && size.y >= 1 && size.x <= max_picture_side && size.y <= max_picture_side;
}

std::optional<double> typed_number(const std::string& text) {
    const auto number = parsed_number<double>(text);
    return number && std::isfinite(*number) ? number : std::nullopt;
}

/// What drives the film: the time, if it drives the session.
std::optional<TimeSource> driving_time(const Session& session) {
    return session.driver() == Driver::timeline ? source_of_time(session.family()) : std::nullopt;
}

FilmPlan faulty(std::string fault) {
    FilmPlan plan;
    plan.fault = std::move(fault);
    return plan;
}

/// Reads the rows that only a film has.
void plan_times(const FilmChoices& choices, const FilmFormat& format, FilmPlan& plan) {
    const auto rate = typed_number(choices.rate);
    const auto begin = typed_number(choices.begin);
    const auto end = typed_number(choices.end);
    const auto turn = typed_number(choices.turn);
    if (!rate) plan.fault = "Rate: expected a number of frames per second";
    if (!begin || !end) plan.fault = "From, To: expected seconds";
    if (begin && end && *end < *begin) plan.fault = "To: expected a time after From";
    if (!turn) plan.fault = "Turn: expected degrees";
    if (!plan.fault.empty()) return;
    plan.film.turn = static_cast<float>(*turn);
    plan.film.is_loop = choices.is_loop;
    try {
        plan.film.frames = frames_in({*begin, *end}, *rate, choices.is_loop);
        require_encodable(format, {plan.size.x, plan.size.y, *rate});
    } catch (const std::runtime_error& error) {
        plan.fault = error.what();
    }
}

/// Reads the rows that only a single picture has.
void plan_picture(const FilmChoices& choices, FilmPlan& plan) {
    const auto scale = typed_number(choices.scale);
    if (!scale || *scale <= 0 || *scale > max_scale) {
        plan.fault = fmt::format("Scale: expected a factor up to {}", max_scale);
        return;
    }
    const glm::dvec2 size = glm::round(*scale * glm::dvec2(plan.size));
    if (!fits(size)) {
        plan.fault =
            fmt::format("Scale: {:.0f}x{:.0f} pixels, at most {} a side", size.x, size.y, max_picture_side);
        return;
    }
    plan.size = glm::ivec2(size);
    plan.display.line_width *= static_cast<float>(*scale);
    plan.display.transparent = choices.is_transparent;
    if (!choices.has_edges)
        plan.display.wireframe = plan.display.refinement_edges = plan.display.root_edges = false;
}

}  // namespace

FilmChoices first_choices(const Session& session, std::optional<glm::ivec2> picture_size) {
    TimeRange range{0, still_seconds};
    if (driving_time(session)) range = session.playback().range();
    FilmChoices choices;
    choices.begin = fmt::format("{}", range.begin);
    choices.end = fmt::format("{}", range.end);
    choices.rate = fmt::format("{}", session.frame_rate);
    if (picture_size) choices.size = fmt::format("{}x{}", picture_size->x, picture_size->y);
    return choices;
}

FilmPlan plan_of(const FilmChoices& choices, const Session& session, const Camera& camera,
                 const FilmFormat* format) {
    const auto size = typed_size(choices.size);
    if (!size)
        return faulty(fmt::format("Size: expected WIDTHxHEIGHT, sides from 1 to {}", max_picture_side));
    FilmPlan plan;
    plan.size = *size;
    plan.display = session.display;
    plan.display.legend = choices.has_legend;
    plan.film.camera = camera;
    plan.film.still = session.weights();
    if (format == nullptr) {
        plan_picture(choices, plan);
        return plan;
    }
    plan.film.source = driving_time(session);
    plan_times(choices, *format, plan);
    return plan;
}

}  // namespace interleaf
