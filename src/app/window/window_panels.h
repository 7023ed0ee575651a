// The panels of the window, all shown from one state of the document. They change nothing: what the person
// does in them is returned, for window_actions.h to apply.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/document/viewer_state.h"
#include "app/pictures/key_portraits.h"
#include "app/pictures/morph_surface.h"
#include "app/window/commands.h"
#include "app/window/comparison_view.h"
#include "app/window/frame_layout.h"
#include "family/family_fields.h"
#include "ui/dialogs/message_panel.h"
#include "ui/panels/keys_panel.h"
#include "ui/panels/menu_bar.h"
#include "ui/panels/parameter_domain_panel.h"
#include "ui/panels/timeline_panel.h"
#include "ui/panels/view_area.h"

namespace interleaf {

/// What the mouse holds, from one frame to the next.
struct MouseHolds {
    std::optional<DomainDrag> domain;
    std::optional<DomainMenu> domain_menu;
    std::optional<TimeDrag> time;
};

/// What the panels show.
struct WindowShown {
    const ViewerState& state;
    std::span<const std::filesystem::path> recent_files;
    std::string_view title;
    std::span<const KeyPortrait> portraits;  ///< one per key
    std::span<const FamilyField> fields;
    const SurfaceFigures& figures;
    std::span<const MessagePicture> pictures;  ///< of what the message is about
    double frame_milliseconds;
    MouseHolds holds;
    FrameLayout layout;                ///< window, content and panels
    const ComparisonView* comparison;  ///< is shown instead of the document; null for none
    bool has_keyboard = true;          ///< whether a comparison may read keys
};

/// What the person did in the panels; what each panel showed decides what its indices mean.
struct WindowActions {
    MenuBarResult menu;
    std::optional<ViewInput> view;
    std::optional<KeysPanelResult> keys;
    std::optional<Display> display;  ///< another one than was shown
    std::optional<ParameterDomainResult> domain;
    std::optional<TimelineResult> timeline;
    std::optional<ComparisonActions> comparison;
    bool closes_help = false;
    bool dismisses_message = false;
    bool points_at_notice = false;
};

/// What the panels have shown and where, and what the person did in them.
struct ShownWindow {
    WindowActions actions;
    FrameLayout layout;
    std::shared_ptr<const Family> family;
    Weights weights;                       ///< of keys of the family; none while a comparison is shown
    std::vector<std::string> legend_keys;  ///< names of the active keys in the display panel's legend
};

/// Shows all panels of the window but questions and the file browser.
/// \pre a frame of Dear ImGui has begun
ShownWindow show_window(const WindowShown& shown);

/// \p command as an entry of a menu.
MenuEntry menu_entry(const Command& command, const ViewerState& state);

/// The commands about the selected key, as the menu of a key offers them.
std::vector<const Command*> key_commands();

}  // namespace interleaf
