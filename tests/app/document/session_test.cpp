// Tests of the session: what drives the morph, and what stays unchanged meanwhile.
#include "app/document/session.h"

#include <memory>
#include <random>
#include <utility>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "app/sample_family.h"
#include "family/domain_edits.h"
#include "family/family_time.h"
#include "family/key_edits.h"

using namespace interleaf;

namespace {

/// \pre  the session has a point
glm::dvec2 point_of(const Session& session) {
    return session.point()->at;
}

}  // namespace

TEST_CASE("a session begins at the begin of the timeline, paused, with the point on the timeline's path") {
    const Session session(std::make_shared<const Family>(sample_family()));
    CHECK(session.driver() == Driver::timeline);
    CHECK(session.time() == 0);
    CHECK_FALSE(session.is_playing());
    CHECK(session.weights() == Weights{{0, 1}, {1, 0}});
    REQUIRE(session.point());
    CHECK(point_of(session) == glm::dvec2(-1, -1));
}

TEST_CASE("scrubbing moves the point along the timeline's path") {
    Session session(std::make_shared<const Family>(sample_family()));
    for (double time = 0; time < 4; time += 0.0625) {
        CAPTURE(time);
        session.seek(time, 1);
        CHECK(session.time() == time);
        CHECK(session.driver() == Driver::timeline);
        CHECK(session.weights() == session.family().timeline->at(time));
        REQUIRE(session.point());
        const glm::dvec2 expected = time <= 1   ? glm::dvec2(2 * time - 1, -1)
                                    : time <= 3 ? glm::dvec2(1, -1) * (3 - time) / 2.0
                                                : glm::dvec2(time - 3);
        CHECK(glm::distance(point_of(session), expected) < 1e-12);
    }
}

TEST_CASE("where the timeline's weights are no point of the domain, there is none") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.seek(4.5, 0);
    CHECK(session.weights() == Weights{{0, 0.5}, {2, 0.5}});
    CHECK_FALSE(session.point());
}

TEST_CASE("moving the point leaves the timeline where it is, for all later times") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.seek(1.25, 10);
    session.move_point({0.25, -0.5}, 11);
    for (const double now : {11.0, 12.0, 100.0}) {
        session.advance(now);
        CHECK(session.driver() == Driver::point);
        CHECK(session.time() == 1.25);
        CHECK(point_of(session) == glm::dvec2(0.25, -0.5));
        CHECK(session.weights() == session.family().domain->weights(*session.point()));
    }
}

TEST_CASE("moving the point while it plays pauses playback at the time it has reached") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.toggle_playing(10);
    session.advance(10.5);
    session.move_point({0, 0.5}, 10.75);
    CHECK_FALSE(session.is_playing());
    CHECK(session.time() == 0.75);
    session.advance(20);
    CHECK(session.time() == 0.75);
}

TEST_CASE("after the point has left the path, playing and scrubbing follow the timeline again") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.seek(2, 0);
    session.move_point({-0.5, 0.75}, 1);
    session.toggle_playing(5);
    CHECK(session.driver() == Driver::timeline);
    CHECK(session.time() == 2);
    CHECK(session.weights() == session.family().timeline->at(2));
    session.advance(5.5);
    CHECK(session.time() == 2.5);

    session.move_point({-0.5, 0.75}, 5.5);
    session.seek(1, 6);
    CHECK(session.driver() == Driver::timeline);
    CHECK(point_of(session) == glm::dvec2(1, -1));
}

TEST_CASE("a point outside is the nearest point of the domain") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.move_point({7, 0.5}, 0);
    CHECK(point_of(session) == glm::dvec2(1, 0.5));
    session.move_point({-7, 9}, 0);
    CHECK(point_of(session) == glm::dvec2(-1, 1));
}

TEST_CASE("on an edge of the domain the active keys stay those of the triangle the point came from") {
    const unsigned seed = 3;
    CAPTURE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> along(0, 1);
    Session session(std::make_shared<const Family>(sample_family()));
    for (int i = 0; i < 200; ++i) {
        // From below or from the right of the edge between the middle and the corner b.
        const bool below = i % 2 == 0;
        session.move_point(below ? glm::dvec2(0, -0.5) : glm::dvec2(0.5, 0), 0);
        const auto before = active_keys(session.weights());
        const double s = along(random);
        session.move_point({s, -s}, 0);
        CHECK(active_keys(session.weights()) == before);
    }
}

