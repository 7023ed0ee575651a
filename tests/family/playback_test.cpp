// Tests of playback: tables of wall time against the animation's time, in binary fractions so that they are
// exact.
#include "family/playback.h"

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("playback is paused at the beginning until play") {
    Playback playback(2, 6);
    CHECK(playback.time(0) == 2);
    CHECK(playback.time(100) == 2);
    CHECK_FALSE(playback.is_playing(100));
    playback.play(100);
    CHECK(playback.time(100) == 2);
    CHECK(playback.time(101.5) == 3.5);
    CHECK(playback.is_playing(101.5));
}

TEST_CASE("a loop jumps from the end to the beginning, any number of times") {
    Playback playback(2, 6);
    playback.play(10);
    CHECK(playback.time(13.75) == 5.75);
    CHECK(playback.time(14.25) == 2.25);
    CHECK(playback.time(18.25) == 2.25);
    CHECK(playback.time(10 + 4 * 1000 + 1) == 3);
    CHECK(playback.is_playing(5000));
}

TEST_CASE("without a loop, playback stops at the end and plays again from the beginning") {
    Playback playback(2, 6);
    playback.set_repeat(Repeat::once, 0);
    playback.play(10);
    CHECK(playback.time(13) == 5);
    CHECK(playback.is_playing(13));
    CHECK(playback.time(14) == 6);
    CHECK_FALSE(playback.is_playing(14));
    CHECK(playback.time(99) == 6);
    playback.play(99);
    CHECK(playback.time(99) == 2);
    CHECK(playback.time(100) == 3);
    CHECK(playback.is_playing(100));
}

TEST_CASE("pause keeps the time, and play continues from there") {
    Playback playback(0, 8);
    playback.play(1);
    playback.pause(4);
    CHECK(playback.time(4) == 3);
    CHECK(playback.time(50) == 3);
    CHECK_FALSE(playback.is_playing(50));
    playback.play(50);
    CHECK(playback.time(52) == 5);
}

TEST_CASE("play during playback changes nothing") {
    Playback playback(0, 8);
    playback.play(1);
    playback.play(3);
    CHECK(playback.time(4) == 3);
}

TEST_CASE("a seek jumps, stays within the interval, and does not stop playback") {
    Playback playback(0, 8);
    playback.seek(5, 1);
    CHECK(playback.time(100) == 5);
    CHECK_FALSE(playback.is_playing(100));
    playback.seek(-3, 1);
    CHECK(playback.time(1) == 0);
    playback.seek(30, 1);
    CHECK(playback.time(1) == 8);

    playback.seek(1, 2);
    playback.play(2);
    playback.seek(6, 3);
    CHECK(playback.time(3) == 6);
    CHECK(playback.time(4) == 7);
    CHECK(playback.is_playing(4));
}

TEST_CASE("a seek back from the end, where playback has stopped, does not start it") {
    Playback playback(0, 8);
    playback.set_repeat(Repeat::once, 0);
    playback.play(0);
    playback.seek(2, 20);
    CHECK_FALSE(playback.is_playing(20));
    CHECK(playback.time(25) == 2);
}

TEST_CASE("switching the loop on or off changes no time and does not start stopped playback") {
    Playback playback(0, 8);
    playback.play(0);
    playback.set_repeat(Repeat::once, 11);
    CHECK(playback.time(11) == 3);
    CHECK(playback.time(15) == 7);
    CHECK(playback.time(17) == 8);
    playback.set_repeat(Repeat::loop, 20);
    CHECK(playback.time(25) == 8);
    CHECK_FALSE(playback.is_playing(25));
}

TEST_CASE("a clock that runs backward does not move the animation backward") {
    Playback playback(0, 8);
    playback.seek(3, 10);
    playback.play(10);
    CHECK(playback.time(9) == 3);
}

TEST_CASE("an interval of no length never moves") {
    Playback playback(4, 4);
    playback.play(1);
    CHECK(playback.time(9) == 4);
    CHECK_FALSE(playback.is_playing(9));
}

TEST_CASE("in another interval it keeps its time where it can, its loop, and goes on") {
    Playback playback(0, 8);
    playback.play(0);
    playback.set_interval(2, 6, 3);
    CHECK(playback.begin() == 2);
    CHECK(playback.end() == 6);
    CHECK(playback.time(3) == 3);
    CHECK(playback.time(5) == 5);
    CHECK(playback.is_playing(5));
    playback.set_interval(5.5, 20, 5);
    CHECK(playback.time(5) == 5.5);
    playback.set_interval(1, 4, 5);
    CHECK(playback.time(5) == 1);

    playback.set_repeat(Repeat::once, 5);
    playback.pause(6);
    playback.set_interval(0, 16, 6);
    CHECK(playback.repeat() == Repeat::once);
    CHECK_FALSE(playback.is_playing(6));
    CHECK(playback.time(9) == 2);
}

