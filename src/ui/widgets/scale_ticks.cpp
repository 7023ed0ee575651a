#include "ui/widgets/scale_ticks.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace interleaf {

std::vector<double> scale_ticks(double min, double max, std::size_t max_count) {
    if (!(max > min) || !std::isfinite(max - min) || max_count == 0) return {};
    constexpr double least_exponent = -307;  // smaller powers lose digits, down to 0
    const double exponent = std::floor(std::log10((max - min) / static_cast<double>(max_count)));
    double power = std::pow(10.0, std::max(exponent, least_exponent));
    while (true) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double step = digit * power;
            const double first = std::ceil(min / step);
            const double last = std::floor(max / step);
            if (last - first + 1 > static_cast<double>(max_count)) continue;
            std::vector<double> ticks;
            // Far from 0, the steps may be finer than the numbers are.
            const auto count = static_cast<std::size_t>(std::max(last - first + 1, 0.0));
            for (std::size_t i = 0; i < count; ++i)
                if (const double tick = (first + static_cast<double>(i)) * step;
                    ticks.empty() || tick > ticks.back())
                    ticks.push_back(tick);
            return ticks;
        }
        power *= 10;
    }
}

std::vector<double> logarithmic_ticks(double min, double max, std::size_t max_count) {
    if (!(max > min) || max_count == 0) return {};
    const auto first = static_cast<int>(std::floor(std::log10(min)));
    const auto last = static_cast<int>(std::ceil(std::log10(max)));
    const auto ticks = [&](std::initializer_list<double> digits, int step) {
        std::vector<double> found;
        for (int power = first; power <= last; ++power)
            for (const double digit : digits) {
                const double tick = digit * std::pow(10.0, power);
                if (power % step == 0 && tick >= min && tick <= max) found.push_back(tick);
            }
        return found;
    };
    if (std::vector<double> found = ticks({1, 2, 5}, 1); found.size() <= max_count) return found;
    for (int step = 1;; ++step)
        if (std::vector<double> found = ticks({1}, step); found.size() <= max_count) return found;
}

}  // namespace interleaf
