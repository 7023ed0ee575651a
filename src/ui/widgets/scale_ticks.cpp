#include "ui/widgets/scale_ticks.h"

#include <cmath>
#include <initializer_list>

namespace interleaf {

std::vector<double> scale_ticks(double min, double max, std::size_t max_count) {
    if (!(max > min) || max_count == 0) return {};
    double power = std::pow(10.0, std::floor(std::log10((max - min) / static_cast<double>(max_count))));
    while (true) {
        for (const double digit : {1.0, 2.0, 5.0}) {
            const double step = digit * power;
            const double first = std::ceil(min / step);
            const double last = std::floor(max / step);
            if (last - first + 1 > static_cast<double>(max_count)) continue;
            std::vector<double> ticks;
            for (double n = first; n <= last; ++n) ticks.push_back(n * step);
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
