// Tests of films: what their frames show, and how the dialog's texts become a film.
#include "app/pictures/film_plan.h"

#include <memory>

#include "messages.h"
#include <doctest/doctest.h>

#include "app/sample_family.h"

using namespace interleaf;

namespace {

Session sample_session() {
    return Session(std::make_shared<const Family>(sample_family()));
}

FilmPlan plan_with(const FilmChoices& choices, const Session& session) {
    return plan_of(choices, session, Camera(), film_format_with_extension(".mp4"));
}

}  // namespace

TEST_CASE("the first choices make a film of the whole timeline") {
    const Session session = sample_session();
    const FilmPlan plan = plan_with(first_choices(session), session);
    CHECK(plan.fault.empty());
    CHECK(plan.film.source == TimeSource::keys);
    CHECK(plan.film.frames.count == 151);
    CHECK(plan.size == glm::ivec2(1280, 720));
    CHECK(weights_of_frame(plan.film, session.family(), 30) ==
          weights_at(session.family(), 1, TimeSource::keys));
}

TEST_CASE("the in and out points are the first choices of From and To") {
    Session session = sample_session();
    session.set_range(TimeRange{1, 3}, 0);
    const FilmPlan plan = plan_with(first_choices(session), session);
    CHECK(plan.film.frames.count == 61);
    CHECK(plan.film.frames.begin == 1);
}

TEST_CASE("where a point or a single key drives, all frames show the present blend") {
    Session session = sample_session();
    session.move_point({0.25, 0.5}, 0);
    const FilmPlan plan = plan_with(first_choices(session), session);
    CHECK(plan.fault.empty());
    CHECK_FALSE(plan.film.source);
    CHECK(weights_of_frame(plan.film, session.family(), 7) == session.weights());
}

TEST_CASE("the camera turns evenly: the last frame has the whole turn, in a loop the first frame again") {
    Film film;
    film.frames = {.begin = 0, .rate = 10, .count = 5};
    film.turn = 360;
    Camera quarter = film.camera;
    quarter.turn(90);
    CHECK(camera_of_frame(film, 1) == quarter);
    film.is_loop = true;
    film.frames.count = 4;
    CHECK(camera_of_frame(film, 1) == quarter);
    CHECK(camera_of_frame(film, 0) == film.camera);
}

TEST_CASE("a fault names its row") {
    const Session session = sample_session();
    const auto fault_with = [&](std::string FilmChoices::*row, const char* text) {
        FilmChoices choices = first_choices(session);
        choices.*row = text;
        return plan_with(choices, session).fault;
    };
    CHECK(contains(fault_with(&FilmChoices::size, "1280"), "Size"));
    CHECK(contains(fault_with(&FilmChoices::size, "0x10"), "Size"));
    CHECK(contains(fault_with(&FilmChoices::size, "99999x10"), "Size"));
    CHECK(contains(fault_with(&FilmChoices::size, "1281x720"), "even"));
    CHECK(contains(fault_with(&FilmChoices::rate, "fast"), "Rate"));
    CHECK(contains(fault_with(&FilmChoices::rate, "0"), "above 0"));
    CHECK(contains(fault_with(&FilmChoices::begin, ""), "From"));
    CHECK(contains(fault_with(&FilmChoices::end, "-1"), "To"));
    CHECK(contains(fault_with(&FilmChoices::end, "1e9"), "frames"));
    CHECK(contains(fault_with(&FilmChoices::turn, "left"), "Turn"));
}

TEST_CASE("a picture has only a size, and shows the present blend") {
    Session session = sample_session();
    session.seek(2, 0);
    FilmChoices choices = first_choices(session);
    choices.size = "33x17";
    choices.rate = "nonsense";
    const FilmPlan plan = plan_of(choices, session, Camera(), nullptr);
    CHECK(plan.fault.empty());
    CHECK(plan.size == glm::ivec2(33, 17));
    CHECK(plan.film.frames.count == 1);
    CHECK(weights_of_frame(plan.film, session.family(), 0) == session.weights());
}

TEST_CASE("a picture begins with the size of the view, and its scale widens its lines, too") {
    Session session = sample_session();
    session.display.wireframe = true;
    FilmChoices choices = first_choices(session, glm::ivec2(640, 400));
    const auto plan_picture_with = [&] { return plan_of(choices, session, Camera(), nullptr); };
    CHECK(plan_picture_with().size == glm::ivec2(640, 400));
    choices.has_legend = false;
    CHECK(plan_picture_with().display == session.display);
    choices.has_legend = true;
    CHECK(plan_picture_with().display.legend);
    choices.scale = "2.5";
    choices.is_transparent = true;
    choices.has_edges = false;
    const FilmPlan plan = plan_picture_with();
    CHECK(plan.fault.empty());
    CHECK(plan.size == glm::ivec2(1600, 1000));
    CHECK(plan.display.line_width == doctest::Approx(2.5F * session.display.line_width));
    CHECK(plan.display.transparent);
    CHECK_FALSE(plan.display.wireframe);
}

TEST_CASE("a scale that is no factor, or gives too large a picture, is a fault") {
    const Session session = sample_session();
    for (const char* scale : {"", "x", "0", "-1", "nan", "17", "0.0001"}) {
        CAPTURE(scale);
        FilmChoices choices = first_choices(session, glm::ivec2(640, 400));
        choices.scale = scale;
        CHECK(plan_of(choices, session, Camera(), nullptr).fault.starts_with("Scale: "));
    }
    FilmChoices large = first_choices(session, glm::ivec2(8192, 400));
    large.scale = "3";
    CHECK(plan_of(large, session, Camera(), nullptr).fault ==
          "Scale: 24576x1200 pixels, at most 16384 a side");
}
