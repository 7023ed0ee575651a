// Messages over the view: faults, which stay until the user dismisses them, and notices in a corner.
#pragma once

#include <span>
#include <string>

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

/// A picture that illustrates a message.
struct MessagePicture {
    unsigned texture;  ///< OpenGL texture with the aspect ratio of message_picture_size()
    std::string caption;
};

/// Shows \p message, if there is one, at the top of \p area, with at most two \p pictures side by side, as
/// large as there is room. The user can copy the text.
/// \return whether the message was dismissed
bool message_panel(const std::string& message, std::span<const MessagePicture> pictures, const Rect& area);

struct NoticeResult {
    bool pointed_at = false;
    bool dismissed = false;  ///< by a click
    bool pressed = false;    ///< the button
};

/// Shows the notice \p text, if there is one, in a small panel in the lower left corner of \p area.
/// \param button  label of a button below the text; null for none
NoticeResult notice_panel(const std::string& text, const char* button, const Rect& area);

/// The largest size of a picture, in screen coordinates.
glm::vec2 message_picture_size();

}  // namespace interleaf
