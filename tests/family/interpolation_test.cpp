// Tests of the interpolation bases: each has a name and weights that sum to 1; interpolating bases give the
// keys at their times.
#include "family/interpolation.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <vector>

#include <doctest/doctest.h>

#include "family/spline_weights.h"

using namespace interleaf;

namespace {

using Times = std::vector<TimelineKey>;

/// Keys 0, 1, 2, ... at random times, some of them 1e-6 apart.
Times random_times(std::size_t count, std::mt19937& random) {
    std::uniform_real_distribution<double> gap(0.05, 3);
    Times keys;
    double time = -2;
    for (std::size_t key = 0; key < count; ++key) {
        keys.push_back({time, key});
        time += random() % 6 == 0 ? 1e-6 : gap(random);
    }
    return keys;
}

/// The weight of each of \p count keys, zeros included.
std::vector<double> dense(const Weights& weights, std::size_t count) {
    std::vector<double> values(count, 0);
    for (const Weight& weight : weights) values[weight.key] = weight.value;
    return values;
}

std::vector<double> dense_at(const Interpolation& interpolation, const Times& keys, double time) {
    return dense(weights_at(interpolation, keys, time), keys.size());
}

std::vector<double> times_of(const Times& keys) {
    std::vector<double> times;
    for (const TimelineKey& key : keys) times.push_back(key.time);
    return times;
}

double sum_of(const Weights& weights) {
    double sum = 0;
    for (const Weight& weight : weights) sum += weight.value;
    return sum;
}

/// The binomial coefficient n over k.
double binomial(std::size_t n, std::size_t k) {
    double value = 1;
    for (std::size_t i = 0; i < k; ++i) value *= static_cast<double>(n - i) / static_cast<double>(i + 1);
    return value;
}

}  // namespace

TEST_CASE("every basis is found by a name of its own") {
    std::set<std::string_view> names;
    for (const Basis each : bases()) {
        CHECK(names.insert(name_of(each)).second);
        CHECK(basis_named(name_of(each)) == each);
    }
    CHECK(names ==
          std::set<std::string_view>{"linear", "hold", "bernstein", "catmull-rom", "b-spline", "spline"});
    CHECK_FALSE(basis_named("Linear"));
    CHECK_FALSE(basis_named(""));
}

TEST_CASE("the weights of every basis are sparse, ascending and sum to 1") {
    std::mt19937 random(1);
    for (const Basis each : bases()) {
        CAPTURE(name_of(each));
        for (std::size_t count = 1; count <= 50; count += count < 8 ? 1 : 14) {
            Times keys = random_times(count, random);
            for (TimelineKey& key : keys) key.key = key.key * 7 % 11;  // the same key at several times
            for (double part = 0; part <= 1; part += 1.0 / 64) {
                const double time = keys.front().time + part * (keys.back().time - keys.front().time);
                const Weights weights = weights_at({.basis = each}, keys, time);
                REQUIRE_FALSE(weights.empty());
                for (std::size_t i = 1; i < weights.size(); ++i) REQUIRE(weights[i - 1].key < weights[i].key);
                REQUIRE(std::abs(sum_of(weights) - 1) <= 1e-15);
            }
        }
    }
}

TEST_CASE("at its own time, a key of an interpolating basis has exactly the weight 1") {
    std::mt19937 random(2);
    for (const Basis each : {Basis::linear, Basis::hold, Basis::catmull_rom, Basis::spline}) {
        CAPTURE(name_of(each));
        for (std::size_t count = 1; count <= 40; ++count) {
            const Times keys = random_times(count, random);
            for (std::size_t place = 0; place < count; ++place) {
                std::vector<double> expected(count, 0);
                expected[place] = 1;
                REQUIRE(dense_at({.basis = each}, keys, keys[place].time) == expected);
            }
        }
    }
}

TEST_CASE("Bernstein and the B-spline begin at the first key and end at the last one") {
    std::mt19937 random(3);
    for (const Basis each : {Basis::bernstein, Basis::b_spline})
        for (std::size_t count = 1; count <= 12; ++count) {
            const Times keys = random_times(count, random);
            std::vector<double> expected(count, 0);
            expected.front() = 1;
            CHECK(dense_at({.basis = each}, keys, keys.front().time) == expected);
            expected.front() = 0;
            expected.back() = 1;
            CHECK(dense_at({.basis = each}, keys, keys.back().time) == expected);
        }
}

