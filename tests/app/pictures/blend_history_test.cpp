// Area, volume and leaves of the blend over time are measured on a thread, and not anew for edits without effect.
#include "app/pictures/blend_history.h"

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include "app/pictures/measured_curves.h"
#include "family/key_edits.h"
#include "hierarchy/adaptive_mesh.h"
#include "hierarchy/marking.h"
#include "hierarchy/random_families.h"

using namespace interleaf;

namespace {

/// An octahedron with vertices at the distance \p size, refined \p rounds times.
Hierarchy octahedron_of(float size, int rounds) {
    std::vector<glm::vec3> positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
    for (glm::vec3& position : positions) position *= size;
    AdaptiveMesh mesh(mark_compatibly(testing::octahedron()), positions);
    for (int round = 0; round < rounds; ++round) mesh.refine(mesh.preorder());
    return mesh.freeze();
}

/// From the size 1 to the size 2 in a second, linearly, and back in the next one.
std::shared_ptr<const Family> pulse() {
    Family family{.name = "pulse",
                  .keys = {{"small", octahedron_of(1, 0)}, {"large", octahedron_of(2, 1)}},
                  .timeline = Timeline({{0, 0}, {1, 1}, {2, 0}}),
                  .domain = {}};
    return std::make_shared<const Family>(std::move(family));
}

}  // namespace

TEST_CASE("the figures of the blend follow its size, at ascending times that include the keys") {
    BlendHistory history;
    CHECK_FALSE(history.is_working());
    history.follow(pulse());
    const BlendCurves curves = testing::measured(history);
    CHECK(curves.size() > 100);
    CHECK(std::ranges::is_sorted(curves, {}, &BlendSample::time));
    for (const double time : {0.0, 1.0, 2.0})
        CHECK(std::ranges::count(curves, time, &BlendSample::time) == 1);
    for (const BlendSample& sample : curves) {
        const double size = 2 - std::abs(sample.time - 1);
        CHECK(sample.area == doctest::Approx(4 * std::sqrt(3.0) * size * size));
        CHECK(sample.volume == doctest::Approx(4.0 / 3 * size * size * size));
        // At a key alone, the key may be the only active one.
        CHECK((sample.leaves == 16 || std::abs(sample.time - std::round(sample.time)) < 1e-9));
    }
}

TEST_CASE("an edit without effect on the blend measures nothing anew, others do") {
    const auto family = pulse();
    BlendHistory history;
    history.follow(family);
    CHECK(testing::measured(history).size() > 100);
    history.follow(std::make_shared<const Family>(with_key_renamed(*family, 0, "tiny")));
    CHECK_FALSE(history.is_working());
    CHECK(history.curves().size() > 100);
    history.follow(std::make_shared<const Family>(with_time_moved(*family, 2, 3)));
    CHECK(history.is_working());
    CHECK(testing::measured(history).back().time == 3);
    history.follow(nullptr);
    CHECK(history.curves().empty());

    CHECK(have_same_blends(*family, *family));
    CHECK_FALSE(have_same_blends(*family, *pulse()));  // equal, but other hierarchies in memory
    Family other = *family;
    other.timeline = other.timeline->with_interpolation({Basis::hold, 1});
    CHECK_FALSE(have_same_blends(*family, other));
    other = *family;
    other.blend = BlendKind::turning;
    CHECK_FALSE(have_same_blends(*family, other));
}
