// A dialog for long work: its progress, the time left, and a button to cancel it.
#pragma once

#include <string>

#include "ui/widgets/rect.h"

namespace interleaf {

struct ProgressShown {
    std::string title;
    std::string stage;
    double part;     ///< done part of the work, 0 to 1
    double seconds;  ///< since the work began
};

/// Shows the dialog. Call it in every frame while the work goes on, from the same place, and once more with
/// \p closing.
/// \return whether the user cancels the work, by the button or by Esc
bool progress_dialog(const ProgressShown& shown, const Rect& area, bool closing);

/// The remaining time: "about 12 s left". Empty while it is too early for an estimate.
std::string time_left(double part, double seconds);

}  // namespace interleaf
