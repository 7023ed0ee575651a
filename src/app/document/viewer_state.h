// The state of the viewer: the document, its session, and requests of commands that the window carries out.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/document/brush.h"
#include "app/document/camera_choices.h"
#include "app/document/document.h"
#include "app/document/fit_comparison.h"
#include "app/document/message.h"
#include "app/document/session.h"
#include "hierarchy/nodes/node_path.h"
#include "hierarchy/nodes/node_steps.h"
#include "ui/panels/key_search.h"
#include "ui/widgets/appearance.h"

namespace interleaf {

/// The request of a command that concerns the files of the document.
enum class FileWish : std::uint8_t {
    none,
    open,
    reopen,
    save,
    save_as,
    export_as,
    save_picture,
    add_keys,
    import_series,
    set_landmarks,
    quit
};

/// What the camera frames as a whole from the next frame on.
enum class ViewTarget {
    none,      ///< the camera does not move
    surface,   ///< the surface shown now
    all_keys,  ///< the camera need not move while the keys morph
};

struct ViewerState;

/// A question that the user answers with one line of text.
struct TextQuestion {
    std::string text;
    std::string entry;  ///< the initial text of the entry
    std::string button;
    std::function<std::string(const std::string& entry)>
        fault;  ///< what is wrong with the entry; "" if valid
    std::function<void(ViewerState& state, const std::string& entry, double now)> answer;
};

/// The points that the user has dragged through since the recording began.
struct PathRecording {
    std::optional<double> begin;    ///< wall time of the first point, seconds; none before it
    std::vector<PathPoint> points;  ///< times since the first point
};

struct ViewerState {
    explicit ViewerState(Family family, std::optional<std::filesystem::path> folder = std::nullopt)
        : document(std::move(family), std::move(folder)), session(document.snapshot()) {}

    Document document;
    Session session;  ///< of the document's present state
    std::optional<std::size_t> selected_key;
    std::optional<TimeRange> shown_times;    ///< the part of the timeline that its panel shows; none for all
    std::optional<PathRecording> recording;  ///< of a path through the domain, while it goes on
    bool edits_domain = false;               ///< dragging in the domain moves its vertices and path points
    bool domain_has_focus = false;           ///< arrow keys move the point in the domain
    std::optional<DomainBox> shown_domain;   ///< the part of the domain that its panel shows; none for all
    std::optional<std::size_t> selected_path_point;  ///< while the domain is edited
    bool is_dragging = false;                        ///< the document's present step is a drag in progress

    Brush brush;               ///< refines the selected key
    bool plots_blend = false;  ///< area, volume and leaves of the blend below the timeline

    Comparisons comparisons;      ///< of keys that were fitted to meshes since the document was opened
    bool is_comparing = false;    ///< the window shows a comparison, not the document
    bool compares_colors = true;  ///< the comparison shows distances as colors
    std::shared_ptr<const FitComparison> compared;  ///< the shown one; the first if not in comparisons

    bool shows_keys_beside = false;     ///< a picture of each active key beside the blend
    std::optional<NodePath> inspected;  ///< the node that the inspector shows
    std::optional<NodeStep> node_step;  ///< from the inspected node
    bool inspects_middle = false;       ///< inspect the leaf at the middle of the picture

    FileWish file_wish = FileWish::none;
    bool can_set_landmarks = false;  ///< the last fitted meshes can be fitted again with landmarks
    std::optional<std::filesystem::path> film_wish;  ///< a film or picture to make
    bool makes_film = false;                         ///< a film or picture is in the making
    std::optional<TextQuestion> question;
    bool help_shown = false;
    std::string help_search;
    KeySearch key_search{};
    bool find_wanted = false;  ///< a search field is to take the keyboard: that of the help, or of the keys
    bool menu_wanted = false;  ///< the first menu is to open
    int panel_step = 0;        ///< by how many panels the keyboard is to go on
    Appearance appearance{};
    bool has_theme_of_run = false;  ///< the theme is that of this run alone, and not remembered
    bool search_wanted = false;     ///< the search for commands is to open
    CameraChoices camera;
    CameraWishes camera_wishes{};
    ViewTarget view_target = ViewTarget::all_keys;
    bool reload_wanted = false;
    bool quit_wanted = false;
    Message message{};  ///< empty for none
};

}  // namespace interleaf
