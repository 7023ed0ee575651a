#include "ui/widgets/scale_ticks.h"

#include <cmath>

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

}  // namespace interleaf
