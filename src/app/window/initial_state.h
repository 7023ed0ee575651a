// The state in which the window begins, from the options of `view`.
#pragma once

#include <functional>
#include <map>
#include <string>

#include "app/document/viewer_state.h"
#include "app/storage/settings.h"
#include "app/window/shortcuts.h"
#include "app/window/viewer.h"
#include "family/family.h"
#include "ui/gui.h"

namespace interleaf {

/// \throw UsageError if \p family lacks the domain, the timeline or the field that \p options need
void require_for(const ViewerOptions& options, const Family& family);

/// Gives \p state the display, the view, the time and the point of \p options.
/// \pre require_for() accepts the family
void begin_with(const ViewerOptions& options, ViewerState& state, double now);

/// Gives commands the shortcuts of \p settings, and tells \p gui. The message of \p state says what is wrong with them.
void change_shortcuts(Shortcuts& shortcuts, const Settings& settings, ViewerState& state, Gui& gui);

/// The texts of \p shortcuts by the names of their commands, without dots at the end.
std::map<std::string, std::string, std::less<>> command_keys(const Shortcuts& shortcuts);

}  // namespace interleaf