TEST_CASE("in an interval of no length it stands, also when it gets a longer one") {
    Playback playback(0, 8);
    playback.play(0);
    playback.set_interval(0, 0, 3);
    CHECK(playback.time(3) == 0);
    CHECK_FALSE(playback.is_playing(3));
    playback.set_interval(0, 8, 4);
    CHECK(playback.time(6) == 0);
    CHECK_FALSE(playback.is_playing(6));
}

TEST_CASE("back and forth turns around at both ends, any number of times") {
    Playback playback(2, 6);
    playback.set_repeat(Repeat::back_and_forth, 0);
    playback.play(10);
    CHECK(playback.time(13.5) == 5.5);
    CHECK_FALSE(playback.goes_back(13.5));
    CHECK(playback.time(15) == 5);
    CHECK(playback.goes_back(15));
    CHECK(playback.time(18.5) == 2.5);
    CHECK_FALSE(playback.goes_back(18.5));
    CHECK(playback.time(10 + 8 * 100 + 5) == 5);
    CHECK(playback.is_playing(900));
    // Pausing on the way back keeps the direction for the next change of speed, but play() sets it.
    playback.pause(15);
    CHECK(playback.goes_back(15));
    playback.play(15);
    CHECK(playback.time(16) == 6);
    CHECK(playback.time(17) == 5);
}

TEST_CASE("backward playback is forward playback seen in a mirror") {
    for (const Repeat repeat : repeats())
        for (double start = 2; start <= 6; start += 0.5)
            for (double after = 0; after < 30; after += 0.25) {
                CAPTURE(name_of(repeat));
                CAPTURE(start);
                CAPTURE(after);
                Playback forward(2, 6);
                Playback backward(2, 6);
                forward.set_repeat(repeat, 0);
                backward.set_repeat(repeat, 0);
                forward.seek(start, 0);
                backward.seek(8 - start, 0);
                forward.play(1);
                backward.play(1, true);
                CHECK(forward.is_playing(1 + after) == backward.is_playing(1 + after));
                // At the joint of a loop, one shows one end and the other the other end.
                const double expected = 8 - forward.time(1 + after);
                const double found = backward.time(1 + after);
                const bool at_joint = repeat == Repeat::loop && (found == 2 || found == 6);
                if (!at_joint) CHECK(found == expected);
            }
}

TEST_CASE("a change of speed keeps the time, and the speed has limits") {
    Playback playback(0, 8);
    playback.play(0);
    playback.set_speed(1.0 / 16, 3);
    CHECK(playback.time(3) == 3);
    CHECK(playback.time(19) == 4);
    playback.set_speed(4, 19);
    CHECK(playback.time(19.5) == 6);
    playback.set_speed(1000, 20);
    CHECK(playback.speed() == max_speed);
    playback.set_speed(0, 20);
    CHECK(playback.speed() == min_speed);
}

TEST_CASE("only the range is played, and scrubbing may leave it") {
    Playback playback(0, 10);
    playback.set_range(TimeRange{2, 6}, 0);
    CHECK(playback.has_range());
    playback.play(0);
    CHECK(playback.time(0) == 2);
    CHECK(playback.time(5) == 3);
    playback.seek(9, 5);
    CHECK(playback.time(5) == 6);
    playback.pause(6);
    playback.seek(9, 6);
    CHECK(playback.time(6) == 9);
    playback.play(7, true);
    CHECK(playback.time(7) == 6);
    CHECK(playback.time(8) == 5);
    playback.set_range(TimeRange{8, 9}, 8);
    CHECK(playback.time(8) == 8);
    playback.set_range({}, 8);
    CHECK_FALSE(playback.has_range());
    CHECK(playback.range() == TimeRange{0, 10});
}

TEST_CASE("a range without length, or of the whole interval, is none") {
    Playback playback(0, 10);
    for (const TimeRange range : {TimeRange{4, 4}, TimeRange{6, 2}, TimeRange{-5, 20}, TimeRange{12, 20}}) {
        playback.set_range(range, 0);
        CHECK_FALSE(playback.has_range());
        CHECK(playback.range() == TimeRange{0, 10});
    }
}

TEST_CASE("another interval keeps the part of the range that is in it") {
    Playback playback(0, 10);
    playback.set_range(TimeRange{2, 6}, 0);
    playback.set_interval(4, 20, 0);
    CHECK(playback.range() == TimeRange{4, 6});
    playback.set_interval(8, 20, 0);
    CHECK_FALSE(playback.has_range());
    CHECK(playback.range() == TimeRange{8, 20});
}