TEST_CASE("playing moves in time with the clock and starts over at the end") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.toggle_playing(100);
    CHECK(session.is_playing());
    session.advance(103);
    CHECK(session.time() == 3);
    session.advance(106);
    CHECK(session.time() == 1);
    session.toggle_playing(106);
    session.advance(108);
    CHECK_FALSE(session.is_playing());
    CHECK(session.time() == 1);
}

TEST_CASE("without the loop playing rests at the end") {
    Session session(std::make_shared<const Family>(sample_family()));
    CHECK(session.playback().repeat() == Repeat::loop);
    session.set_repeat(Repeat::once, 0);
    CHECK(session.playback().repeat() == Repeat::once);
    session.toggle_playing(0);
    session.advance(7);
    CHECK(session.time() == 5);
    CHECK_FALSE(session.is_playing());
}

TEST_CASE("switching the loop does not make the timeline drive") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.move_point({0.5, 0.25}, 0);
    session.set_repeat(Repeat::once, 1);
    CHECK(session.driver() == Driver::point);
    CHECK(point_of(session) == glm::dvec2(0.5, 0.25));
}

TEST_CASE("going from key to key visits each key of the timeline, both ways, and stays at the ends") {
    Session session(std::make_shared<const Family>(sample_family()));
    for (const double time : {1.0, 3.0, 4.0, 5.0, 5.0}) {
        session.seek_key(1, 0);
        CHECK(session.time() == time);
    }
    for (const double time : {4.0, 3.0, 1.0, 0.0, 0.0}) {
        session.seek_key(-1, 0);
        CHECK(session.time() == time);
    }
    session.seek(2.5, 0);
    session.seek_key(-1, 0);
    CHECK(session.time() == 1);
    session.seek(2.5, 0);
    session.seek_key(1, 0);
    CHECK(session.time() == 3);
}

TEST_CASE("without a timeline the point drives from the first vertex on, and time stands still") {
    Family family = sample_family();
    family.timeline.reset();
    Session session(std::make_shared<const Family>(std::move(family)));
    CHECK(session.driver() == Driver::point);
    CHECK(point_of(session) == glm::dvec2(-1, -1));
    session.toggle_playing(1);
    session.seek(2, 1);
    session.seek_key(1, 1);
    session.set_repeat(Repeat::once, 1);
    session.advance(2);
    CHECK(session.driver() == Driver::point);
    CHECK(session.time() == 0);
    CHECK_FALSE(session.is_playing());
    CHECK(session.playback().repeat() == Repeat::loop);
}

TEST_CASE("without a domain the timeline drives and there is no point") {
    Family family = sample_family();
    family.domain.reset();
    Session session(std::make_shared<const Family>(std::move(family)));
    session.seek(0.25, 0);
    CHECK_FALSE(session.point());
    CHECK(session.weights() == Weights{{0, 0.75}, {1, 0.25}});
}

TEST_CASE("with neither, the first key is shown as it is") {
    Family family = sample_family();
    family.domain.reset();
    family.timeline.reset();
    Session session(std::make_shared<const Family>(std::move(family)));
    session.advance(10);
    CHECK(session.driver() == Driver::key);
    CHECK(session.weights() == Weights{{0, 1}});
    CHECK_FALSE(session.point());
}

namespace {

std::shared_ptr<const Family> shared(Family family) {
    return std::make_shared<const Family>(std::move(family));
}

}  // namespace

