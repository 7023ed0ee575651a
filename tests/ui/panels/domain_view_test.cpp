// Tests of the visible part of a domain: zoom and pan.
#include "ui/panels/domain_view.h"

#include <cmath>
#include <random>

#include "trials.h"
#include <doctest/doctest.h>
#include <glm/geometric.hpp>

using namespace interleaf;

namespace {

constexpr DomainBox whole_domain{{-1, 2}, {3, 4}};

double width_of(const DomainBox& box) {
    return box.high.x - box.low.x;
}

}  // namespace

TEST_CASE("zooming keeps the place under the pointer, the shape of the part, and stays within the domain") {
    for (unsigned seed = 0; seed < trials(50); ++seed) {
        CAPTURE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> part(0, 1);
        DomainBox visible = whole_domain;
        for (int turn = 0; turn < 30; ++turn) {
            const glm::dvec2 fixed =
                visible.low + glm::dvec2(part(random), part(random)) * (visible.high - visible.low);
            const double factor = turn < 10 ? 0.8 : std::exp2(2 * part(random) - 1);
            const DomainBox before = visible;
            visible = zoomed(visible, whole_domain, fixed, factor);
            CHECK(visible.low.x >= whole_domain.low.x - 1e-12);
            CHECK(visible.high.y <= whole_domain.high.y + 1e-12);
            CHECK(width_of(visible) / (visible.high.y - visible.low.y) == doctest::Approx(2));
            if (factor > 1) continue;
            const glm::dvec2 old_place = (fixed - before.low) / (before.high - before.low);
            const glm::dvec2 place = (fixed - visible.low) / (visible.high - visible.low);
            CHECK(glm::distance(old_place, place) < 1e-6);
        }
    }
}

TEST_CASE("zooming out ends at the whole domain, and zooming in at a small part") {
    const DomainBox small = zoomed(whole_domain, whole_domain, {0, 3}, 1e-9);
    CHECK(width_of(small) == doctest::Approx(4e-4));
    const DomainBox out = zoomed(small, whole_domain, {0, 3}, 1e9);
    CHECK(out.low == whole_domain.low);
    CHECK(out.high == whole_domain.high);
}

TEST_CASE("panning ends at the border of the domain") {
    const DomainBox part{{0, 2.5}, {1, 3}};
    const DomainBox moved = panned(part, whole_domain, {100, -100});
    CHECK(moved.low == glm::dvec2(2, 2));
    CHECK(moved.high == glm::dvec2(3, 2.5));
}

TEST_CASE("a part of an earlier domain is moved into the present one, and one of no size shows all") {
    const DomainBox moved = shown_part(whole_domain, DomainBox{{10, 10}, {11, 10.5}});
    CHECK(moved.high == whole_domain.high);
    CHECK(width_of(moved) == doctest::Approx(1));
    const DomainBox all = shown_part(whole_domain, DomainBox{{0, 3}, {0, 3}});
    CHECK(all.low == whole_domain.low);
    CHECK(all.high == whole_domain.high);
}
