// The explanation of a control.
#pragma once

#include <string>

namespace interleaf {

/// Shows \p text beside the pointer while the pointer is at the last item, also if the item is disabled.
void tooltip(const std::string& text);

}  // namespace interleaf
