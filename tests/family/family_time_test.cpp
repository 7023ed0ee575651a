// Tests of what drives a family's blend over time, and of the edits of its path.
#include "family/family_time.h"

#include <cmath>
#include <vector>

#include "numbers.h"
#include <doctest/doctest.h>

#include "family/domain_edits.h"
#include "family/key_edits.h"
#include "hierarchy/error.h"

using namespace interleaf;

namespace {

/// Keys a, b, c over a triangle with corners (0, 0), (1, 0), (0, 1), a timeline from 0 to 2 and a path from 10
/// to 14.
Family family_with_path() {
    Family family;
    const RootComplex roots(3, {{0, 1, 2}});
    for (const char* name : {"a", "b", "c"})
        family.keys.push_back({name, unrefined(roots, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}})});
    family.timeline.emplace(std::vector<TimelineKey>{{0, 0}, {1, 1}, {2, 2}});
    family.domain.emplace(std::vector<DomainVertex>{{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 2}},
                          std::vector<Triangle>{{0, 1, 2}});
    family.path.emplace(std::vector<PathPoint>{{10, {0, 0}}, {12, {0.5, 0.25}}, {14, {2, 0}}});
    return family;
}

}  // namespace

TEST_CASE("every source of time has a name of its own") {
    for (const TimeSource source : {TimeSource::keys, TimeSource::path})
        CHECK(time_source_named(name_of(source)) == source);
    CHECK_FALSE(time_source_named("point"));
    CHECK_FALSE(time_source_named(""));
}

TEST_CASE("the family's choice drives where there is a choice, and otherwise the part that there is") {
    for (const bool has_keys : {false, true})
        for (const bool has_path : {false, true})
            for (const TimeSource choice : {TimeSource::keys, TimeSource::path}) {
                CAPTURE(has_keys);
                CAPTURE(has_path);
                Family family = family_with_path();
                family.time_source = choice;
                if (!has_keys) family.timeline.reset();
                if (!has_path) family.path.reset();
                const auto source = source_of_time(family);
                if (has_keys && has_path) CHECK(source == choice);
                if (has_keys && !has_path) CHECK(source == TimeSource::keys);
                if (!has_keys && has_path) CHECK(source == TimeSource::path);
                if (!has_keys && !has_path) CHECK_FALSE(source);
                CHECK(check(family).empty() == (has_path || choice == TimeSource::keys));
            }
}

TEST_CASE("the marked times are those of the keys or of the points of the path") {
    const Family family = family_with_path();
    CHECK(marked_times(family, TimeSource::keys) == std::vector<double>{0, 1, 2});
    CHECK(marked_times(family, TimeSource::path) == std::vector<double>{10, 12, 14});
}

TEST_CASE("the interval is that of the keys or of the path") {
    const Family family = family_with_path();
    CHECK(interval_of(family, TimeSource::keys) == TimeRange{0, 2});
    CHECK(interval_of(family, TimeSource::path) == TimeRange{10, 14});
}

TEST_CASE("the weights along the path are those of its point, and those along the keys the timeline's") {
    const Family family = family_with_path();
    for (double time = -1; time < 16; time += 0.125) {
        CAPTURE(time);
        CHECK(weights_at(family, time, TimeSource::keys) == family.timeline->at(time));
        const DomainPoint point = family.domain->locate(family.path->at(time));
        CHECK(place_on_path(family, time).at == point.at);
        CHECK(weights_at(family, time, TimeSource::path) == family.domain->weights(point));
    }
    CHECK(weights_at(family, 12, TimeSource::path) == Weights{{0, 0.25}, {1, 0.5}, {2, 0.25}});
    CHECK(weights_at(family, infinity, TimeSource::path) == weights_at(family, 14, TimeSource::path));
    CHECK_THROWS_AS(weights_at(family, std::nan(""), TimeSource::path), InputError);
}

TEST_CASE("where the path leaves the domain, the nearest point of the domain counts") {
    const Family family = family_with_path();
    CHECK(place_on_path(family, 14).at == glm::dvec2(1, 0));
    CHECK(weights_at(family, 14, TimeSource::path) == Weights{{0, 0}, {1, 1}, {2, 0}});
}

TEST_CASE("a path without a domain violates the family's invariants") {
    Family family = family_with_path();
    CHECK(check(family).empty());
    family.domain.reset();
    CHECK(check(family) == std::vector<std::string>{"the family has a path, but no parameter domain for it"});
    family.path.reset();
    family.time_source = TimeSource::path;
    CHECK(check(family) ==
          std::vector<std::string>{"the path drives the blend over time, but the family has no path"});
}

TEST_CASE("a path stays as it is when the domain changes, and goes with the domain") {
    const Family before = with_time_source(family_with_path(), TimeSource::path);
    const Family moved = with_domain(before, with_vertex_moved(*before.domain, 1, {0.25, 0}));
    CHECK(moved.path == before.path);
    CHECK(moved.time_source == TimeSource::path);
    CHECK(place_on_path(moved, 14).at == glm::dvec2(0.25, 0));
    CHECK(place_on_path(with_domain(moved, before.domain), 14).at == glm::dvec2(1, 0));

    for (const Family& without : {with_domain(before, std::nullopt), with_key_removed(before, 1)}) {
        CHECK_FALSE(without.domain);
        CHECK_FALSE(without.path);
        CHECK(without.time_source == TimeSource::keys);
        CHECK(check(without).empty());
    }
    CHECK(with_key_moved(before, 0, 2).path == before.path);
    CHECK(with_key_moved(before, 0, 2).time_source == TimeSource::path);
}

TEST_CASE("a path needs a domain, and a choice needs the part that it names") {
    const Family family = family_with_path();
    Family bare = with_domain(family, std::nullopt);
    CHECK_THROWS_AS(with_path(bare, family.path), InputError);
    CHECK(check(with_path(bare, std::nullopt)).empty());
    CHECK_THROWS_AS(with_time_source(bare, TimeSource::path), InputError);
    bare.timeline.reset();
    CHECK_THROWS_AS(with_time_source(bare, TimeSource::keys), InputError);
    const Family driven = with_time_source(family, TimeSource::path);
    CHECK(driven.time_source == TimeSource::path);
    CHECK(with_path(driven, DomainPath({{0, {0, 0}}})).time_source == TimeSource::path);
    CHECK(with_path(driven, std::nullopt).time_source == TimeSource::keys);
}
