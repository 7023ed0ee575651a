// The panels of the window. All panels show one state of the document and change nothing. They return the
// user's actions, which window_actions.h applies.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/mat3x3.hpp>

#include "app/document/viewer_state.h"
#include "app/pictures/key_portraits.h"
#include "app/pictures/morph_surface.h"
#include "app/window/blend_panel.h"
#include "app/window/commands.h"
#include "app/window/comparison_view.h"
#include "app/window/frame_layout.h"
#include "app/window/shortcuts.h"
#include "family/family_fields.h"
#include "render/color_map.h"
#include "ui/dialogs/message_panel.h"
#include "ui/panels/axes_widget.h"
#include "ui/panels/brush_bar.h"
#include "ui/panels/field_curves.h"
#include "ui/panels/help_overlay.h"
#include "ui/panels/inspector_panel.h"
#include "ui/panels/keys_panel.h"
#include "ui/panels/menu_bar.h"
#include "ui/panels/parameter_domain_panel.h"
#include "ui/panels/view_area.h"
#include "ui/timeline/timeline_panel.h"

namespace interleaf {

/// The objects that the mouse holds from one frame to the next.
struct MouseHolds {
    std::optional<DomainDrag> domain;
    std::optional<DomainMenu> domain_menu;
    std::optional<TimeDrag> time;
    std::optional<BrushHold> brush;
};

/// The content that the panels show.
struct WindowContent {
    const ViewerState& state;
    std::span<const std::filesystem::path> recent_files;
    const Shortcuts& shortcuts = table_shortcuts();
    std::string_view title;
    std::span<const KeyPortrait> portraits;  ///< one per key
    std::span<const FamilyField> fields;
    const FieldCurves* field_curves = nullptr;  ///< of the shown scalar over time; null for none
    ColorScale measured_scale = {};             ///< of a coloring by values of the blend
    const BlendCurves* blend_curves = nullptr;  ///< area, volume and leaves over time; null for none
    bool is_flat = false;                       ///< whether all keys lie in one plane
    std::span<const WeightCurve> curves;        ///< of the timeline, in its shown times
    const SurfaceFigures& figures;
    glm::mat3 camera_axes{1};     ///< right, up and backward, as columns
    bool follows_camera = false;  ///< whether the detail of the surface does
    std::optional<double> measured_part =
        {};  ///< of the keys, for their detail; none if there is nothing to measure
    std::span<const MessagePicture> pictures;  ///< illustrations of the message
    double frame_milliseconds;
    bool is_over_surface = false;  ///< the pointer, in the last frame
    MouseHolds holds;
    FrameLayout layout;                        ///< window, content and panels
    const InspectedNode* inspected = nullptr;  ///< null for none
    const ComparisonView* comparison;          ///< shown instead of the document; null for none
    bool has_keyboard = true;                  ///< whether the document or a comparison receives the keyboard
};

/// The user's actions in the panels. Indices refer to the content that the panel showed.
struct WindowActions {
    MenuBarResult menu;
    std::optional<ViewInput> view;
    std::optional<BrushResult> brush;
    std::optional<AxesResult> axes;
    std::optional<KeysPanelResult> keys;
    std::optional<BlendActions> blend;
    std::optional<PanelSizes> panel_sizes;  ///< the new sizes, if the user dragged an edge
    std::optional<Display> display;         ///< the new display, if the user changed it
    bool asks_for_unit = false;             ///< of the shown field
    std::optional<ParameterDomainResult> domain;
    std::optional<TimelineResult> timeline;
    std::optional<ComparisonActions> comparison;
    std::vector<ViewInput> key_views;  ///< the mouse input over the pictures of active keys
    std::optional<InspectorResult> inspector;
    std::optional<HelpResult> help;
    bool dismisses_message = false;
    bool takes_offer = false;   ///< the button of a notice was pressed
    bool wants_domain = false;  ///< the family has none yet
    bool points_at_notice = false;
};

/// The panels as shown: the user's actions, the layout and the content.
struct WindowResult {
    WindowActions actions;
    FrameLayout layout;
    std::shared_ptr<const Family> family;
    Weights weights;                       ///< of the family's keys; empty while a comparison is shown
    std::vector<std::string> legend_keys;  ///< names of the active keys in the display panel's legend
};

/// Shows all panels of the window except questions and the file browser.
/// \pre a frame of Dear ImGui has begun
WindowResult show_window(const WindowContent& shown);

/// The menu entry of \p command.
MenuEntry menu_entry(const Command& command, const ViewerState& state, const Shortcuts& shortcuts);

/// The commands on the selected key, in the order of a key's context menu.
std::vector<const Command*> key_commands();

}  // namespace interleaf
