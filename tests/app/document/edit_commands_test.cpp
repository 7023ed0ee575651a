// Tests of the edit commands: each is one step, and a command that fails reports it and changes nothing.
#include "app/document/edit_commands.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/core.h>
#include <glm/geometric.hpp>

#include "app/sample_family.h"
#include "family/domain_edits.h"
#include "family/key_edits.h"
#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "hierarchy/morph.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using interleaf::testing::Random;

namespace {

std::string undo_step(const ViewerState& state) {
    const std::string* const step = state.document.undo_step();
    return step != nullptr ? *step : "";
}

std::vector<std::string> names(const ViewerState& state) {
    std::vector<std::string> found;
    for (const Key& key : state.document.family().keys) found.push_back(key.name);
    return found;
}

/// Three random keys over the same roots, on a timeline of two seconds and a triangle as domain.
Family random_sample(std::uint64_t seed) {
    Family family{.name = "random", .keys = {}, .timeline = {}, .domain = {}};
    for (Hierarchy& key : testing::random_family(seed, 3).keys)
        family.keys.push_back({fmt::format("{}", family.keys.size()), std::move(key)});
    family.timeline.emplace(std::vector<TimelineKey>{{0, 0}, {1, 1}, {2, 2}});
    family.domain.emplace(std::vector<DomainVertex>{{{0, 0}, 0}, {{1, 0}, 1}, {{0, 1}, 2}},
                          std::vector<Triangle>{{0, 1, 2}});
    return family;
}

Family keys_alone(std::vector<Key> keys) {
    return {.name = {}, .keys = std::move(keys), .timeline = {}, .domain = {}};
}

/// The corners of the leaves of the surface that \p weights give, in preorder.
std::vector<glm::vec3> surface(const Family& family, const Weights& weights) {
    const UnionMesh mesh = unite(family, weights);
    const Buffer<glm::vec3> positions = morph(mesh, weight_values(weights));
    std::vector<glm::vec3> corners;
    for (const Triangle& triangle : mesh.triangles)
        for (const Index corner : triangle) corners.push_back(positions[corner]);
    return corners;
}

FamilyChange vertex_moved(Index vertex, glm::dvec2 to) {
    return [=](const Family& before) {
        Family after = before;
        after.domain = with_vertex_moved(*before.domain, vertex, to);
        return after;
    };
}

FamilyChange time_moved(std::size_t place, double time) {
    return [=](const Family& before) { return with_time_moved(before, place, time); };
}

}  // namespace

TEST_CASE("a kept blend is the surface shown, a key like any other, named nowhere and selected") {
    for (std::uint64_t seed = 1; seed <= 30; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        ViewerState state(random_sample(seed));
        switch (seed % 3) {
            case 0:
                state.session.seek(2 * random.unit(), 0);
                break;
            case 1: {
                const double x = random.unit();
                state.session.move_point({x, random.unit()}, 0);
                break;
            }
            default:
                select_key(state, random.below(3), 0);
        }
        const Weights weights = state.session.weights();
        const Family before = state.document.family();
        const std::vector<glm::vec3> shown = surface(before, weights);

        keep_blend(state, 0);
        REQUIRE(state.message.empty());
        const Family& after = state.document.family();
        REQUIRE(after.keys.size() == 4);
        CHECK(after.keys.back().name == "blend");
        CHECK(check(*after.keys.back().hierarchy).empty());
        CHECK(check(after).empty());
        CHECK(after.timeline == before.timeline);
        CHECK(after.domain == before.domain);
        CHECK(state.selected_key == 3);
        CHECK(state.session.weights() == weights);
        CHECK(surface(after, {{3, 1}}) == shown);
        CHECK(undo_step(state) == "Keep blend");

        // Also of a kept blend and a key.
        edit(
            state, "Put it on the timeline",
            [](const Family& family) { return with_time_added(family, 3, 3); }, 0);
        state.session.seek(2.5, 0);
        const Weights next = state.session.weights();
        const std::vector<glm::vec3> expected = surface(state.document.family(), next);
        keep_blend(state, 0);
        CHECK(names(state).back() == "blend 2");
        CHECK(surface(state.document.family(), {{4, 1}}) == expected);
    }
}