TEST_CASE("two keys are blended linearly by every basis but hold") {
    const Times keys{{1, 0}, {3, 1}};
    for (const Basis each : bases()) {
        CAPTURE(name_of(each));
        const std::vector<double> weights = dense_at({.basis = each}, keys, 1.5);
        CHECK(weights[1] == doctest::Approx(each == Basis::hold ? 0 : 0.25));
    }
}

TEST_CASE("the active keys change at the times of keys only") {
    std::mt19937 random(4);
    for (const Basis each : bases()) {
        CAPTURE(name_of(each));
        const Times keys = random_times(30, random);
        for (std::size_t place = 0; place + 1 < keys.size(); ++place) {
            const double length = keys[place + 1].time - keys[place].time;
            const auto active = active_keys(weights_at({.basis = each}, keys, keys[place].time));
            for (const double part : {0.01, 0.3, 0.99}) {
                const double time = keys[place].time + part * length;
                REQUIRE(active_keys(weights_at({.basis = each}, keys, time)) == active);
            }
        }
    }
}

TEST_CASE("hold shows a key until the time of the next key") {
    const Times keys{{0, 5}, {1, 2}, {4, 3}};
    CHECK(weights_at({.basis = Basis::hold}, keys, 0.999) == Weights{{5, 1}});
    CHECK(weights_at({.basis = Basis::hold}, keys, 1) == Weights{{2, 1}});
    CHECK(weights_at({.basis = Basis::hold}, keys, 3.999) == Weights{{2, 1}});
    CHECK(weights_at({.basis = Basis::hold}, keys, 4) == Weights{{3, 1}});
}

TEST_CASE(
    "Bernstein's weights are the Bernstein polynomials, whatever the inner keys' times (equation (4))") {
    std::mt19937 random(5);
    for (std::size_t count = 2; count <= 20; ++count) {
        const Times keys = random_times(count, random);
        const std::size_t n = count - 1;
        for (double t = 0; t <= 1; t += 1.0 / 16) {
            const double time = keys.front().time + t * (keys.back().time - keys.front().time);
            const double s = (time - keys.front().time) / (keys.back().time - keys.front().time);
            const std::vector<double> weights = dense_at({.basis = Basis::bernstein}, keys, time);
            for (std::size_t k = 0; k < count; ++k)
                CHECK(weights[k] == doctest::Approx(binomial(n, k) * std::pow(s, static_cast<double>(k)) *
                                                    std::pow(1 - s, static_cast<double>(n - k)))
                                        .epsilon(1e-12));
        }
    }
}

TEST_CASE("pieces of Bernstein polynomials meet at keys, and a short last piece has a lower degree") {
    const Times keys{{0, 0}, {1, 1}, {2, 2}, {4, 3}, {5, 4}, {6, 5}};
    const Interpolation quadratic{.basis = Basis::bernstein, .degree = 2};
    CHECK(dense_at(quadratic, keys, 1) == std::vector<double>{0.25, 0.5, 0.25, 0, 0, 0});
    CHECK(dense_at(quadratic, keys, 2) == std::vector<double>{0, 0, 1, 0, 0, 0});
    CHECK(dense_at(quadratic, keys, 3.5) == std::vector<double>{0, 0, 0.25, 0.5, 0.25, 0});
    CHECK(dense_at(quadratic, keys, 5.5) == std::vector<double>{0, 0, 0, 0, 0.5, 0.5});
    CHECK(dense_at(quadratic, keys, 6) == std::vector<double>{0, 0, 0, 0, 0, 1});
    // A degree of all keys or more is the whole polynomial.
    const Interpolation large{.basis = Basis::bernstein, .degree = 9};
    CHECK(dense_at(large, keys, 3.3) == dense_at({.basis = Basis::bernstein}, keys, 3.3));
}

TEST_CASE("the B-spline's weights are never negative, and it does not depend on the unit of time") {
    std::mt19937 random(6);
    for (std::size_t count = 2; count <= 20; ++count) {
        const Times keys = random_times(count, random);
        Times scaled = keys;
        for (TimelineKey& key : scaled) key.time = 64 * key.time + 8;
        for (double part = 0; part <= 1; part += 1.0 / 128) {
            const double time =
                std::min(keys.front().time + part * (keys.back().time - keys.front().time), keys.back().time);
            const auto weights = dense_at({.basis = Basis::b_spline}, keys, time);
            CHECK(std::ranges::min(weights) >= 0);
            const auto again = dense_at({.basis = Basis::b_spline}, scaled, 64 * time + 8);
            for (std::size_t k = 0; k < count; ++k)
                CHECK(again[k] == doctest::Approx(weights[k]).epsilon(1e-6));
        }
    }
}

