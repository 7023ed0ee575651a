// Tests of the edits of keys and times: references to keys stay valid, and invalid edits are rejected.
#include "family/key_edits.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "numbers.h"
#include "thrown_errors.h"
#include <doctest/doctest.h>
#include <fmt/core.h>

#include "family/domain_edits.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using interleaf::testing::Random;

namespace {

Hierarchy surface(float height) {
    return unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, height}, {1, 0, height}, {0, 1, height}});
}

Hierarchy other_surface() {
    return unrefined(RootComplex(3, {{1, 2, 0}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
}

/// Keys a, b, c, d: a and c twice on the timeline, b in the middle of the domain's square, d in neither.
Family sample() {
    Family family{.name = "sample", .keys = {}, .timeline = {}, .domain = {}};
    for (const char* name : {"a", "b", "c", "d"}) family.keys.push_back({name, surface(0)});
    family.timeline.emplace(std::vector<TimelineKey>{{0, 0}, {1, 2}, {2, 1}, {3, 0}, {4, 2}});
    family.domain.emplace(
        std::vector<DomainVertex>{{{0, 0}, 0}, {{2, 0}, 0}, {{2, 2}, 2}, {{0, 2}, 2}, {{1, 1}, 1}},
        std::vector<Triangle>{{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    return family;
}

std::vector<std::string> names(const Family& family) {
    std::vector<std::string> found;
    for (const Key& key : family.keys) found.push_back(key.name);
    return found;
}

using NamedTime = std::pair<double, const Hierarchy*>;
using NamedVertex = std::tuple<double, double, const Hierarchy*>;

/// The keys on the timeline, identified by their hierarchy in memory; copies of a family share hierarchies.
std::vector<NamedTime> named_times(const Family& family) {
    std::vector<NamedTime> named;
    if (!family.timeline) return named;
    for (const auto& [time, key] : family.timeline->keys())
        named.emplace_back(time, &*family.keys.at(key).hierarchy);
    return named;
}

std::vector<NamedVertex> named_vertices(const Family& family) {
    std::vector<NamedVertex> named;
    if (!family.domain) return named;
    for (const auto& [at, key] : family.domain->vertices())
        named.emplace_back(at.x, at.y, &*family.keys.at(key).hierarchy);
    return named;
}

std::vector<const Hierarchy*> hierarchies(const Family& family) {
    std::vector<const Hierarchy*> found;
    for (const Key& key : family.keys) found.push_back(&*key.hierarchy);
    return found;
}

}  // namespace

TEST_CASE("a copy of a family shares its hierarchies; an equal hierarchy is not the same one") {
    const Family family = sample();
    const Family copy = family;
    for (std::size_t key = 0; key < family.keys.size(); ++key) {
        CHECK(copy.keys[key].hierarchy.is_same(family.keys[key].hierarchy));
        CHECK_FALSE(copy.keys[key].hierarchy.is_same(SharedHierarchy(surface(0))));
    }
    CHECK_FALSE(family.keys[0].hierarchy.is_same(family.keys[1].hierarchy));
}

TEST_CASE("an unused name is the wanted one, or that name with the first free number from 2 on") {
    Family family = sample();
    CHECK(unused_name(family, "e") == "e");
    CHECK(unused_name(family, "a") == "a 2");
    family.keys[1].name = "a 2";
    CHECK(unused_name(family, "a") == "a 3");
    CHECK(unused_name(family, "a 2") == "a 2 2");
    CHECK(unused_name(family, "") == "key");
    family.keys[2].name = "key";
    CHECK(unused_name(family, "") == "key 2");
}

TEST_CASE("a name from outside becomes one that every family may have") {
    const Family family = with_key_added(sample(), {"a\u009b2J\n\xff", surface(1)});
    CHECK(family.keys.back().name == "a\\xc2\\x9b2J\\x0a\\xff");
    CHECK(check(family).empty());
    CHECK(with_key_added(family, {"a\u009b2J\n\xff", surface(1)}).keys.back().name ==
          family.keys.back().name + " 2");
    CHECK(with_family_renamed(sample(), "other").name == "other");
    CHECK(input_error_of([] { with_family_renamed(sample(), ""); }) == "a family needs a name");
}

TEST_CASE("a key is added last, under a name of its own, and nothing else changes") {
    const Family before = sample();
    const SharedHierarchy added = surface(1);
    const Family after = with_key_added(before, {"b", added});
    CHECK(names(after) == std::vector<std::string>{"a", "b", "c", "d", "b 2"});
    CHECK(after.keys.back().hierarchy.is_same(added));
    CHECK(after.timeline == before.timeline);
    CHECK(after.domain == before.domain);
    CHECK(names(with_key_added(before, {"", added})).back() == "key");
}

TEST_CASE("a key with other roots is refused, naming both keys") {
    const std::string fault = input_error_of([] { with_key_added(sample(), {"turned", other_surface()}); });
    CHECK(fault.find("\"turned\"") != std::string::npos);
    CHECK(fault.find("\"a\"") != std::string::npos);
    CHECK(fault.find("root") != std::string::npos);
}

TEST_CASE("a duplicate follows its key, with the same hierarchy, on no timeline and in no domain") {
    for (std::size_t key = 0; key < 4; ++key) {
        const Family before = sample();
        const Family after = with_key_duplicated(before, key);
        REQUIRE(after.keys.size() == 5);
        CHECK(after.keys[key + 1].hierarchy.is_same(before.keys[key].hierarchy));
        CHECK(after.keys[key + 1].name == before.keys[key].name + " 2");
        CHECK(after.keys[key].name == before.keys[key].name);
        for (const auto& [time, named] : after.timeline->keys()) CHECK(named != key + 1);
        for (const auto& [at, named] : after.domain->vertices()) CHECK(named != key + 1);
        CHECK(named_times(after) == named_times(before));
        CHECK(named_vertices(after) == named_vertices(before));
        CHECK(check(after).empty());
    }
}

TEST_CASE("removing a key removes its times and domain vertices, and no others") {
    const Family before = sample();
    const Family after = with_key_removed(before, 0);
    CHECK(names(after) == std::vector<std::string>{"b", "c", "d"});
    CHECK(after.timeline->keys().size() == 3);
    CHECK(named_times(after) == std::vector<NamedTime>{{1, &*before.keys[2].hierarchy},
                                                       {2, &*before.keys[1].hierarchy},
                                                       {4, &*before.keys[2].hierarchy}});
    REQUIRE(after.domain);
    CHECK(named_vertices(after) == std::vector<NamedVertex>{{2, 2, &*before.keys[2].hierarchy},
                                                            {0, 2, &*before.keys[2].hierarchy},
                                                            {1, 1, &*before.keys[1].hierarchy}});
    CHECK(check(after).empty());
    CHECK(named_times(with_key_removed(before, 3)) == named_times(before));
    CHECK(named_vertices(with_key_removed(before, 3)) == named_vertices(before));
}

TEST_CASE("timeline and domain are removed with their last key, and the last key of the family stays") {
    Family family = with_key_removed(with_key_removed(sample(), 0), 1);
    CHECK(names(family) == std::vector<std::string>{"b", "d"});
    CHECK(family.timeline);
    CHECK_FALSE(family.domain);
    family = with_key_removed(family, 0);
    CHECK(names(family) == std::vector<std::string>{"d"});
    CHECK_FALSE(family.timeline);
    CHECK(input_error_of([&] { with_key_removed(family, 0); }).find("at least one key") != std::string::npos);
}

TEST_CASE("a key may get any name that is not empty, not taken, and without control characters") {
    CHECK(names(with_key_renamed(sample(), 1, "B, \"b\" \xc3\xbc")) ==
          std::vector<std::string>{"a", "B, \"b\" \xc3\xbc", "c", "d"});
    CHECK(names(with_key_renamed(sample(), 1, "b")) == names(sample()));
    CHECK(input_error_of([] { with_key_renamed(sample(), 1, ""); }) == "a key needs a name");
    CHECK(input_error_of([] { with_key_renamed(sample(), 1, "c"); }).find("\"c\"") != std::string::npos);
    for (const char* const name : {"x\n", "\t", "\x7f", "a\x1b[0m", "a\u009b0m", "\xff", "cut \xc3"}) {
        CAPTURE(name);
        CHECK_FALSE(input_error_of([&] { with_key_renamed(sample(), 1, name); }).empty());
        CHECK_FALSE(input_error_of([&] { with_family_renamed(sample(), name); }).empty());
        Family forced = sample();
        forced.keys[1].name = name;
        CHECK(check(forced).size() == 1);
        forced = sample();
        forced.name = name;
        CHECK(check(forced).size() == 1);
    }
    CHECK_FALSE(input_error_of([] { with_key_renamed(sample(), 1, std::string("x\0y", 3)); }).empty());
}

TEST_CASE("a moved key is at its new place, the others keep their order, and all references stay valid") {
    const Family before = sample();
    for (std::size_t from = 0; from < 4; ++from) {
        for (std::size_t to = 0; to < 4; ++to) {
            CAPTURE(from);
            CAPTURE(to);
            const Family after = with_key_moved(before, from, to);
            std::vector<const Hierarchy*> expected = hierarchies(before);
            const Hierarchy* const moved = expected[from];
            std::erase(expected, moved);
            expected.insert(expected.begin() + static_cast<std::ptrdiff_t>(to), moved);
            CHECK(hierarchies(after) == expected);
            CHECK(named_times(after) == named_times(before));
            CHECK(named_vertices(after) == named_vertices(before));
            CHECK(after.domain->triangles().size() == before.domain->triangles().size());
        }
    }
}

TEST_CASE("a time is added in its order, and creates the timeline if there is none") {
    const Family after = with_time_added(sample(), 3, 1.5);
    CHECK(after.timeline == Timeline({{0, 0}, {1, 2}, {1.5, 3}, {2, 1}, {3, 0}, {4, 2}}));
    Family none = sample();
    none.timeline.reset();
    CHECK(with_time_added(none, 3, -7).timeline == Timeline({{-7, 3}}));
}

TEST_CASE("a time may be moved past others, and back") {
    const Family after = with_time_moved(sample(), 0, 2.5);
    CHECK(after.timeline == Timeline({{1, 2}, {2, 1}, {2.5, 0}, {3, 0}, {4, 2}}));
    CHECK(with_time_moved(after, 2, 0).timeline == sample().timeline);
    CHECK(with_time_moved(sample(), 1, 1).timeline == sample().timeline);
}

TEST_CASE("a time that is taken, not finite, or too far off is refused") {
    CHECK(input_error_of([] { with_time_added(sample(), 3, 2); }).find("\"b\"") != std::string::npos);
    CHECK(input_error_of([] { with_time_moved(sample(), 0, 2); }).find("\"b\"") != std::string::npos);
    CHECK_FALSE(input_error_of([] { with_time_added(sample(), 3, -0.0); }).empty());
    for (const double time : {std::nan(""), infinity, -infinity}) {
        for (std::size_t place = 0; place < 5; ++place)
            CHECK(input_error_of([&] { with_time_moved(sample(), place, time); }).find("finite") !=
                  std::string::npos);
        CHECK(input_error_of([&] { with_time_added(sample(), 0, time); }).find("finite") !=
              std::string::npos);
    }
    const double most = std::numeric_limits<double>::max();
    CHECK_FALSE(
        input_error_of([&] { with_time_added(with_time_added(sample(), 3, most), 3, -most); }).empty());
}

TEST_CASE("the timeline is removed with its last time") {
    Family family = sample();
    for (std::size_t left = 4; left > 0; --left) {
        family = with_time_removed(family, left / 2);
        REQUIRE(family.timeline);
        CHECK(family.timeline->keys().size() == left);
    }
    CHECK_FALSE(with_time_removed(family, 0).timeline);
    CHECK(check(with_time_removed(family, 0)).empty());
}

TEST_CASE("whatever else a timeline holds, every edit of a family keeps it") {
    // No edit makes this interpolation by itself.
    constexpr Interpolation other{.basis = Basis::bernstein, .degree = 2};
    Family family = sample();
    const auto keys = family.timeline->keys();
    family.timeline = Timeline({keys.begin(), keys.end()}, other);
    const auto keeps = [&](const Family& edited) {
        return edited.timeline && edited.timeline->interpolation() == other &&
               !(*edited.timeline ==
                 Timeline({edited.timeline->keys().begin(), edited.timeline->keys().end()}));
    };
    CHECK(keeps(with_time_added(family, 3, 1.5)));
    CHECK(keeps(with_time_moved(family, 0, 2.5)));
    CHECK(keeps(with_time_removed(family, 2)));
    CHECK(keeps(with_key_added(family, {"new", surface(1)})));
    CHECK(keeps(with_key_duplicated(family, 0)));
    CHECK(keeps(with_key_moved(family, 0, 3)));
    CHECK(keeps(with_key_renamed(family, 0, "new")));
    for (std::size_t key = 0; key < family.keys.size(); ++key) CHECK(keeps(with_key_removed(family, key)));
    // Also where the only entry moves.
    family.timeline = Timeline({{1, 2}}, other);
    CHECK(keeps(with_time_moved(family, 0, 3)));
}

namespace {

/// A random edit with random arguments; an invalid edit throws.
Family randomly_edited(const Family& family, Random& random) {
    const std::size_t key = random.below(family.keys.size());
    const std::size_t other = random.below(family.keys.size());
    const double time = random.chance(0.1) ? infinity : static_cast<double>(random.below(20)) / 2;
    const double x = 4 * random.unit() - 1;
    const glm::dvec2 at(x, 4 * random.unit() - 1);
    const auto place = [&] { return random.below(family.timeline->keys().size()); };
    const auto vertex = [&] { return static_cast<Index>(random.below(family.domain->vertices().size())); };
    const auto with_domain = [&](std::optional<ParameterDomain> domain) {
        Family after = family;
        after.domain = std::move(domain);
        return after;
    };
    switch (random.below(12)) {
        case 0:
            return with_key_added(family, {"added", random.chance(0.2) ? other_surface() : surface(1)});
        case 1:
            return with_key_duplicated(family, key);
        case 2:
            return with_key_removed(family, key);
        case 3:
            return with_key_renamed(family, key, fmt::format("{}", random.below(12)));
        case 4:
            return with_key_moved(family, key, other);
        case 5:
        case 6:
            return with_time_added(family, key, time);
        case 7:
            return family.timeline ? with_time_moved(family, place(), time) : family;
        case 8:
            return family.timeline ? with_time_removed(family, place()) : family;
        case 9:
        case 10:
            if (!family.domain)
                return with_domain(
                    ParameterDomain({{{0, 0}, key}, {{1, 0}, other}, {{0, 1}, key}}, {{0, 1, 2}}));
            if (family.domain->vertices().size() > 20)
                return with_domain(without_vertex(*family.domain, vertex()));
            return with_domain(with_vertex_added(*family.domain, at, key, 0.05));
        default:
            if (!family.domain) return family;
            if (random.chance(0.5)) return with_domain(with_vertex_moved(*family.domain, vertex(), at));
            return with_domain(with_vertex_key(*family.domain, vertex(), key));
    }
}

}  // namespace

TEST_CASE("any sequence of valid and invalid edits leaves a family that passes check()") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Family family = sample();
        std::size_t refused = 0;
        for (int step = 0; step < 300; ++step) {
            CAPTURE(step);
            const Family before = family;
            try {
                family = randomly_edited(family, random);
            } catch (const InputError&) {
                ++refused;
            }
            const auto violations = check(family);
            REQUIRE_MESSAGE(violations.empty(), violations.front());
        }
        CHECK(refused > 10);
        CHECK(refused < 150);
    }
}

TEST_CASE("adding, duplicating, moving and renaming keys in any order keeps timeline and domain") {
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Family family = sample();
        const auto times = named_times(family);
        const auto vertices = named_vertices(family);
        // The removal of a key that nothing refers to is also allowed.
        for (int step = 0; step < 200; ++step) {
            CAPTURE(step);
            const std::size_t key = random.below(family.keys.size());
            const std::size_t choice = random.below(5);
            if (choice == 0) family = with_key_added(family, {"added", surface(2)});
            if (choice == 1) family = with_key_moved(family, key, random.below(family.keys.size()));
            if (choice == 2) family = with_key_renamed(family, key, fmt::format("{} {}", seed, step));
            if (choice == 3) family = with_key_duplicated(family, key);
            const auto is_named = [&](std::size_t index) {
                const auto in = [&](const auto& places) {
                    return std::ranges::any_of(places, [&](const auto& place) { return place.key == index; });
                };
                return in(family.timeline->keys()) || in(family.domain->vertices());
            };
            if (choice == 4 && !is_named(key)) family = with_key_removed(family, key);
            REQUIRE(named_times(family) == times);
            REQUIRE(named_vertices(family) == vertices);
            REQUIRE(check(family).empty());
        }
    }
}

TEST_CASE("removing keys in any order keeps the times and the domain vertices of the others") {
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Family family = sample();
        while (family.keys.size() > 1) {
            const std::size_t key = random.below(family.keys.size());
            const Hierarchy* const removed = &*family.keys[key].hierarchy;
            auto expected = named_times(family);
            std::erase_if(expected, [&](const NamedTime& named) { return named.second == removed; });
            const auto vertices = named_vertices(family);
            family = with_key_removed(family, key);
            CHECK(named_times(family) == expected);
            // At a corner of the domain, vertices of other keys may also be removed.
            for (const NamedVertex& named : named_vertices(family)) {
                CHECK(std::get<2>(named) != removed);
                CHECK(std::ranges::count(vertices, named) == 1);
            }
        }
    }
}

TEST_CASE("a changed key is followed by its name, though its twin keeps the hierarchy that it had") {
    const Family before = with_key_duplicated(sample(), 1);
    for (const std::size_t place : {std::size_t{1}, std::size_t{2}}) {
        Family after = before;
        after.keys[place].hierarchy = SharedHierarchy(surface(1));
        CHECK(place_after_change(after.keys, before.keys[place], place) == place);
        CHECK(place_after_change(before.keys, after.keys[place], place) == place);
        CHECK(place_after_change(with_key_renamed(before, place, "new").keys, before.keys[place], place) ==
              place);
        CHECK(place_after_change(with_key_moved(before, place, 0).keys, before.keys[place], place) == 0);
    }
    CHECK(place_after_change(with_key_removed(before, 4).keys, before.keys[4], 4) == std::nullopt);
}
