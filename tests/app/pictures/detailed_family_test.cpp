// Tests of the active keys at a level of detail: weights are kept, levels are reused, and the leaves grow with
// the detail.
#include "app/pictures/detailed_family.h"

#include <cmath>

#include <doctest/doctest.h>

#include "hierarchy/checker.h"
#include "shapes/shapes.h"

using namespace interleaf;

namespace {

Family three_shapes() {
    Family family;
    family.name = "shapes";
    for (const char* const name : {"star", "sphere", "icosahedron"})
        family.keys.push_back(
            {name, make_key(*find_shape(name),
                            {.leaves = name == std::string("icosahedron") ? 20U : 900U, .tolerance = {}})});
    return family;
}

/// Details of all keys of \p family.
class AllDetails {
  public:
    explicit AllDetails(const Family& family) {
        KeyDetails::Keys keys;
        for (const Key& key : family.keys) keys.push_back(key.hierarchy);
        details_.want(keys);
        details_.wait();
    }
    operator KeyDetails&() { return details_; }

  private:
    KeyDetails details_;
};

double weight_of(const DetailedFamily& detailed, std::size_t source) {
    double sum = 0;
    for (const Weight& weight : detailed.weights())
        if (detailed.sources()[weight.key] == source) sum += weight.value;
    return sum;
}

}  // namespace

TEST_CASE("at full detail the family itself is shown") {
    const Family family = three_shapes();
    AllDetails details(family);
    DetailedFamily detailed;
    const Weights weights{{0, 0.25}, {2, 0.75}};
    detailed.follow(family, weights, 1, details);
    CHECK(&detailed.family() == &family);
    CHECK(detailed.weights() == weights);
    CHECK(detailed.sources().empty());
}

TEST_CASE("until all active keys are measured the family itself is shown") {
    const Family family = three_shapes();
    KeyDetails details;
    DetailedFamily detailed;
    const Weights weights{{0, 0.25}, {2, 0.75}};
    detailed.follow(family, weights, 0.5F, details);
    CHECK(&detailed.family() == &family);
    details.want({family.keys[0].hierarchy, family.keys[2].hierarchy});
    details.wait();
    detailed.follow(family, weights, 0.5F, details);
    CHECK(&detailed.family() != &family);
    CHECK(detailed.sources().size() == detailed.family().keys.size());
}

TEST_CASE(
    "at any detail each active key has its weight in at most two sound levels, which grow with detail") {
    const Family family = three_shapes();
    AllDetails details(family);
    DetailedFamily detailed;
    const Weights weights{{0, 0.25}, {1, 0.85}, {2, -0.1}};
    std::size_t last = 0;
    for (float detail = 0; detail <= 1; detail += 1.0F / 64) {
        CAPTURE(detail);
        detailed.follow(family, weights, detail, details);
        if (detail == 1) break;
        CHECK(detailed.family().keys.size() <= 6);
        for (const Weight& weight : weights)
            CHECK(weight_of(detailed, weight.key) == doctest::Approx(weight.value));
        for (const Key& key : detailed.family().keys) CHECK(check(*key.hierarchy).empty());
        const std::size_t leaves = unite(detailed.family(), detailed.weights()).leaf_count();
        CHECK(leaves >= last);
        last = leaves;
    }
    CHECK(last > 900);
}

TEST_CASE("between two levels only weights change, so that the union stays") {
    const Family family = three_shapes();
    AllDetails details(family);
    DetailedFamily detailed;
    const Weights weights{{0, 0.5}, {1, 0.5}};
    std::size_t changes = 0;
    std::vector<SharedHierarchy> before;
    for (int step = 0; step < 1000; ++step) {
        detailed.follow(family, weights, static_cast<float>(step) / 1000, details);
        std::vector<SharedHierarchy> now;
        for (const Key& key : detailed.family().keys) now.push_back(key.hierarchy);
        bool is_same = now.size() == before.size();
        for (std::size_t i = 0; is_same && i < now.size(); ++i) is_same = now[i].is_same(before[i]);
        if (!is_same) ++changes;
        before = std::move(now);
    }
    CHECK(changes > 4);
    CHECK(changes < 20);
}
