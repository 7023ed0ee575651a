#include "sequence/flow.h"

#include <algorithm>

#include <doctest/doctest.h>
#include <glm/geometric.hpp>

#include "hierarchy/measure.h"
#include "sequence/deformation_flow.h"
#include "sequence/sequences_of_keys.h"

namespace interleaf {
namespace {

const Family& short_flow() {
    static const Family family = make_flow({.steps = 8, .tolerance = 0.001});
    return family;
}

TEST_CASE("every key of the flow is a sphere in topology, and consecutive keys unite") {
    CHECK(short_flow().keys.size() == 9);
    check_sequence(short_flow(), 2);
}

TEST_CASE("the flow's ball is a ball at the beginning and again at the end") {
    check_ball(*short_flow().keys.front().hierarchy);
    check_ball(*short_flow().keys.back().hierarchy);
}

TEST_CASE("the coarsest tolerance that is allowed gives a sound flow, too") {
    check_sequence(make_flow({.steps = 3, .tolerance = 0.05}), 2);
}

TEST_CASE("the flow's leaf counts rise to the middle and fall to the end") {
    const std::vector<std::size_t> counts = leaf_counts(short_flow());
    for (std::size_t i = 1; i <= 4; ++i) CHECK(counts[i] > counts[i - 1]);
    for (std::size_t i = 6; i <= 8; ++i) CHECK(counts[i] < counts[i - 1]);
    CHECK(counts[4] > 3 * counts[0]);
    CHECK(counts[4] > 2 * counts[8]);
}

TEST_CASE("the flow's ball is far from a ball in the middle, where a length has grown tenfold") {
    const Hierarchy& middle = *short_flow().keys[4].hierarchy;
    const glm::vec3 sides = bounding_box(middle.positions).max - bounding_box(middle.positions).min;
    CHECK(std::max({sides.x, sides.y, sides.z}) > 3 * flow_ball_radius);
    REQUIRE(middle.fields.size() == 1);
    CHECK(middle.fields[0].name == "stretch");
    CHECK(*std::max_element(middle.fields[0].values.begin(), middle.fields[0].values.end()) > 10);
    for (const std::size_t end : {0U, 8U})
        for (const float stretch : short_flow().keys[end].hierarchy->fields.at(0).values)
            CHECK(stretch == doctest::Approx(1).epsilon(0.001));
}

TEST_CASE("two runs of the flow give the same bits") {
    const SequenceOptions options{.steps = 4, .tolerance = 0.003};
    check_same_bits(make_flow(options), make_flow(options));
}

TEST_CASE("a smaller tolerance gives more leaves in every key of the flow") {
    const std::vector<std::size_t> coarse = leaf_counts(make_flow({.steps = 4, .tolerance = 0.004}));
    const std::vector<std::size_t> fine = leaf_counts(make_flow({.steps = 4, .tolerance = 0.002}));
    for (std::size_t i = 0; i < coarse.size(); ++i) CHECK(fine[i] > coarse[i]);
}

}  // namespace
}  // namespace interleaf
