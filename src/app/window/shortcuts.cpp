#include "app/window/shortcuts.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include <fmt/core.h>

#include "io/text/json_place.h"
#include "text/characters.h"

namespace interleaf {

namespace {

constexpr std::string_view separator = " or ";

/// \p name without the dots of a command that asks something.
std::string_view without_dots(std::string_view name) {
    constexpr std::string_view dots = "...";
    if (name.ends_with(dots)) name.remove_suffix(dots.size());
    return name;
}

const Command* command_named(std::string_view name) {
    const auto found = std::ranges::find_if(commands(), [name](const Command& command) {
        return without_dots(command.name) == without_dots(name);
    });
    return found == commands().end() ? nullptr : &*found;
}

bool contains(const CommandShortcuts& shortcuts, Shortcut shortcut) {
    return shortcut.keyboard_key != 0 && std::ranges::find(shortcuts, shortcut) != shortcuts.end();
}

/// Takes \p shortcut away, and moves the other one to the front.
void remove_shortcut(CommandShortcuts& shortcuts, Shortcut shortcut) {
    if (shortcuts[1] == shortcut) shortcuts[1] = {};
    if (shortcuts[0] == shortcut) shortcuts[0] = std::exchange(shortcuts[1], {});
}

}  // namespace

std::optional<CommandShortcuts> parse_shortcuts(std::string_view text) {
    CommandShortcuts shortcuts{};
    if (text.empty()) return shortcuts;
    const std::string whole = folded(text);
    std::string_view rest = whole;
    for (Shortcut& shortcut : shortcuts) {
        const std::size_t end = rest.find(separator);
        const auto parsed = parse_shortcut(rest.substr(0, end));
        if (!parsed) return std::nullopt;
        shortcut = *parsed;
        if (end == std::string_view::npos) return shortcuts;
        rest.remove_prefix(end + separator.size());
    }
    return std::nullopt;  // more than two
}

std::string text_of(const CommandShortcuts& shortcuts) {
    std::string text;
    for (const Shortcut shortcut : shortcuts) {
        if (shortcut.keyboard_key == 0) continue;
        if (!text.empty()) text += separator;
        text += shortcut_text(shortcut);
    }
    return text;
}

Shortcuts::Shortcuts() {
    shortcuts_.reserve(commands().size());
    for (const Command& command : commands()) shortcuts_.push_back(command.shortcuts);
}

std::vector<std::string> Shortcuts::change(const std::map<std::string, std::string>& wanted) {
    std::vector<std::string> remarks;
    std::vector<bool> is_changed(shortcuts_.size());
    for (const auto& [name, text] : wanted) {
        const Command* const command = command_named(name);
        const auto parsed = parse_shortcuts(text);
        if (command == nullptr) {
            remarks.push_back(fmt::format("shortcuts: there is no command {}", in_quotes(name)));
        } else if (!parsed) {
            remarks.push_back(fmt::format(
                "shortcuts: {}: {} is not a shortcut such as \"Ctrl+K\" or \"W or 1\", nor \"\" for none",
                name, in_quotes(text)));
        } else {
            of(command->id) = *parsed;
            is_changed[static_cast<std::size_t>(command->id)] = true;
        }
    }
    // Of two commands with the same shortcut, the one that the settings do not name loses it, otherwise the later.
    for (const Command& winner : commands()) {
        for (const Command& loser : commands()) {
            const auto first = static_cast<std::size_t>(winner.id);
            const auto second = static_cast<std::size_t>(loser.id);
            const bool wins = is_changed[first] && (!is_changed[second] || first < second);
            if (first == second || !wins) continue;
            for (const Shortcut shortcut : CommandShortcuts(shortcuts_[first])) {
                if (!contains(shortcuts_[second], shortcut)) continue;
                remove_shortcut(shortcuts_[second], shortcut);
                remarks.push_back(fmt::format("shortcuts: {} is for {}, so {} loses it",
                                              shortcut_text(shortcut), winner.name, loser.name));
            }
        }
    }
    return remarks;
}

const Command* Shortcuts::find(Shortcut shortcut) const {
    const auto found = std::ranges::find_if(
        shortcuts_, [shortcut](const CommandShortcuts& each) { return contains(each, shortcut); });
    return found == shortcuts_.end() ? nullptr
                                     : &commands()[static_cast<std::size_t>(found - shortcuts_.begin())];
}

std::string Shortcuts::text(const Command& command) const {
    return text_of(shortcuts_[static_cast<std::size_t>(command.id)]);
}

const Shortcuts& table_shortcuts() {
    static const Shortcuts shortcuts;
    return shortcuts;
}

}  // namespace interleaf
