// Tests of the search for commands, keys and recent files.
#include "app/window/command_search.h"

#include <algorithm>

#include <doctest/doctest.h>

#include "app/sample_family.h"
#include "app/window/commands.h"

using namespace interleaf;

TEST_CASE("every command, key and recent file can be found by its name, and a disabled one says why") {
    Family family = sample_family();
    family.timeline.reset();
    family.domain.reset();
    for (const bool is_bare : {false, true}) {
        for (const bool is_comparing : {false, true}) {
            ViewerState state(is_bare ? family : sample_family());
            state.is_comparing = is_comparing;
            const std::vector<std::filesystem::path> recent{"/home/someone/star.ilh"};
            const SearchEntries entries = search_entries(state, table_shortcuts(), recent);
            CHECK(entries.commands.size() == commands().size() - 2);
            CHECK(entries.keys == 5);
            CHECK(entries.shown.size() == entries.commands.size() + 5 + 1);
            for (std::size_t i = 0; i < entries.commands.size(); ++i) {
                const Command& command = commands()[entries.commands[i]];
                CAPTURE(command.name);
                CHECK(entries.shown[i].obstacle.empty() == is_enabled(command, state));
            }
        }
    }
}

TEST_CASE("no command has to fall back on the general reason in a family without anything") {
    Family family = sample_family();
    family.timeline.reset();
    family.domain.reset();
    ViewerState state(std::move(family));
    for (const Command& command : commands()) {
        CAPTURE(command.name);
        CHECK(obstacle_of(command, state) != "not in this state");
    }
}

TEST_CASE("names of keys are found among the commands") {
    ViewerState state(sample_family());
    const SearchEntries entries = search_entries(state, table_shortcuts(), {});
    const std::vector<std::size_t> found = ranked_entries("go key e", entries.shown);
    const std::size_t wanted = entries.commands.size() + 4;
    CHECK(entries.shown[wanted].name == "Go to key e");
    CHECK(std::ranges::find(found, wanted) != found.end());
}

TEST_CASE("a command that asks for the palette opens it") {
    ViewerState state(sample_family());
    CommandSearch search;
    CHECK_FALSE(search.is_open());
    run_command(CommandId::search_commands, state, 0);
    CHECK_FALSE(search.act(state, 0));
    CHECK(search.is_open());
    CHECK_FALSE(state.search_wanted);
}
