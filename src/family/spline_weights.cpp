#include "family/spline_weights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace interleaf {

namespace {

constexpr std::size_t cubic = 3;

/// A time in its interval.
struct Location {
    std::size_t place;  ///< where the interval begins
    double length;      ///< of the interval
    double after;       ///< part of the interval after the time, 0 to 1
    double before;      ///< part before it
};

Location locate_time(std::span<const double> times, double time) {
    const std::size_t place = interval_at(times, time);
    const double length = times[place + 1] - times[place];
    return {place, length, (times[place + 1] - time) / length, (time - times[place]) / length};
}

/// The knots of the clamped B-spline of \p degree.
std::vector<double> clamped_knots(std::span<const double> times, std::size_t degree) {
    std::vector<double> knots(degree + 1, times.front());
    if (degree == cubic) knots.insert(knots.end(), times.begin() + 2, times.end() - 2);
    knots.insert(knots.end(), degree + 1, times.back());
    return knots;
}

/// The second derivatives of the natural spline are linear in its values. This row holds, per place, what the
/// value there contributes to the second derivative at \p at.
///
/// The second derivatives M solve T M = R y, with y the values. T is symmetric, so row \p at of T^-1 R is
/// R^T z with T z = e_at.
std::vector<double> second_derivative_row(std::span<const double> times, std::size_t at) {
    const std::size_t count = times.size();
    std::vector<double> row(count, 0);
    if (at == 0 || at + 1 >= count) return row;  // 0 at the ends
    const auto step = [&](std::size_t i) { return times[i + 1] - times[i]; };

    // Gaussian elimination of the tridiagonal system; its rows 1 to count - 2 are those of the inner places.
    std::vector<double> z(count, 0);
    std::vector<double> upper(count, 0);
    z[at] = 1;
    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double lower = i > 1 ? step(i - 1) / 6 : 0;
        const double pivot = (step(i - 1) + step(i)) / 3 - lower * upper[i - 1];
        upper[i] = step(i) / 6 / pivot;
        z[i] = (z[i] - lower * z[i - 1]) / pivot;
    }
    z[count - 1] = 0;
    for (std::size_t i = count - 2; i > 0; --i) z[i] -= upper[i] * z[i + 1];

    for (std::size_t i = 1; i + 1 < count; ++i) {
        const double left = z[i] / step(i - 1);
        const double right = z[i] / step(i);
        row[i - 1] += left;
        row[i] -= left + right;
        row[i + 1] += right;
    }
    return row;
}

}  // namespace

std::size_t interval_at(std::span<const double> times, double time) {
    const auto after = std::upper_bound(times.begin() + 1, times.end() - 1, time);
    return static_cast<std::size_t>(after - times.begin()) - 1;
}

Weights catmull_rom_weights(std::span<const double> times, double time) {
    const auto [place, length, after, before] = locate_time(times, time);
    Weights weights;
    const auto add = [&](std::size_t at, double value) { weights.push_back({at, value}); };
    // The four cubic Hermite polynomials; those of the tangents are multiplied by the length.
    const double at_left = after * after * (1 + 2 * before);
    const double at_right = before * before * (1 + 2 * after);
    const auto add_tangent = [&](std::size_t at, double factor) {
        const auto add_slope = [&](std::size_t from, double part) {
            const double value = factor * part / (times[from + 1] - times[from]);
            add(from, -value);
            add(from + 1, value);
        };
        if (at == 0) return add_slope(0, 1);
        if (at + 1 == times.size()) return add_slope(at - 1, 1);
        const double both = times[at + 1] - times[at - 1];
        add_slope(at - 1, (times[at + 1] - times[at]) / both);
        add_slope(at, (times[at] - times[at - 1]) / both);
    };
    add(place, at_left);
    add(place + 1, at_right);
    add_tangent(place, length * before * after * after);
    add_tangent(place + 1, -length * before * before * after);
    return sorted_weights(std::move(weights));
}

Weights b_spline_weights(std::span<const double> times, double time) {
    const std::size_t degree = std::min(cubic, times.size() - 1);
    const std::vector<double> knots = clamped_knots(times, degree);
    // The knots from `first` on are strictly ascending up to the repeated last one.
    const auto inner = std::span(knots).subspan(degree, knots.size() - 2 * degree);
    const std::size_t first = interval_at(inner, time);
    const std::size_t span = first + degree;

    // The recursion of Cox and de Boor, from degree 0 up; each value is used twice, so sums stay 1.
    std::array<double, cubic + 1> values{1};
    for (std::size_t d = 1; d <= degree; ++d) {
        double carried = 0;
        for (std::size_t r = 0; r < d; ++r) {
            const double right = knots[span + r + 1] - time;
            const double left = time - knots[span + 1 + r - d];
            const double part = values[r] / (right + left);
            values[r] = carried + right * part;
            carried = left * part;
        }
        values[d] = carried;
    }
    Weights weights;
    for (std::size_t r = 0; r <= degree; ++r) weights.push_back({first + r, values[r]});
    return weights;
}

Weights natural_spline_weights(std::span<const double> times, double time) {
    return local_spline_weights(times, time, 0);
}

Weights local_spline_weights(std::span<const double> times, double time, double threshold) {
    const auto [place, length, after, before] = locate_time(times, time);
    const std::vector<double> left = second_derivative_row(times, place);
    const std::vector<double> right = second_derivative_row(times, place + 1);
    const double square = length * length;
    const double left_factor = square / 6 * after * (after * after - 1);
    const double right_factor = square / 6 * before * (before * before - 1);
    // |s^3 - s| / 6 is at most 1 / (9 sqrt(3)) for s from 0 to 1.
    const double largest_factor = square / (9 * std::sqrt(3.0));

    Weights weights;
    double sum = 0;
    for (std::size_t at = 0; at < times.size(); ++at) {
        const bool is_end = at == place || at == place + 1;
        if (!is_end && largest_factor * (std::abs(left[at]) + std::abs(right[at])) < threshold) continue;
        double value = left_factor * left[at] + right_factor * right[at];
        if (at == place) value += after;
        if (at == place + 1) value += before;
        weights.push_back({at, value});
        sum += value;
    }
    for (Weight& weight : weights) weight.value /= sum;
    return weights;
}

}  // namespace interleaf
