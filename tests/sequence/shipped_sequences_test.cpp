// Tests of the shipped sequences. tests/cli/make_test.cpp compares them with the output of `interleaf make`.
#include <filesystem>

#include <doctest/doctest.h>

#include "io/family/family_file.h"
#include "sequence/flow.h"
#include "sequence/sequences_of_keys.h"

namespace interleaf {
namespace {

const std::filesystem::path families = INTERLEAF_FAMILIES;

TEST_CASE("the shipped flow is sound, and ends as the ball that it begins as") {
    const Family family = read_family(families / "flow");
    CHECK(family.keys.size() == 31);
    check_sequence(family, 2);
    check_ball(*family.keys.front().hierarchy);
    check_ball(*family.keys.back().hierarchy);
    REQUIRE(family.timeline.has_value());
    CHECK(family.timeline->end() == flow_duration);
    for (const Key& key : family.keys) CHECK(key.hierarchy->fields.at(0).name == "stretch");
    const std::vector<std::size_t> counts = leaf_counts(family);
    CHECK(counts[15] > 3 * counts.front());
    CHECK(counts[15] > 2 * counts.back());
}

TEST_CASE("the shipped catenoid is sound, and has the neck of the exact one") {
    const Family family = read_family(families / "catenoid");
    CHECK(family.keys.size() == 31);
    check_sequence(family, 0);
    for (const Key& key : family.keys) CHECK(key.hierarchy->fields.at(0).name == "mean curvature");
    CHECK(neck_radius(*family.keys.back().hierarchy) == doctest::Approx(exact_neck(1)).epsilon(0.002));
}

TEST_CASE("both shipped sequences together take less than 2 MB") {
    std::uintmax_t bytes = 0;
    for (const char* name : {"flow", "catenoid"})
        for (const auto& entry : std::filesystem::directory_iterator(families / name))
            bytes += entry.file_size();
    CHECK(bytes < 2'000'000);
}

}  // namespace
}  // namespace interleaf