TEST_CASE(
    "with an edited family the timeline goes on from the same time, paused, playing or looping as before") {
    const Family before = sample_family();
    for (const bool playing : {false, true}) {
        for (const bool loops : {false, true}) {
            CAPTURE(playing);
            CAPTURE(loops);
            Session session(shared(before));
            session.seek(2, 10);
            if (!loops) session.set_repeat(Repeat::once, 10);
            if (playing) session.toggle_playing(10);
            session.advance(10.5);
            session.replace_family(shared(with_time_added(before, 3, 6)), 11);
            CHECK(session.time() == (playing ? 3 : 2));
            CHECK(session.is_playing() == playing);
            CHECK((session.playback().repeat() == Repeat::loop) == loops);
            CHECK(session.driver() == Driver::timeline);
            CHECK(session.weights() == session.family().timeline->at(session.time()));
            session.advance(11.25);
            CHECK(session.time() == (playing ? 3.25 : 2));
            session.advance(100);
            CHECK(session.is_playing() == (playing && loops));
        }
    }
}

TEST_CASE("a timeline that is gone and comes back loops as before") {
    const Family before = sample_family();
    Family without = before;
    without.timeline.reset();
    for (const bool loops : {false, true}) {
        CAPTURE(loops);
        Session session(shared(before));
        if (!loops) session.set_repeat(Repeat::once, 0);
        session.replace_family(shared(without), 1);
        session.set_repeat(loops ? Repeat::once : Repeat::loop, 2);  // does nothing
        session.replace_family(shared(before), 3);
        CHECK((session.playback().repeat() == Repeat::loop) == loops);
    }
}

TEST_CASE("a time that the edited timeline does not have becomes the nearest that it has") {
    const Family before = sample_family();
    Session session(shared(before));
    session.seek(4.75, 0);
    session.replace_family(shared(with_time_removed(before, 4)), 0);
    CHECK(session.time() == 4);
    session.seek(0.5, 0);
    session.replace_family(shared(with_time_removed(before, 0)), 0);
    CHECK(session.time() == 1);
    session.replace_family(shared(before), 0);
    CHECK(session.time() == 1);
}

TEST_CASE("the point stays where it is, and is the nearest of an edited domain that it is not in") {
    const Family before = sample_family();
    Session session(shared(before));
    session.move_point({0.5, 0.25}, 0);
    Family after = before;
    after.domain = with_vertex_moved(*before.domain, 4, {0.1, 0.3});
    session.replace_family(shared(after), 0);
    CHECK(session.driver() == Driver::point);
    CHECK(point_of(session) == glm::dvec2(0.5, 0.25));
    CHECK(session.weights() == after.domain->weights(*session.point()));

    after.domain = without_vertex(*before.domain, 1);
    REQUIRE(after.domain);
    session.replace_family(shared(after), 0);
    CHECK(point_of(session) == glm::dvec2(0.375, 0.375));
    CHECK(session.time() == 0);
}

TEST_CASE("a key shown alone is shown on, wherever it goes") {
    const Family before = sample_family();
    Session session(shared(before));
    session.show_key(3, 0);
    session.replace_family(shared(with_key_moved(before, 3, 0)), 0);
    CHECK(session.weights() == Weights{{0, 1}});
    session.replace_family(shared(with_key_removed(before, 0)), 0);
    CHECK(session.weights() == Weights{{2, 1}});
    session.replace_family(shared(with_key_renamed(before, 3, "x")), 0);
    CHECK(session.weights() == Weights{{3, 1}});
    session.replace_family(shared(with_key_removed(before, 3)), 0);
    CHECK(session.driver() == Driver::key);
    CHECK(session.weights() == Weights{{0, 1}});
}

TEST_CASE("the key shown alone is shown, whatever index it gets while something else drives") {
    const Family before = sample_family();
    Session session(shared(before));
    session.show_key(4, 0);
    session.seek(1, 0);
    Family one{"one", {before.keys[0]}, {}, {}};
    session.replace_family(shared(one), 0);
    CHECK(session.driver() == Driver::key);
    CHECK(session.weights() == Weights{{0, 1}});
    CHECK_FALSE(session.point());
    CHECK(session.time() == 0);
    CHECK_FALSE(session.is_playing());
}

TEST_CASE("where the timeline goes, the point drives on from where it had come to") {
    Family after = sample_family();
    Session session(shared(after));
    session.seek(2, 0);
    const glm::dvec2 at = point_of(session);
    const Weights weights = session.weights();
    after.timeline.reset();
    session.replace_family(shared(after), 0);
    CHECK(session.driver() == Driver::point);
    CHECK(point_of(session) == at);
    CHECK(weights.size() == 2);

    // Where it had no point, it starts at the first vertex.
    Session without(shared(sample_family()));
    without.seek(4.5, 0);
    without.replace_family(shared(after), 0);
    CHECK(without.driver() == Driver::point);
    CHECK(point_of(without) == after.domain->vertices().front().at);
}

