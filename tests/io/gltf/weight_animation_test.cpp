// The timeline as an animation of morph weights.
#include "io/gltf/weight_animation.h"

#include <array>
#include <random>

#include <doctest/doctest.h>

#include "io/samples.h"

namespace interleaf {

namespace {

constexpr std::array<std::size_t, 2> targets{1, 2};

Family family_with(Interpolation interpolation) {
    std::mt19937 random(3);
    Family family = sample_family(random);
    family.timeline = Timeline({{-1, 0}, {0, 1}, {1, 2}, {3, 1}}, interpolation);
    return family;
}

}  // namespace

TEST_CASE("a linear timeline is its keys, delayed so that no time is negative") {
    const auto animation = weight_animation(family_with({}), targets);
    REQUIRE(animation);
    CHECK(animation->delay == 1);
    CHECK_FALSE(animation->is_stepped);
    CHECK(animation->times == std::vector<float>{0, 1, 2, 4});
    CHECK(animation->weights == std::vector<float>{0, 0, 1, 0, 0, 1, 1, 0});
    CHECK(animation->least == 0);
    CHECK(animation->most == 1);
}

TEST_CASE("a held timeline is stepped") {
    const auto animation = weight_animation(family_with({Basis::hold}), targets);
    REQUIRE(animation);
    CHECK(animation->is_stepped);
    CHECK(animation->times.size() == 4);
}

TEST_CASE("other bases are sampled 30 times per second, at the times of keys, too") {
    for (const Basis basis : {Basis::bernstein, Basis::catmull_rom, Basis::b_spline, Basis::spline}) {
        CAPTURE(name_of(basis));
        const Family family = family_with({basis});
        const auto animation = weight_animation(family, targets);
        REQUIRE(animation);
        CHECK(animation->times.size() == 4 * 30 + 1);
        for (std::size_t i = 0; i < animation->times.size(); ++i) {
            const double time = double{animation->times[i]} - 1;
            const auto expected = target_weights(family.timeline->at(time), targets);
            CHECK(animation->weights[2 * i] == doctest::Approx(expected[0]).epsilon(1e-5));
            CHECK(animation->weights[2 * i + 1] == doctest::Approx(expected[1]).epsilon(1e-5));
        }
        const bool overshoots = basis == Basis::catmull_rom || basis == Basis::spline;
        CHECK((animation->least < -0.01) == overshoots);
    }
}

TEST_CASE("a path is an animation of its own, where it drives") {
    Family family = family_with({});
    family.path = DomainPath({{0, {0, 0}}, {0.5, {1, 0.1}}, {1, {-1.0 / 3, 1}}});
    family.time_source = TimeSource::path;
    const auto animation = weight_animation(family, targets);
    REQUIRE(animation);
    CHECK(animation->name == "path");
    CHECK(animation->times.size() == 31);
    CHECK(animation->weights[30] == doctest::Approx(1));
}

TEST_CASE("no animation without a duration, and few samples of a very long time") {
    Family family = family_with({Basis::spline});
    family.timeline = Timeline({{0, 1}});
    CHECK_FALSE(weight_animation(family, targets));
    family.timeline.reset();
    CHECK_FALSE(weight_animation(family, targets));
    family.timeline = Timeline({{0, 1}, {1, 0}, {1e9, 2}, {2e9, 0}}, {Basis::spline});
    CHECK(weight_animation(family, targets)->times.size() < 100'010);
}

}  // namespace interleaf
