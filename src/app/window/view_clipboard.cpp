#include "app/window/view_clipboard.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <fmt/core.h>
#include <imgui.h>

#include "app/document/picture_command.h"
#include "hierarchy/error.h"
#include "text/characters.h"
#include "text/shown_text.h"

namespace interleaf {
namespace {

/// The text of the clipboard as a view; also what follows "--camera" in a copied command.
Viewpoint pasted_viewpoint(std::string_view text) {
    constexpr std::string_view option = "--camera";
    constexpr std::size_t longest_shown = 60;
    if (const std::size_t found = text.find(option); found != std::string_view::npos) {
        text.remove_prefix(std::min(found + option.size() + 1, text.size()));
        text = text.substr(0, text.find_first_of(" \n'"));
    }
    text = without_blanks(text);
    if (text.empty()) throw UsageError("the clipboard has no text");
    if (text.size() > longest_shown && text.find('\n') != std::string_view::npos)
        throw UsageError("the text is none that Copy view has copied");
    return parse_viewpoint(text);
}

/// What the copied command cannot repeat; empty for nothing.
std::string remark_on_command(const ViewerState& state) {
    const Display& display = state.session.display;
    if (state.document.is_changed()) return "It draws the saved family, without your unsaved changes.";
    if (display.detail < 1 || display.follows_camera) return "It draws all details.";
    return "";
}

std::string seen_command(const Session& session, const SeenPicture& seen) {
    Display display = session.display;
    display.line_width *= seen.line_scale;
    std::vector<std::filesystem::path> files;
    files.reserve(seen.files.size());
    for (const std::filesystem::path& file : seen.files) {
        std::error_code error;
        const std::filesystem::path whole = std::filesystem::absolute(file, error);
        files.push_back(error ? file : whole);
    }
    return picture_command(files, session, display, viewpoint_of(seen.camera), seen.size);
}

void tell_copied(ViewerState& state, const char* what, const std::string& text, std::string_view remark,
                 double now) {
    ImGui::SetClipboardText(text.c_str());
    state.message = Message{.text = fmt::format("{}: {}{}{}", what, text, remark.empty() ? "" : "\n", remark),
                            .kind = MessageKind::notice,
                            .seen = now};
}

void paste(ViewerState& state) {
    const char* const text = ImGui::GetClipboardText();
    try {
        take_viewpoint(state, pasted_viewpoint(text != nullptr ? text : ""));
    } catch (const UsageError& error) {
        state.message = Message{.text = fmt::format("Paste view: {}", shown_name(error.what()))};
    }
}

}  // namespace

void take_viewpoint(ViewerState& state, const Viewpoint& viewpoint) {
    state.camera.projection = viewpoint.projection;
    state.camera.up = viewpoint.up;
    state.camera_wishes.viewpoint = viewpoint;
}

void use_clipboard(ClipboardWish wish, ViewerState& state, const SeenPicture& seen, double now) {
    switch (wish) {
        case ClipboardWish::none:
            return;
        case ClipboardWish::copy_view:
            return tell_copied(state, "Copied view", text_of(viewpoint_of(seen.camera)), "", now);
        case ClipboardWish::copy_command:
            if (seen.files.empty() && state.document.is_changed()) {
                state.message = Message{.text = "Copy as command: save the family first"};
                return;
            }
            return tell_copied(state, "Copied command", seen_command(state.session, seen),
                               remark_on_command(state), now);
        case ClipboardWish::paste_view:
            return paste(state);
    }
}

}  // namespace interleaf