TEST_CASE("where the domain goes, the timeline drives from its time, and without it the first key") {
    Family after = sample_family();
    Session session(shared(after));
    session.seek(2.5, 0);
    session.move_point({0, 0.5}, 0);
    after.domain.reset();
    session.replace_family(shared(after), 0);
    CHECK(session.driver() == Driver::timeline);
    CHECK(session.time() == 2.5);
    CHECK_FALSE(session.point());
    after.timeline.reset();
    session.replace_family(shared(after), 0);
    CHECK(session.driver() == Driver::key);
    CHECK_FALSE(session.has_timeline());
}

TEST_CASE("a key shown alone is shown whether or not the domain has it, paused at its time") {
    Session session(shared(sample_family()));
    session.toggle_playing(0);
    session.show_key(4, 1.5);
    CHECK(session.driver() == Driver::key);
    CHECK(session.weights() == Weights{{4, 1}});
    CHECK_FALSE(session.is_playing());
    CHECK(session.time() == 1.5);
    REQUIRE(session.point());
    CHECK(point_of(session) == glm::dvec2(0, 0));
    Family without = sample_family();
    without.domain.reset();
    Session bare(shared(without));
    bare.show_key(2, 0);
    CHECK(bare.weights() == Weights{{2, 1}});
    CHECK_FALSE(bare.point());
}

TEST_CASE("steps go from frame to frame, pause playback, and begin at the timeline's begin") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.frame_rate = 4;
    session.toggle_playing(0);
    session.advance(0.3);
    session.step_frame(1, 0.3);
    CHECK_FALSE(session.is_playing());
    CHECK(session.time() == 0.5);
    session.step_frame(-1, 1);
    CHECK(session.time() == 0.25);
    session.frame_rate = 30;
    session.seek(0, 1);
    for (int frame = 1; frame <= 90; ++frame) {
        session.step_frame(1, 1);
        CHECK(session.time() == doctest::Approx(frame / 30.0));
    }
    for (int frame = 89; frame >= 0; --frame) {
        session.step_frame(-1, 1);
        CHECK(session.time() == doctest::Approx(frame / 30.0));
    }
    session.step_frame(-1, 1);
    CHECK(session.time() == 0);
}

TEST_CASE("backward playback follows the timeline backward, and its button pauses it") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.seek(3, 0);
    session.toggle_playing(0, true);
    session.advance(1);
    CHECK(session.plays_back());
    CHECK(session.time() == 2);
    session.toggle_playing(1);  // forward, at once
    session.advance(2);
    CHECK(session.time() == 3);
    CHECK_FALSE(session.plays_back());
    session.toggle_playing(2);
    CHECK_FALSE(session.is_playing());
}

namespace {

/// The sample family with a path from 10 to 14 that drives.
Family family_along_path() {
    const DomainPath path({{10, {-1, -1}}, {12, {0.5, -0.75}}, {14, {0, 3}}});
    return with_time_source(with_path(sample_family(), path), TimeSource::path);
}

}  // namespace

TEST_CASE("a session whose family the path drives begins at the path's begin and follows its point") {
    const Family family = family_along_path();
    Session session(shared(family));
    CHECK(session.driver() == Driver::timeline);
    CHECK(session.time() == 10);
    CHECK_FALSE(session.is_playing());
    CHECK(point_of(session) == glm::dvec2(-1, -1));
    for (double time = 10; time <= 14; time += 0.0625) {
        CAPTURE(time);
        session.seek(time, 1);
        CHECK(session.time() == time);
        CHECK(point_of(session) == place_on_path(family, time).at);
        CHECK(session.weights() == weights_at(family, time, TimeSource::path));
    }
    // Where the path leaves the domain, the point is the nearest one.
    CHECK(point_of(session) == glm::dvec2(0, 1));
}

