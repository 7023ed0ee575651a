// The figures of a field over time are measured on a thread, for the keys that have the field.
#include "app/pictures/field_history.h"

#include <doctest/doctest.h>

#include "app/pictures/measured_curves.h"
#include "family/new_family.h"

using namespace interleaf;

namespace {

/// Triangles of area 4 with a field "u", which is \p u everywhere; the last one lacks it.
std::shared_ptr<const Family> timed_family() {
    std::vector<Key> keys;
    for (const float u : {1.0F, 2.0F, 3.0F}) {
        Hierarchy key;
        key.roots = RootComplex(3, {{0, 1, 2}});
        key.bits = {0};
        key.positions = {{0, 0, 0}, {4, 0, 0}, {0, 2, 0}};
        if (u < 3) key.fields = {{"u", FieldKind::scalar, Buffer<float>(3, u)}};
        keys.push_back({std::string(1, static_cast<char>('a' + keys.size())), std::move(key)});
    }
    Family family = family_of_keys("timed", std::move(keys));
    family.timeline = Timeline({{0, 1}, {0.5, 2}, {2, 0}});
    return std::make_shared<const Family>(std::move(family));
}

}  // namespace

TEST_CASE("the curves have the keys of the timeline that have the field, in the order of time") {
    FieldHistory history;
    CHECK_FALSE(history.is_working());
    const std::string field = "u";
    history.follow(timed_family(), &field);
    const FieldCurves curves = testing::measured(history);
    CHECK(curves.times == std::vector<double>{0, 2});
    CHECK(curves.integrals == std::vector<double>{8, 4});
    CHECK(curves.least == std::vector<double>{2, 1});
    CHECK(curves.most == std::vector<double>{2, 1});
    history.follow(timed_family(), nullptr);
    CHECK_FALSE(history.is_working());
    CHECK(history.curves().times.empty());
}

TEST_CASE("an edit that leaves the keys and their times as they are measures nothing anew") {
    FieldHistory history;
    const std::string field = "u";
    const auto family = timed_family();
    history.follow(family, &field);
    CHECK(testing::measured(history).times.size() == 2);
    Family edited = *family;
    edited.name = "another name";
    history.follow(std::make_shared<const Family>(edited), &field);
    CHECK_FALSE(history.is_working());
    CHECK(history.curves().times.size() == 2);
    edited.timeline = edited.timeline->with_entry({3, 1});
    history.follow(std::make_shared<const Family>(edited), &field);
    CHECK(history.is_working());
    CHECK(testing::measured(history).times == std::vector<double>{0, 2, 3});
    CHECK(history.curves().integrals == std::vector<double>{8, 4, 8});
}
