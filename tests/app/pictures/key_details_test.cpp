// Tests of the worker that measures the details of keys.
#include "app/pictures/key_details.h"

#include <doctest/doctest.h>

#include "shapes/shapes.h"

using namespace interleaf;

namespace {

SharedHierarchy measurable_key(const char* shape, unsigned leaves) {
    return make_key(*find_shape(shape), {.leaves = leaves, .tolerance = {}});
}

}  // namespace

TEST_CASE("wanted keys are measured, others that are measured stay while there is room") {
    const SharedHierarchy star = measurable_key("star", 900), sphere = measurable_key("sphere", 900);
    KeyDetails details;
    CHECK(details.find(star) == nullptr);
    CHECK_FALSE(details.progress());
    details.want({star, sphere});
    details.wait();
    CHECK_FALSE(details.progress());
    const KeyDetails::Measured measured = details.find(star);
    REQUIRE(measured != nullptr);
    CHECK(measured->bisections.size() == star->midpoints.size());
    CHECK(details.find(sphere) != nullptr);
    details.want({sphere});
    details.wait();
    CHECK(details.find(star) == measured);

    KeyDetails small(1);
    small.want({star});
    small.wait();
    CHECK(small.find(star) != nullptr);
    small.want({sphere});
    small.wait();
    CHECK(small.find(star) == nullptr);
    CHECK(small.find(sphere) != nullptr);
}

TEST_CASE("a key that is no longer wanted is not measured to its end") {
    const SharedHierarchy large = measurable_key("star", 60000), small = measurable_key("sphere", 900);
    KeyDetails details;
    details.want({large});
    CHECK(details.progress().value_or(1) <= 1);
    details.want({small});
    details.wait();
    CHECK(details.find(small) != nullptr);
}