TEST_CASE("playing goes through the path's times, and going from key to key visits the path's points") {
    Session session(shared(family_along_path()));
    session.toggle_playing(100);
    session.advance(103);
    CHECK(session.time() == 13);
    session.advance(105);
    CHECK(session.time() == 11);
    for (const double time : {12.0, 14.0, 14.0}) {
        session.seek_key(1, 105);
        CHECK(session.time() == time);
    }
    for (const double time : {12.0, 10.0, 10.0}) {
        session.seek_key(-1, 105);
        CHECK(session.time() == time);
    }
}

TEST_CASE("a path without a timeline plays, too") {
    Family family = family_along_path();
    family.timeline.reset();
    family.time_source = TimeSource::keys;
    Session session(shared(family));
    CHECK(session.has_time());
    CHECK_FALSE(session.has_timeline());
    CHECK(session.driver() == Driver::timeline);
    session.toggle_playing(0);
    session.advance(2);
    CHECK(session.time() == 12);
    CHECK(point_of(session) == glm::dvec2(0.5, -0.75));
}

TEST_CASE("after the point has left the path, playing and scrubbing follow the path again") {
    Session session(shared(family_along_path()));
    session.seek(12, 0);
    session.move_point({-0.5, 0.75}, 1);
    CHECK(session.driver() == Driver::point);
    session.advance(2);
    CHECK(point_of(session) == glm::dvec2(-0.5, 0.75));
    session.toggle_playing(5);
    CHECK(session.driver() == Driver::timeline);
    CHECK(point_of(session) == glm::dvec2(0.5, -0.75));
}

TEST_CASE("the other choice of what drives takes the nearest time of its interval, and back") {
    const Family by_path = family_along_path();
    const Family by_keys = with_time_source(by_path, TimeSource::keys);
    Session session(shared(by_keys));
    session.seek(2, 0);
    session.replace_family(shared(by_path), 1);
    CHECK(session.time() == 10);
    CHECK(session.weights() == weights_at(by_path, 10, TimeSource::path));
    CHECK(session.playback().end() == 14);
    session.replace_family(shared(by_keys), 2);
    CHECK(session.time() == 5);
    CHECK(session.weights() == by_keys.timeline->at(5));
}

TEST_CASE("where the path goes, the timeline drives, and without it the point from where it had come to") {
    Family family = family_along_path();
    Session session(shared(family));
    session.seek(12, 0);
    session.replace_family(shared(with_path(family, std::nullopt)), 0);
    CHECK(session.driver() == Driver::timeline);
    CHECK(session.weights() == family.timeline->at(5));

    family.timeline.reset();
    Session lost(shared(family));
    lost.seek(12, 0);
    lost.replace_family(shared(with_path(family, std::nullopt)), 0);
    CHECK(lost.driver() == Driver::point);
    CHECK_FALSE(lost.has_time());
    CHECK(point_of(lost) == glm::dvec2(0.5, -0.75));
}

TEST_CASE("an edited path continues at the same time") {
    const Family before = family_along_path();
    Session session(shared(before));
    session.seek(11, 0);
    const Family after = with_path(before, before.path->with_point_moved(1, {12, {1, 1}}));
    session.replace_family(shared(after), 0);
    CHECK(session.time() == 11);
    CHECK(point_of(session) == glm::dvec2(0, 0));
    session.replace_family(shared(before), 0);
    CHECK(point_of(session) == glm::dvec2(-0.25, -0.875));
}

TEST_CASE("a pause keeps the direction of playback") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.seek(3, 0);
    session.toggle_playing(0, true);
    session.pause(1);
    CHECK_FALSE(session.is_playing());
    CHECK(session.time() == 2);
    CHECK(session.plays_back());
}

TEST_CASE("the next sets of keys stay within the in and out points") {
    Session session(std::make_shared<const Family>(sample_family()));
    session.set_range(TimeRange{0, 3}, 0);
    session.seek(2, 0);
    const Timeline& timeline = *session.family().timeline;
    CHECK(session.next_key_sets().front() == active_keys(timeline.at(0)));  // a loop goes around
    session.set_repeat(Repeat::once, 0);
    CHECK(session.next_key_sets().front() == active_keys(timeline.at(1)));  // there is none behind
}
