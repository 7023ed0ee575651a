// Tests of the document: its history, and its saved state.
#include "app/document/document.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <doctest/doctest.h>
#include <fmt/core.h>

#include "app/sample_family.h"
#include "hierarchy/random_families.h"

using namespace interleaf;
using interleaf::testing::Random;

namespace {

/// The name of the step; "" for none.
std::string text(const std::string* step) {
    return step != nullptr ? *step : "";
}

}  // namespace

TEST_CASE("a document begins unchanged, with nothing to undo or to do again") {
    Document document(named("first"), "/a/folder");
    CHECK(document.family().name == "first");
    CHECK(document.folder() == "/a/folder");
    CHECK_FALSE(document.is_changed());
    CHECK(document.undo_step() == nullptr);
    CHECK(document.redo_step() == nullptr);
    document.undo();
    document.redo();
    CHECK(document.family().name == "first");
    CHECK_FALSE(document.is_changed());
    CHECK_FALSE(Document(named("first")).folder());
}

TEST_CASE("a step is named where it can be taken back, and where it can be done again") {
    Document document(named("first"));
    document.edit("Rename", named("second"));
    document.edit("Move", named("third"));
    CHECK(text(document.undo_step()) == "Move");
    CHECK(document.redo_step() == nullptr);
    document.undo();
    CHECK(document.family().name == "second");
    CHECK(text(document.undo_step()) == "Rename");
    CHECK(text(document.redo_step()) == "Move");
    document.edit("Remove", named("fourth"));
    CHECK(document.redo_step() == nullptr);
    CHECK(text(document.undo_step()) == "Remove");
    document.undo();
    CHECK(document.family().name == "second");
}

TEST_CASE("undone and done again a state is the very same, and what was kept of it stays") {
    Document document(named("first"));
    const auto first = document.snapshot();
    document.edit("Rename", named("second"));
    const auto second = document.snapshot();
    document.undo();
    CHECK(document.snapshot() == first);
    document.redo();
    CHECK(document.snapshot() == second);
    document.amend(named("third"));
    CHECK(first->name == "first");
    CHECK(second->name == "second");
    CHECK(document.snapshot() != second);
}

TEST_CASE("amended as often as may be, a step is one step, by its first name") {
    Document document(named("first"));
    document.edit("Drag", named("0"));
    for (int i = 1; i < 100; ++i) document.amend(named(fmt::format("{}", i)));
    CHECK(document.family().name == "99");
    CHECK(text(document.undo_step()) == "Drag");
    document.undo();
    CHECK(document.family().name == "first");
    CHECK(document.undo_step() == nullptr);
    document.redo();
    CHECK(document.family().name == "99");
}

TEST_CASE("a state saved is unchanged wherever it is come back to, and no other is") {
    Document document(named("first"));
    document.edit("A", named("second"));
    document.mark_saved(document.snapshot(), "/a/folder");
    CHECK(document.folder() == "/a/folder");
    CHECK_FALSE(document.is_changed());
    document.edit("B", named("third"));
    CHECK(document.is_changed());
    document.undo();
    CHECK_FALSE(document.is_changed());
    document.undo();
    CHECK(document.is_changed());
    document.redo();
    CHECK_FALSE(document.is_changed());
    document.undo();
    document.edit("C", named("fourth"));  // in the saved state's place
    CHECK(document.is_changed());
    document.undo();
    CHECK(document.is_changed());
}

TEST_CASE("a drag that goes on after saving is a change, and so is what was before it") {
    Document document(named("first"));
    document.edit("Drag", named("second"));
    document.mark_saved(document.snapshot(), "/a/folder");
    document.amend(named("third"));
    CHECK(document.is_changed());
    document.undo();
    CHECK(document.is_changed());
}

TEST_CASE("a state that has been left by the time it is saved is the saved one all the same") {
    Document document(named("first"));
    const auto first = document.snapshot();
    document.edit("A", named("second"));
    document.mark_saved(first, "/a/folder");
    CHECK(document.is_changed());
    document.undo();
    CHECK_FALSE(document.is_changed());
}

TEST_CASE("a document that is nowhere on disk is changed in all its states until it is saved") {
    Document document(named("first"), "/a/folder");
    document.mark_unsaved();
    CHECK(document.is_changed());
    document.edit("A", named("second"));
    document.undo();
    CHECK(document.is_changed());
    CHECK(document.folder() == "/a/folder");
    document.mark_saved(document.snapshot(), "/other");
    CHECK_FALSE(document.is_changed());
    CHECK(document.folder() == "/other");
}

TEST_CASE("any sequence of edits, amendments, undoing and saving does what a plain list of states does") {
    struct State {
        std::string step;
        std::string name;
    };
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        CAPTURE(seed);
        Random random(seed);
        Document document(named("start"));
        std::vector<State> states{{"", "start"}};
        std::size_t current = 0;
        std::optional<std::string> saved = "start";
        bool can_amend = false;
        std::vector<std::shared_ptr<const Family>> kept{document.snapshot()};
        for (int step = 0; step < 500; ++step) {
            CAPTURE(step);
            const std::string name = fmt::format("state {}", step);
            const std::size_t choice = random.below(10);
            if (choice < 3) {
                states.resize(current + 1);
                states.push_back({fmt::format("step {}", step), name});
                ++current;
                document.edit(states.back().step, named(name));
                can_amend = true;
            } else if (choice == 3 && can_amend) {
                states[current].name = name;
                document.amend(named(name));
            } else if (choice < 7) {
                document.undo();
                if (current > 0) --current;
                can_amend = false;
            } else if (choice < 9) {
                document.redo();
                if (current + 1 < states.size()) ++current;
                can_amend = false;
            } else if (random.chance(0.2)) {
                document.mark_unsaved();
                saved.reset();
            } else {
                const auto& family =
                    random.chance(0.5) ? document.snapshot() : kept[random.below(kept.size())];
                document.mark_saved(family, "/a/folder");
                saved = family->name;
            }
            kept.push_back(document.snapshot());
            REQUIRE(document.family().name == states[current].name);
            REQUIRE(text(document.undo_step()) == states[current].step);
            REQUIRE(text(document.redo_step()) ==
                    (current + 1 < states.size() ? states[current + 1].step : ""));
            REQUIRE(document.is_changed() == (saved != states[current].name));
        }
    }
}
