// An error, over the view until it is dismissed.
#pragma once

#include <string>

#include "ui/rect.h"

namespace interleaf {

/// Shows \p message, if any, at the top of \p area; clears it when it is dismissed. It can be copied.
void message_panel(std::string& message, const Rect& area);

}  // namespace interleaf
