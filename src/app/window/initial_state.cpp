#include "app/window/initial_state.h"

#include <string>
#include <string_view>

#include "app/document/path_commands.h"
#include "app/document/shown_field.h"
#include "app/window/view_clipboard.h"
#include "family/family_fields.h"
#include "family/family_time.h"
#include "hierarchy/error.h"

namespace interleaf {

void require_for(const ViewerOptions& options, const Family& family) {
    if (options.at && !family.domain) throw UsageError("--at: the family has no parameter domain");
    require_field(options.display, fields_of(family));
    if (options.time && !source_of_time(family))
        throw UsageError("--time: the family has neither a timeline nor a path");
}

void begin_with(const ViewerOptions& options, ViewerState& state, double now) {
    state.session.display = options.display;
    if (options.theme) state.appearance.theme = *options.theme;
    state.has_theme_of_run = options.theme.has_value();
    if (options.viewpoint) take_viewpoint(state, *options.viewpoint);
    if (options.along) drive_in_this_run(state, *options.along, now);
    if (options.time) state.session.seek(*options.time, now);
    if (options.at) state.session.move_point(*options.at, now);
}

void change_shortcuts(Shortcuts& shortcuts, const Settings& settings, ViewerState& state, Gui& gui) {
    for (const std::string& remark : shortcuts.change(settings.shortcuts)) {
        if (!state.message.empty()) state.message.text += '\n';
        state.message.text += "settings.json: " + remark;
    }
    gui.set_command_keys(command_keys(shortcuts));
}

std::map<std::string, std::string, std::less<>> command_keys(const Shortcuts& shortcuts) {
    std::map<std::string, std::string, std::less<>> keys;
    for (const Command& command : commands()) {
        const std::string_view name = command.name.substr(0, command.name.find_last_not_of('.') + 1);
        keys.emplace(name, shortcuts.text(command));
    }
    return keys;
}

}  // namespace interleaf
