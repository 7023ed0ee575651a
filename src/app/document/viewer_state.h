// What the window is about: the document, where the session stands in it, and wishes of commands that the
// window grants.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "app/document/document.h"
#include "app/document/fit_comparison.h"
#include "app/document/message.h"
#include "app/document/session.h"

namespace interleaf {

/// What a command asks of the files of the document.
enum class FileWish : std::uint8_t { none, open, reopen, save, save_as, add_keys, quit };

/// What the camera shall see the whole of from the next frame on.
enum class ViewTarget {
    none,      ///< it stays where it is
    surface,   ///< what is shown now
    all_keys,  ///< so that it need not move while they morph
};

struct ViewerState;

/// A question with one line of text for an answer.
struct TextQuestion {
    std::string text;
    std::string entry;  ///< at first
    std::string button;
    std::function<std::string(const std::string& entry)> fault;  ///< what is wrong with it; "" for nothing
    std::function<void(ViewerState& state, const std::string& entry, double now)> answer;
};

struct ViewerState {
    explicit ViewerState(Family family, std::optional<std::filesystem::path> folder = std::nullopt)
        : document(std::move(family), std::move(folder)), session(document.snapshot()) {}

    Document document;
    Session session;  ///< of the document's present state
    std::optional<std::size_t> selected_key;
    bool edits_domain = false;  ///< dragging in the domain moves its vertices
    bool is_dragging = false;   ///< the present step of the document is a drag that goes on

    Comparisons comparisons;      ///< of keys that were fitted to meshes since the document was opened
    bool is_comparing = false;    ///< one of them is shown instead of the document
    bool compares_colors = true;  ///< with distances as colors
    std::shared_ptr<const FitComparison> compared;  ///< which of them; the first where this is none of them

    FileWish file_wish = FileWish::none;
    std::optional<TextQuestion> question;
    bool help_shown = false;
    ViewTarget view_target = ViewTarget::all_keys;
    bool reload_wanted = false;
    bool quit_wanted = false;
    Message message{};  ///< empty for none
};

}  // namespace interleaf
