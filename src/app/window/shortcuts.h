// The shortcuts of the commands: those of the table, changed by the settings of the user.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/window/commands.h"

namespace interleaf {

/// At most two shortcuts, in front of those that are none.
using CommandShortcuts = std::array<Shortcut, 2>;

/// The shortcuts in \p text, written as shortcut_text() writes them: "Ctrl+Left or Page Up", in any case; "" for
/// none.
/// \return none if \p text is something else
std::optional<CommandShortcuts> parse_shortcuts(std::string_view text);

/// "Ctrl+Q" or "W or 1"; empty if there are none.
std::string text_of(const CommandShortcuts& shortcuts);

class Shortcuts {
  public:
    /// The shortcuts of the table.
    Shortcuts();

    /// Gives commands other shortcuts. Another command that has one of them by the table loses it.
    /// \param wanted  text of the shortcuts (see parse_shortcuts()) by name of the command
    /// \return  what is wrong, and what other commands have lost; a line each. An entry that is wrong has no effect.
    std::vector<std::string> change(const std::map<std::string, std::string>& wanted);

    /// The command with \p shortcut; null if there is none.
    const Command* find(Shortcut shortcut) const;

    std::string text(const Command& command) const;

  private:
    CommandShortcuts& of(CommandId id) { return shortcuts_[static_cast<std::size_t>(id)]; }

    std::vector<CommandShortcuts> shortcuts_;  ///< in the order of the table
};

/// The shortcuts of the table.
const Shortcuts& table_shortcuts();

}  // namespace interleaf
