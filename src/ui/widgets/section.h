// The heading of a part of a panel that can be closed.
#pragma once

#include <string_view>

namespace interleaf {

/// Shows the heading \p title with \p remark at its right end. A click closes the section, and opens it again.
/// \param title  unique in the window; the section stays closed under this name (gui_state.h)
/// \param meaning  explains the section where the pointer is at its heading
/// \return whether the section is open, so that its content is to be shown
bool section(std::string_view title, std::string_view remark = {}, const char* meaning = nullptr);

/// Opens the section \p title if it is closed, for a command that leads into it.
void open_section(std::string_view title);

}  // namespace interleaf