namespace {

/// The values of a basis at seven times about a knot: three before it, the knot, three after it.
template <typename WeightsOf>
std::vector<std::vector<double>> values_about(double knot, double step, std::size_t count,
                                              const WeightsOf& weights_of) {
    std::vector<std::vector<double>> values;
    for (int i = -3; i <= 3; ++i) values.push_back(dense(weights_of(knot + i * step), count));
    return values;
}

/// The largest jump of the first and of the second derivative at the inner times, by one-sided finite
/// differences. They are exact for the second derivative of a cubic up to rounding: three points to each side
/// give its value in the middle, and a fourth its slope.
struct Jumps {
    double first = 0;
    double second = 0;
};

template <typename WeightsOf>
Jumps jumps_at_keys(const std::vector<double>& times, const WeightsOf& weights_of) {
    Jumps jumps;
    constexpr double h = 1e-3;
    for (std::size_t place = 1; place + 1 < times.size(); ++place) {
        const auto y = values_about(times[place], h, times.size(), weights_of);
        for (std::size_t k = 0; k < times.size(); ++k) {
            // Third-order one-sided differences, exact for cubics.
            const double left = (11 * y[3][k] - 18 * y[2][k] + 9 * y[1][k] - 2 * y[0][k]) / (6 * h);
            const double right = (-11 * y[3][k] + 18 * y[4][k] - 9 * y[5][k] + 2 * y[6][k]) / (6 * h);
            const double left2 = (2 * y[3][k] - 5 * y[2][k] + 4 * y[1][k] - y[0][k]) / (h * h);
            const double right2 = (2 * y[3][k] - 5 * y[4][k] + 4 * y[5][k] - y[6][k]) / (h * h);
            jumps.first = std::max(jumps.first, std::abs(left - right));
            jumps.second = std::max(jumps.second, std::abs(left2 - right2));
        }
    }
    return jumps;
}

}  // namespace

TEST_CASE("Catmull-Rom is C1, the B-spline and the spline are C2 at the times of keys") {
    for (const std::size_t count : {3U, 4U, 5U, 6U, 9U}) {
        CAPTURE(count);
        std::vector<double> times;
        double time = 0;
        for (std::size_t key = 0; key < count; ++key) {
            times.push_back(time);
            time += 0.3 + 0.7 * static_cast<double>(key * 5 % 7);
        }
        const Jumps catmull_rom =
            jumps_at_keys(times, [&](double t) { return catmull_rom_weights(times, t); });
        CHECK(catmull_rom.first < 1e-9);
        if (count > 3) CHECK(catmull_rom.second > 0.1);  // the differences do notice a jump
        const Jumps b_spline = jumps_at_keys(times, [&](double t) { return b_spline_weights(times, t); });
        CHECK(b_spline.first < 1e-9);
        CHECK(b_spline.second < 1e-6);
        const Jumps spline = jumps_at_keys(times, [&](double t) { return natural_spline_weights(times, t); });
        CHECK(spline.first < 1e-9);
        CHECK(spline.second < 1e-6);
    }
}

TEST_CASE("values on a line stay on it, and the natural spline has no curvature at its ends") {
    std::mt19937 random(7);
    const std::vector<double> times = times_of(random_times(9, random));
    for (double part = 0; part <= 1; part += 1.0 / 50) {
        const double time = times.front() + part * (times.back() - times.front());
        for (const auto& weights : {catmull_rom_weights(times, time), natural_spline_weights(times, time)}) {
            double value = 0;
            for (const Weight& weight : weights) value += weight.value * times[weight.key];
            CHECK(value == doctest::Approx(time).epsilon(1e-9));
        }
    }
    const std::vector<double> even{0, 1, 2, 3, 4};
    const auto y = [&](double t) { return dense(natural_spline_weights(even, t), 5)[1]; };
    constexpr double h = 1e-3;
    CHECK(std::abs(2 * y(0) - 5 * y(h) + 4 * y(2 * h) - y(3 * h)) / (h * h) < 1e-6);
}

TEST_CASE("the spline leaves out only keys whose weights stay below 1e-7") {
    Times keys;
    for (std::size_t key = 0; key < 100; ++key) keys.push_back({static_cast<double>(key), key});
    const std::vector<double> times = times_of(keys);
    for (double time = 0; time <= 99; time += 0.37) {
        const Weights local = weights_at({.basis = Basis::spline}, keys, time);
        CHECK(local.size() < 30);
        const std::vector<double> all = dense(natural_spline_weights(times, time), 100);
        const std::vector<double> some = dense(local, 100);
        for (std::size_t k = 0; k < 100; ++k) CHECK(std::abs(all[k] - some[k]) < 1e-7);
    }
}