TEST_CASE("a kept blend has the fields that its keys share, blended") {
    Family family{.name = "fields", .keys = {}, .timeline = {}, .domain = {}};
    for (const float value : {1.0F, 3.0F}) {
        Hierarchy key = unrefined(RootComplex(3, {{0, 1, 2}}), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
        key.fields = {{"heat", FieldKind::scalar, {value, value, value}}};
        if (value < 2) key.fields.push_back({"alone", FieldKind::scalar, {value, value, value}});
        family.keys.push_back({fmt::format("{}", value), std::move(key)});
    }
    ViewerState state(std::move(family));
    state.session.set_weights({{0, 0.5}, {1, 0.5}}, 0);
    keep_blend(state, 0);
    REQUIRE(state.document.family().keys.size() == 3);
    const auto& fields = state.document.family().keys.back().hierarchy->fields;
    REQUIRE(fields.size() == 1);
    CHECK(fields.front().name == "heat");
    CHECK(fields.front().values.front() == 2);
}

TEST_CASE("a duplicated key stays selected and shown when it changes, and its twin does not") {
    for (const std::size_t key : {std::size_t{0}, std::size_t{1}}) {
        ViewerState state(random_sample(1));
        state.selected_key = 0;
        duplicate_key(state, 0);
        select_key(state, key, 0);
        const auto change = [key](const Family& family) {
            Family changed = family;
            changed.keys[key].hierarchy = SharedHierarchy(Hierarchy(*family.keys[key].hierarchy));
            return changed;
        };
        edit(state, "Change it", change, 0);
        CHECK(state.selected_key == key);
        CHECK(state.session.weights() == Weights{{key, 1}});
        undo(state, 0);
        CHECK(state.selected_key == key);
        CHECK(state.session.weights() == Weights{{key, 1}});
    }
}

TEST_CASE("a drag is one step, places where it cannot be are passed over, and its end is where it came to") {
    ViewerState state(sample_family());
    const auto before = state.document.snapshot();
    drag_edit(state, "Move a time", time_moved(1, 1), 0);
    for (double time = 0.5; time < 2.9; time += 0.25) drag_edit(state, "Move a time", time_moved(1, time), 0);
    drag_edit(state, "Move a time", time_moved(1, 3), 0);             // taken
    drag_edit(state, "Move a time", time_moved(1, std::nan("")), 0);  // no time
    CHECK(state.message.empty());
    end_drag(state);
    CHECK(state.document.family().timeline->keys()[1] == TimelineKey{2.75, 1});
    CHECK(undo_step(state) == "Move a time");
    undo(state, 0);
    CHECK(state.document.snapshot() == before);
    CHECK(state.document.undo_step() == nullptr);
    redo(state, 0);
    CHECK(state.document.family().timeline->keys()[1] == TimelineKey{2.75, 1});
}

TEST_CASE("a drag that is nowhere valid is no step") {
    ViewerState state(sample_family());
    for (const double time : {0.0, 3.0, 4.0}) drag_edit(state, "Move a time", time_moved(1, time), 0);
    end_drag(state);
    CHECK(state.document.undo_step() == nullptr);
    CHECK_FALSE(state.document.is_changed());
    CHECK(state.message.empty());
}

TEST_CASE("two drags are two steps, and an edit or undoing in between ends a drag") {
    ViewerState state(sample_family());
    const auto before = state.document.snapshot();
    drag_edit(state, "First", vertex_moved(4, {0.1, 0}), 0);
    drag_edit(state, "First", vertex_moved(4, {0.2, 0}), 0);
    end_drag(state);
    const auto first = state.document.snapshot();
    drag_edit(state, "Second", vertex_moved(4, {0.3, 0}), 0);
    CHECK(undo_step(state) == "Second");
    undo(state, 0);
    CHECK(state.document.snapshot() == first);
    drag_edit(state, "Third", vertex_moved(4, {0.4, 0}), 0);
    CHECK(undo_step(state) == "Third");
    state.selected_key = 0;
    duplicate_key(state, 0);
    drag_edit(state, "Fourth", vertex_moved(4, {0.5, 0}), 0);
    for (const char* const step : {"Fourth", "Duplicate a", "Third", "First"}) {
        CHECK(undo_step(state) == step);
        undo(state, 0);
    }
    CHECK(state.document.snapshot() == before);
}

TEST_CASE("what cannot be done becomes the message and is no step") {
    ViewerState state(sample_family());
    const auto before = state.document.snapshot();
    const auto refused = [&] {
        const bool is_refused = !state.message.empty() && state.document.snapshot() == before &&
                                state.document.undo_step() == nullptr && !state.document.is_changed();
        state.message.clear();
        return is_refused;
    };
    add_time(state, 0, 3, 0);
    CHECK(refused());
    add_time(state, 0, std::nan(""), 0);
    CHECK(refused());
    add_domain_vertex(state, {0, 0}, 0, 0.1, 0);
    CHECK(refused());
    add_domain_vertex(state, {std::nan(""), 0}, 0, 0.1, 0);
    CHECK(refused());
    add_keys(state,
             keys_alone({{"other", unrefined(RootComplex(4, {{0, 1, 2}, {2, 1, 3}}), {{}, {}, {}, {}})}}), 0);
    CHECK(refused());
    Family many = sample_family();
    for (int i = 0; i < 9; ++i) many = with_key_added(many, many.keys[0]);
    ViewerState full(many);
    make_domain(full, 0);
    CHECK(full.message.text.find("three to nine") != std::string::npos);
    CHECK(full.document.undo_step() == nullptr);
    ViewerState single({"single", {sample_family().keys[0]}, {}, {}});
    single.selected_key = 0;
    remove_key(single, 0);
    CHECK_FALSE(single.message.empty());
    CHECK(single.selected_key == 0);
}

TEST_CASE("without a selected key the commands on it do nothing") {
    ViewerState state(sample_family());
    duplicate_key(state, 0);
    remove_key(state, 0);
    move_key(state, 1, 0);
    ask_for_key_name(state);
    ask_for_new_time(state);
    CHECK(state.document.undo_step() == nullptr);
    CHECK_FALSE(state.question);
    CHECK(state.message.empty());
}

TEST_CASE("moving a key to its own place, or to none, is no step") {
    ViewerState state(sample_family());
    state.selected_key = 2;
    move_key(state, 2, 0);
    move_key(state, 5, 0);
    set_domain_vertex_key(state, 4, 4, 0);
    CHECK(state.document.undo_step() == nullptr);
}

TEST_CASE("the selection follows its key wherever edits and undoing take it") {
    ViewerState state(sample_family());
    state.selected_key = 1;
    move_key(state, 4, 0);
    CHECK(state.selected_key == 4);
    undo(state, 0);
    CHECK(state.selected_key == 1);
    duplicate_key(state, 0);
    CHECK(names(state) == std::vector<std::string>{"a", "b", "b 2", "c", "d", "e"});
    CHECK(state.selected_key == 1);
    state.selected_key = 4;  // d
    undo(state, 0);
    CHECK(state.selected_key == 3);
    remove_key(state, 0);
    CHECK_FALSE(state.selected_key);
    CHECK(undo_step(state) == "Remove d");
}

TEST_CASE("undoing the rename of a copy selects the copy") {
    ViewerState state(sample_family());
    state.selected_key = 1;
    duplicate_key(state, 0);
    state.selected_key = 2;  // b 2
    ask_for_key_name(state);
    state.question->answer(state, "x", 0);
    CHECK(state.selected_key == 2);
    undo(state, 0);
    CHECK(names(state)[2] == "b 2");
    CHECK(state.selected_key == 2);
    redo(state, 0);
    CHECK(state.selected_key == 2);
}

TEST_CASE("keys are added in their order under names of their own, as one step") {
    ViewerState state(sample_family());
    const Key key = sample_family().keys[0];
    add_keys(state, keys_alone({key, {"new", key.hierarchy}, key}), 0);
    CHECK(names(state) == std::vector<std::string>{"a", "b", "c", "d", "e", "a 2", "new", "a 3"});
    CHECK(undo_step(state) == "Add 3 keys");
    add_keys(state, keys_alone({{"one", key.hierarchy}}), 0);
    CHECK(undo_step(state) == "Add one");
    undo(state, 0);
    undo(state, 0);
    CHECK(names(state) == std::vector<std::string>{"a", "b", "c", "d", "e"});
}

TEST_CASE("edits of the timeline keep what it holds besides its keys, and so do undo and redo") {
    constexpr Interpolation other{.basis = Basis::bernstein, .degree = 2};
    Family family = sample_family();
    const auto keys = family.timeline->keys();
    family.timeline = Timeline({keys.begin(), keys.end()}, other);
    Document document(family, {});
    document.edit("Add", with_time_added(document.family(), 3, 2));
    document.edit("Move", with_time_moved(document.family(), 0, 9));
    document.edit("Take off", with_time_removed(document.family(), 1));
    document.edit("Remove", with_key_removed(document.family(), 3));
    for (int step = 0; step < 4; ++step) {
        CHECK(document.family().timeline->interpolation() == other);
        document.undo();
    }
    CHECK(document.family().timeline == family.timeline);
    for (int step = 0; step < 4; ++step) {
        document.redo();
        CHECK(document.family().timeline->interpolation() == other);
    }
}

TEST_CASE("a key is renamed by its question, which refuses what a key cannot be called") {
    ViewerState state(sample_family());
    state.selected_key = 1;
    ask_for_key_name(state);
    REQUIRE(state.question);
    const TextQuestion question = *state.question;
    CHECK(question.entry == "b");
    CHECK(question.fault("b").empty());
    CHECK(question.fault("x").empty());
    CHECK_FALSE(question.fault("").empty());
    CHECK_FALSE(question.fault("c").empty());
    // Saving refuses them.
    for (const char* name : {"a\nb", "a\u009b2J", "\xff"}) CHECK_FALSE(question.fault(name).empty());
    question.answer(state, "b", 0);
    CHECK(state.document.undo_step() == nullptr);
    question.answer(state, "x", 0);
    CHECK(names(state)[1] == "x");
    CHECK(state.selected_key == 1);
    CHECK(undo_step(state) == "Rename b");
    undo(state, 0);
    CHECK(names(state)[1] == "b");
    CHECK(state.selected_key == 1);
}

TEST_CASE("the family is renamed by its question, times are set by theirs") {
    ViewerState state(sample_family());
    ask_for_family_name(state);
    REQUIRE(state.question);
    CHECK(state.question->entry == "sample");
    for (const char* name : {"", "a\nb", "a\u009b2J", "\xff"})
        CHECK_FALSE(state.question->fault(name).empty());
    TextQuestion(*state.question).answer(state, "other", 0);
    CHECK(state.document.family().name == "other");

    state.selected_key = 3;
    ask_for_new_time(state);
    for (const char* const text : {"", "x", "1 s", "nan", "inf", "1e999", " 1"})
        CHECK_FALSE(state.question->fault(text).empty());
    for (const char* const text : {"6", "-1.5", "1e3", state.question->entry.c_str()})
        CHECK(state.question->fault(text).empty());
    TextQuestion(*state.question).answer(state, "-1.5", 0);
    CHECK(state.document.family().timeline->keys().front() == TimelineKey{-1.5, 3});

    ask_for_time(state, 0);
    CHECK(state.question->entry == "-1.5");
    TextQuestion(*state.question).answer(state, "2", 0);
    CHECK(state.document.family().timeline->keys()[2] == TimelineKey{2, 3});
    const std::string* const step = state.document.undo_step();
    ask_for_time(state, 2);
    TextQuestion(*state.question).answer(state, "2", 0);
    CHECK(state.document.undo_step() == step);  // the same time is no step
    remove_time(state, 2, 0);
    CHECK(state.document.family().timeline == sample_family().timeline);
}

TEST_CASE("a time is asked for without digits of rounding, and answered as it was asked it is no step") {
    ViewerState state(sample_family());
    add_time(state, 3, 139 * 0.01, 0);  // 1.3900000000000001
    const std::string* const step = state.document.undo_step();
    ask_for_time(state, 2);
    CHECK(state.question->entry == "1.39");
    TextQuestion(*state.question).answer(state, "1.39", 0);
    CHECK(state.document.undo_step() == step);

    state.selected_key = 3;
    add_time(state, 3, 801 * 0.1 - 70, 0);  // 10.100000000000009 or so, the last
    ask_for_new_time(state);
    CHECK(state.question->entry == "11.1");
    add_time(state, 3, 139 * 0.01, 0);
    CHECK(state.message.text.starts_with("the time 1.39 s is already taken"));
}

TEST_CASE("time, point, shown key and display are no steps") {
    ViewerState state(sample_family());
    state.session.seek(1.5, 0);
    state.session.move_point({0.5, 0.25}, 0);
    select_key(state, 3, 0);
    CHECK(state.selected_key == 3);
    CHECK(state.session.weights() == Weights{{3, 1}});
    CHECK(state.document.undo_step() == nullptr);
    CHECK_FALSE(state.document.is_changed());
}

namespace {

void edit_at_random(ViewerState& state, Random& random) {
    const Family& family = state.document.family();
    const std::size_t key = random.below(family.keys.size());
    const double time = static_cast<double>(random.below(16)) / 2;
    const double x = 3 * random.unit() - 1.5;
    const glm::dvec2 at(x, 3 * random.unit() - 1.5);
    state.selected_key = random.below(family.keys.size());
    const std::size_t choice = random.below(15);
    if (choice == 0) duplicate_key(state, 0);
    if (choice == 1) remove_key(state, 0);
    if (choice == 2) move_key(state, key, 0);
    if (choice == 3) add_time(state, key, time, 0);
    if (choice == 4) keep_blend(state, 0);
    if (choice == 5) make_domain(state, 0);
    if (choice == 6) state.session.seek(time, 0);
    if (choice == 7) select_key(state, key, 0);
    if (choice == 8) {
        ask_for_key_name(state);
        TextQuestion(*state.question).answer(state, fmt::format("{}", random.below(20)), 0);
    }
    if (family.timeline) {
        const std::size_t place = random.below(family.timeline->keys().size());
        if (choice == 9 && random.chance(0.3)) remove_time(state, place, 0);
        for (int i = 0; choice == 10 && i < 5; ++i)
            drag_edit(state, "Move a time", time_moved(place, time + i), 0);
    }
    if (family.domain) {
        const auto vertex = static_cast<Index>(random.below(family.domain->vertices().size()));
        if (choice == 14) remove_domain_vertex(state, vertex, 0);
        if (choice == 11) add_domain_vertex(state, at, key, 0.05, 0);
        if (choice == 12) set_domain_vertex_key(state, vertex, key, 0);
        for (int i = 0; choice == 13 && i < 5; ++i)
            drag_edit(state, "Move a vertex", vertex_moved(vertex, at * (i / 4.0)), 0);
        if (choice == 6 && state.document.family().domain) state.session.move_point(at, 0);
    }
    end_drag(state);
}

/// Whether session and selection belong to the document's present state.
bool is_in_step(const ViewerState& state) {
    const Family& family = state.document.family();
    const auto exists = [&](std::size_t key) { return key < family.keys.size(); };
    const Session& session = state.session;
    return &session.family() == &family && check(family).empty() &&
           (!state.selected_key || exists(*state.selected_key)) &&
           std::ranges::all_of(active_keys(session.weights()), exists) &&
           session.has_timeline() == family.timeline.has_value() && (family.domain || !session.point());
}

}  // namespace

TEST_CASE(
    "any sequence of edits is undone and done again state by state, with session and selection in step") {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        ViewerState state(sample_family());
        std::vector<std::shared_ptr<const Family>> history{state.document.snapshot()};
        for (int step = 0; step < 250; ++step) {
            CAPTURE(step);
            edit_at_random(state, random);
            REQUIRE(is_in_step(state));
            if (state.document.snapshot() != history.back()) history.push_back(state.document.snapshot());
            if (!random.chance(0.05)) continue;
            // Some steps back, and from there on, or forward again.
            for (std::size_t back = random.below(5); back > 0 && history.size() > 1; --back) {
                undo(state, 0);
                history.pop_back();
                REQUIRE(state.document.snapshot() == history.back());
                REQUIRE(is_in_step(state));
            }
        }
        while (state.document.redo_step() != nullptr) {
            redo(state, 0);
            history.push_back(state.document.snapshot());
        }
        REQUIRE(history.size() > 50);
        for (std::size_t place = history.size() - 1; place > 0; --place) {
            REQUIRE(state.document.undo_step() != nullptr);
            undo(state, 0);
            REQUIRE(state.document.snapshot() == history[place - 1]);
            REQUIRE(is_in_step(state));
            REQUIRE(state.document.is_changed() == (place > 1));
        }
        CHECK(state.document.undo_step() == nullptr);
        for (std::size_t place = 1; place < history.size(); ++place) {
            redo(state, 0);
            REQUIRE(state.document.snapshot() == history[place]);
            REQUIRE(is_in_step(state));
        }
        CHECK(state.document.redo_step() == nullptr);
    }
}
