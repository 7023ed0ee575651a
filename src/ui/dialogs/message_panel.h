// Messages over the view: what is wrong, until it is dismissed, and notices, in a corner.
#pragma once

#include <span>
#include <string>

#include <glm/vec2.hpp>

#include "ui/widgets/rect.h"

namespace interleaf {

/// A picture that shows what a message is about.
struct MessagePicture {
    unsigned texture;  ///< of OpenGL, of the size of message_picture_size() or another of that form
    std::string caption;
};

/// Shows \p message, if any, at the top of \p area, and at most two \p pictures side by side, as large as
/// there is room. The user can copy the text.
/// \return whether the message was dismissed
bool message_panel(const std::string& message, std::span<const MessagePicture> pictures, const Rect& area);

struct NoticeResult {
    bool pointed_at = false;
    bool dismissed = false;  ///< it was clicked
};

/// Shows the notice \p text, if any, small and calm in a lower corner of \p area.
NoticeResult notice_panel(const std::string& text, const Rect& area);

/// The largest size of a picture, in screen coordinates.
glm::vec2 message_picture_size();

}  // namespace interleaf
