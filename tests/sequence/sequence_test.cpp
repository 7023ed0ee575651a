#include "sequence/sequence.h"

#include <vector>

#include "numbers.h"
#include <doctest/doctest.h>

#include "hierarchy/error.h"
#include "sequence/catenoid.h"
#include "sequence/flow.h"
#include "text/natural_order.h"

namespace interleaf {
namespace {

TEST_CASE("options out of range are usage errors") {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    for (const SequenceOptions& options :
         {SequenceOptions{.steps = 0}, SequenceOptions{.steps = 1001}, SequenceOptions{.tolerance = 0},
          SequenceOptions{.tolerance = 0.06}, SequenceOptions{.tolerance = nan}}) {
        CHECK_THROWS_AS(make_flow(options), UsageError);
        CHECK_THROWS_AS(make_catenoid({.steps = options}), UsageError);
    }
    for (const double distance : {0.0, 0.1, 3.1, nan, infinity})
        CHECK_THROWS_AS(make_catenoid({.steps = {}, .distance = distance}), UsageError);
}

TEST_CASE("N steps give N + 1 keys in equal times, with names in natural order") {
    const Family flow = make_flow({.steps = 12, .tolerance = 0.05});
    REQUIRE(flow.keys.size() == 13);
    REQUIRE(flow.timeline.has_value());
    REQUIRE(flow.timeline->keys().size() == 13);
    CHECK(flow.keys[3].name == "step 03");
    for (std::size_t i = 0; i < 13; ++i) {
        CHECK(flow.timeline->keys()[i].key == i);
        CHECK(flow.timeline->keys()[i].time == doctest::Approx(flow_duration * static_cast<double>(i) / 12));
        if (i > 0) CHECK(NaturalName(flow.keys[i - 1].name) < NaturalName(flow.keys[i].name));
    }
    CHECK(make_flow({.steps = 100, .tolerance = 0.05}).keys[7].name == "step 007");
}

TEST_CASE("progress rises to 1, and what it throws ends the work") {
    const SequenceOptions options{.steps = 3, .tolerance = 0.02};
    std::vector<double> parts;
    const SequenceProgress note = [&](double part) { parts.push_back(part); };
    make_flow(options, note);
    CHECK(parts.size() == 3);
    CHECK(parts.back() == 1);
    parts.clear();
    make_catenoid({.steps = options}, note);
    for (std::size_t i = 1; i < parts.size(); ++i) CHECK(parts[i] >= parts[i - 1]);
    CHECK(parts.back() == 1);

    struct Stop {};
    const SequenceProgress stop = [](double) { throw Stop(); };
    CHECK_THROWS_AS(make_flow(options, stop), Stop);
    CHECK_THROWS_AS(make_catenoid({.steps = options}, stop), Stop);
}

}  // namespace
}  // namespace interleaf
