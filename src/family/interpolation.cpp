#include "family/interpolation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "family/spline_weights.h"

namespace interleaf {

namespace {

/// Smaller weights of Basis::spline are left out.
constexpr double negligible_weight = 1e-7;

using Times = std::span<const double>;

Weights linear_weights(Times times, double time, std::size_t /*degree*/) {
    const std::size_t place = interval_at(times, time);
    const double s = (time - times[place]) / (times[place + 1] - times[place]);
    return {{place, 1 - s}, {place + 1, s}};
}

Weights hold_weights(Times times, double time, std::size_t /*degree*/) {
    const bool is_end = time == times.back();
    return {{is_end ? times.size() - 1 : interval_at(times, time), 1}};
}

/// The Bernstein polynomials of degree times.size() - 1 over all times, by the recursion of de Casteljau.
Weights bernstein_weights(Times times, double time) {
    const double s = (time - times.front()) / (times.back() - times.front());
    Weights weights{{0, 1}};
    for (std::size_t degree = 1; degree < times.size(); ++degree) {
        weights.push_back({degree, weights.back().value * s});
        for (std::size_t i = degree - 1; i > 0; --i)
            weights[i].value = weights[i].value * (1 - s) + weights[i - 1].value * s;
        weights.front().value *= 1 - s;
    }
    return weights;
}

/// The weights of bernstein_weights() for the piece of \p degree that contains \p time.
Weights piecewise_bernstein_weights(Times times, double time, std::size_t degree) {
    if (degree == 0 || degree >= times.size()) return bernstein_weights(times, time);
    const std::size_t first = interval_at(times, time) / degree * degree;
    Weights weights =
        bernstein_weights(times.subspan(first, std::min(degree + 1, times.size() - first)), time);
    for (Weight& weight : weights) weight.key += first;
    return weights;
}

struct BasisRow {
    Basis basis;
    std::string_view name;

    /// The weights at \p time by place in \p times, of which there are two or more.
    /// \param degree  that of the Interpolation; only Basis::bernstein has one
    Weights (*weights)(Times times, double time, std::size_t degree);
};

constexpr std::array<BasisRow, basis_count> table = {{
    {Basis::linear, "linear", linear_weights},
    {Basis::hold, "hold", hold_weights},
    {Basis::bernstein, "bernstein", piecewise_bernstein_weights},
    {Basis::catmull_rom, "catmull-rom",
     [](Times times, double time, std::size_t) { return catmull_rom_weights(times, time); }},
    {Basis::b_spline, "b-spline",
     [](Times times, double time, std::size_t) { return b_spline_weights(times, time); }},
    {Basis::spline, "spline",
     [](Times times, double time, std::size_t) {
         return local_spline_weights(times, time, negligible_weight);
     }},
}};

constexpr auto offered = [] {
    std::array<Basis, table.size()> all{};
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = table[i].basis;
    return all;
}();

constexpr bool has_order_of_enumeration() {
    for (std::size_t i = 0; i < table.size(); ++i)
        if (table[i].basis != static_cast<Basis>(i) || table[i].weights == nullptr) return false;
    return true;
}
static_assert(has_order_of_enumeration());

const BasisRow& row_of(Basis basis) {
    return table.at(static_cast<std::size_t>(basis));
}

/// Makes the sum of \p weights exactly 1, in whatever order they are added. All values become multiples of one
/// power of two, so sums of them are exact; the largest value takes the remainder.
void make_sum_one(Weights& weights) {
    double bound = 0;
    for (const Weight& weight : weights) bound += std::abs(weight.value);
    int exponent = 0;
    std::frexp(bound, &exponent);
    const double grid = std::ldexp(1, exponent - 52);
    double sum = 0;
    for (Weight& weight : weights) {
        weight.value = std::nearbyint(weight.value / grid) * grid + 0.0;  // no -0
        sum += weight.value;
    }
    std::ranges::max_element(weights, {}, &Weight::value)->value += 1 - sum;
}

}  // namespace

std::span<const Basis> bases() {
    return offered;
}

std::string_view name_of(Basis basis) {
    return row_of(basis).name;
}

std::optional<Basis> basis_named(std::string_view name) {
    const auto* const found = std::ranges::find(table, name, &BasisRow::name);
    return found == table.end() ? std::nullopt : std::optional(found->basis);
}

Weights weights_at(const Interpolation& interpolation, std::span<const TimelineKey> keys, double time) {
    if (keys.size() == 1) return {{keys.front().key, 1}};
    std::vector<double> times;
    times.reserve(keys.size());
    for (const TimelineKey& key : keys) times.push_back(key.time);
    Weights weights = row_of(interpolation.basis).weights(times, time, interpolation.degree);
    for (Weight& weight : weights) weight.key = keys[weight.key].key;
    weights = sorted_weights(std::move(weights));
    make_sum_one(weights);
    return weights;
}

}  // namespace interleaf
