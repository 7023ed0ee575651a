#include "ui/widgets/scale_ticks.h"

#include <cmath>

#include <doctest/doctest.h>

using namespace interleaf;

TEST_CASE("ticks of a logarithmic scale are powers of ten, or also 2 and 5 times these") {
    CHECK(logarithmic_ticks(0.5, 30, 6) == std::vector<double>{0.5, 1, 2, 5, 10, 20});
    CHECK(logarithmic_ticks(0.5, 3000, 5) == std::vector<double>{1, 10, 100, 1000});
    CHECK(logarithmic_ticks(1e-8, 1e8, 5).size() <= 5);
    CHECK(logarithmic_ticks(3, 4, 5).empty());
    CHECK(logarithmic_ticks(2, 2, 5).empty());
}

TEST_CASE("ticks are the multiples of a round number") {
    CHECK(scale_ticks(-1, 1, 5) == std::vector<double>{-1, -0.5, 0, 0.5, 1});
    CHECK(scale_ticks(0, 10, 6) == std::vector<double>{0, 2, 4, 6, 8, 10});
    CHECK(scale_ticks(0, 10, 5) == std::vector<double>{0, 5, 10});
    CHECK(scale_ticks(31, 39, 4) == std::vector<double>{32, 34, 36, 38});
    CHECK(scale_ticks(1, 1, 5).empty());
    CHECK(scale_ticks(2, 1, 5).empty());
    CHECK(scale_ticks(0, 1, 0).empty());
}

TEST_CASE("ticks are few where numbers are coarser than their steps, or hardly finite") {
    CHECK(scale_ticks(1e17, 1e17 + 16, 5).size() <= 5);
    CHECK(scale_ticks(-1e17 - 64, -1e17, 4).size() <= 4);
    CHECK(scale_ticks(0, 5e-324, 5).size() <= 5);
    CHECK(scale_ticks(-1e308, 1e308, 5).empty());
}

TEST_CASE("ticks lie within the range, ascend, and do not exceed the given number, at any scale") {
    for (int exponent = -38; exponent <= 38; ++exponent)
        for (const double begin : {-2.0, -0.3, 0.0, 0.7, 1000.0})
            for (std::size_t most = 1; most < 8; ++most) {
                CAPTURE(exponent);
                CAPTURE(begin);
                const double min = begin * std::pow(10.0, exponent);
                const double max = (begin + 1.37) * std::pow(10.0, exponent);
                const std::vector<double> ticks = scale_ticks(min, max, most);
                CHECK(ticks.size() <= most);
                if (most >= 5) CHECK(ticks.size() >= 2);
                double before = min - 1e-9 * (max - min);
                for (const double tick : ticks) {
                    CHECK(tick >= before);
                    before = tick;
                }
                CHECK(before <= max + 1e-9 * (max - min));
            }
}
