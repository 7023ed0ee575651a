#include "app/window/command_search.h"

#include <string>
#include <utility>

#include <fmt/core.h>

#include "app/document/edit_commands.h"
#include "app/window/commands.h"

namespace interleaf {

SearchEntries search_entries(const ViewerState& state, const Shortcuts& shortcuts,
                             std::span<const std::filesystem::path> recent_files) {
    SearchEntries entries;
    const auto& keys = state.document.family().keys;
    entries.shown.reserve(commands().size() + keys.size() + recent_files.size());
    entries.commands.reserve(commands().size());
    for (std::size_t i = 0; i < commands().size(); ++i) {
        const Command& command = commands()[i];
        if (command.id == CommandId::search_commands || command.id == CommandId::dismiss) continue;
        entries.commands.push_back(i);
        entries.shown.push_back({
            .name = command.label != nullptr ? command.label(state) : std::string(command.name),
            .group = std::string(command.menu),
            .shortcut = shortcuts.text(command),
            .description = std::string(command.description),
            .obstacle = std::string(obstacle_of(command, state)),
        });
    }
    entries.keys = keys.size();
    for (const Key& key : keys)
        entries.shown.push_back({.name = fmt::format("Go to key {}", key.name),
                                 .group = "Key",
                                 .shortcut = "",
                                 .description = "Select this key and show it alone",
                                 .obstacle = state.is_comparing ? "close the comparison first (Esc)" : ""});
    for (const std::filesystem::path& file : recent_files)
        entries.shown.push_back({.name = fmt::format("Open {}", file.filename().string()),
                                 .group = "Recent",
                                 .shortcut = "",
                                 .description = file.string(),
                                 .obstacle = ""});
    return entries;
}

void CommandSearch::show(const Rect& area, const ViewerState& state, const Shortcuts& shortcuts,
                         std::span<const std::filesystem::path> recent_files) {
    if (!palette_.is_open()) return;
    entries_ = search_entries(state, shortcuts, recent_files);
    if (const auto chosen = palette_.show(area, entries_.shown)) chosen_ = chosen;
}

std::optional<std::size_t> CommandSearch::act(ViewerState& state, double now) {
    if (std::exchange(state.search_wanted, false) && !palette_.is_open()) palette_.open();
    const auto chosen = std::exchange(chosen_, std::nullopt);
    if (!chosen) return std::nullopt;
    const std::size_t first_key = entries_.commands.size();
    const std::size_t first_file = first_key + entries_.keys;
    if (*chosen >= first_file) return *chosen - first_file;
    if (*chosen >= first_key)
        select_key(state, *chosen - first_key, now);
    else
        run_command(commands()[entries_.commands[*chosen]], state, now);
    return std::nullopt;
}

}  // namespace interleaf
