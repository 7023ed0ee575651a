// Tests of the timeline: what dragging names and scrubbing come to, at times that a float cannot hold.
#include "ui/timeline/timeline_panel.h"

#include <cmath>

#include <doctest/doctest.h>

#include "family/key_edits.h"
#include "ui/headless_gui.h"

using namespace interleaf;

namespace {

constexpr Rect panel{0, 640, 1280, 148};

/// Seconds. Around there, neighboring floats are 8 apart.
constexpr double begin = 123456789.5;

Family late_family() {
    Family family;
    family.name = "late";
    for (const char* name : {"a", "b", "c"}) family.keys.push_back({name, {}});
    family.timeline.emplace(std::vector<TimelineKey>{{begin, 0}, {begin + 4, 1}, {begin + 10, 2}});
    return family;
}

TimelineResult show(HeadlessGui& gui, const Family& family, const std::optional<TimeDrag>& drag,
                    glm::vec2 pointer, bool is_down) {
    gui.begin_frame(pointer, is_down);
    const Weights weights = family.timeline->at(begin);
    const TimelineResult result = timeline_panel(panel, family,
                                                 {.transport = {.time = begin,
                                                                .end = family.timeline->end(),
                                                                .playing = false,
                                                                .plays_back = false,
                                                                .repeat = Repeat::loop,
                                                                .speed = 1,
                                                                .frame_rate = 30,
                                                                .interpolation = {},
                                                                .source = TimeSource::keys,
                                                                .has_both_sources = false},
                                                  .drives = true,
                                                  .remark = "",
                                                  .drag = drag,
                                                  .weights = weights});
    gui.end_frame();
    return result;
}

/// The place of the name of the key at \p part of the track.
glm::vec2 name_at(const Rect& track, double part) {
    return {track.x + track.width * static_cast<float>(part), track.bottom() + 6};
}

}  // namespace

TEST_CASE("a name is dragged to the time under the pointer, however large times are") {
    HeadlessGui gui({1280, 800});
    Family family = late_family();
    const Rect track = show(gui, family, {}, {0, 0}, false).area;
    show(gui, family, {}, name_at(track, 0.4), false);
    std::optional<TimeDrag> drag = show(gui, family, {}, name_at(track, 0.4), true).track.drag;
    REQUIRE(drag);
    CHECK(drag->place == 1);
    for (const double part : {0.45, 0.7, 0.25}) {
        CAPTURE(part);
        const TimelineResult result = show(gui, family, drag, name_at(track, part), true);
        REQUIRE(result.track.moved);
        CHECK(result.track.moved->place == 1);
        CHECK(std::abs(result.track.moved->to - (begin + 10 * part)) <= 0.1);
        family = with_time_moved(family, result.track.moved->place, result.track.moved->to);
        drag = result.track.drag;
        REQUIRE(drag);
    }
    CHECK_FALSE(show(gui, family, drag, name_at(track, 0.25), false).track.drag);
}

TEST_CASE("dragging the last name does not move the scale under the pointer") {
    HeadlessGui gui({1280, 800});
    Family family = late_family();
    const Rect track = show(gui, family, {}, {0, 0}, false).area;
    show(gui, family, {}, name_at(track, 1), false);
    std::optional<TimeDrag> drag = show(gui, family, {}, name_at(track, 1), true).track.drag;
    for (int frame = 0; frame < 4; ++frame) {
        CAPTURE(frame);
        const TimelineResult result = show(gui, family, drag, name_at(track, 0.8), true);
        REQUIRE(result.track.moved);
        CHECK(result.track.moved->place == 2);
        CHECK(std::abs(result.track.moved->to - (begin + 8)) <= 0.1);
        family = with_time_moved(family, result.track.moved->place, result.track.moved->to);
        drag = result.track.drag;
    }
    CHECK(std::abs(family.timeline->end() - (begin + 8)) <= 0.1);
}

TEST_CASE("scrubbing goes to the time under the pointer, and to a key's own time near a key") {
    HeadlessGui gui({1280, 800});
    const Family family = late_family();
    const Rect track = show(gui, family, {}, {0, 0}, false).area;
    const glm::vec2 middle{track.x + track.width / 2, track.y + track.height / 2};
    show(gui, family, {}, middle, false);
    const TimelineResult pressed = show(gui, family, {}, middle, true);
    REQUIRE(pressed.track.seek_to);
    CHECK(std::abs(*pressed.track.seek_to - (begin + 5)) < 0.01);
    const TimelineResult dragged = show(gui, family, {}, {track.x + 0.4F * track.width + 2, middle.y}, true);
    CHECK(dragged.track.seek_to == begin + 4);
    CHECK_FALSE(show(gui, family, {}, middle, false).track.seek_to);
}

TEST_CASE("a key among hundreds stays between its neighbors while it is dragged") {
    HeadlessGui gui({1280, 800});
    Family family;
    family.name = "dense";
    std::vector<TimelineKey> times;
    for (std::size_t key = 0; key < 300; ++key) {
        family.keys.push_back({"k", {}});
        times.push_back({0.001 + 0.004 * static_cast<double>(key), key});
    }
    family.timeline.emplace(times);
    const Rect track = show(gui, family, {}, {0, 0}, false).area;
    const glm::vec2 first = name_at(track, 0);
    show(gui, family, {}, first, false);
    const auto drag = show(gui, family, {}, first, true).track.drag;
    REQUIRE(drag);
    const auto moved = show(gui, family, drag, name_at(track, 0.5), true).track.moved;
    REQUIRE(moved);
    CHECK(moved->place == 0);
    CHECK(moved->to < times[1].time);
}

TEST_CASE("the list of interpolations also lets parts turn") {
    HeadlessGui gui({1280, 800});
    const Family family = late_family();
    std::optional<BlendKind> chosen;
    const auto click = [&](glm::vec2 at) {
        for (const bool is_down : {false, true, false})
            if (const auto blend = show(gui, family, {}, at, is_down).transport.blend) chosen = blend;
        show(gui, family, {}, at, false);
    };
    for (float y = 480; y < 796 && !chosen; y += 12) {
        click({540, 662});  // opens the list
        click({540, y});
    }
    CHECK(chosen == BlendKind::turning);
}
