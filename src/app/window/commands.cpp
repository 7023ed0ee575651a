#include "app/window/commands.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "app/window/command_rows.h"

namespace interleaf {

namespace {

/// Whether the object of \p scope is available.
bool is_in_scope(CommandScope scope, const ViewerState& state) {
    switch (scope) {
        case CommandScope::window:
            return true;
        case CommandScope::document:
            return !state.is_comparing;
        case CommandScope::selected_key:
            return !state.is_comparing && state.selected_key.has_value();
    }
    return false;
}

std::vector<Command> all_commands() {
    std::vector<Command> all;
    for (const std::span<const Command> menu :
         {document_commands(), playback_commands(), inspect_commands(), blend_commands(), camera_commands(),
          view_commands(), appearance_commands(), help_commands()})
        all.insert(all.end(), menu.begin(), menu.end());
    for (std::size_t place = 0; place < all.size(); ++place)
        assert(static_cast<std::size_t>(all[place].id) == place && "commands are in the order of their ids");
    return all;
}

}  // namespace

std::span<const Command> commands() {
    static const std::vector<Command> all = all_commands();
    return all;
}

const Command& command_of(CommandId id) {
    return commands()[static_cast<std::size_t>(id)];
}

bool is_enabled(const Command& command, const ViewerState& state) {
    return is_in_scope(command.scope, state) &&
           (command.is_possible == nullptr || command.is_possible(state));
}

bool is_enabled(CommandId id, const ViewerState& state) {
    return is_enabled(command_of(id), state);
}

void run_command(const Command& command, ViewerState& state, double now) {
    if (is_enabled(command, state)) command.run(state, now);
}

void run_command(CommandId id, ViewerState& state, double now) {
    run_command(command_of(id), state, now);
}

}  // namespace interleaf
