// The films of `interleaf render`: a film file, or numbered pictures.
#pragma once

#include <string>

#include "app/cli/render_command.h"
#include "family/family.h"

namespace interleaf {

/// Whether \p target is the name of numbered pictures: it has a '#' per digit of the number of the frame, as
/// "frame.####.png".
bool has_frame_number(const std::string& target);

/// \p target with \p number instead of its last row of '#'. A number with more digits takes more places.
/// \pre has_frame_number(target)
std::string numbered(const std::string& target, std::size_t number);

/// Draws the frames that \p options ask for. Progress is shown on a terminal; an interrupt ends the work, and
/// leaves no part of a film file.
/// \param format  one of render_formats()
/// \throw UsageError, MachineError
void render_film(const RenderOptions& options, const std::string& format, const Family& family);

}  // namespace interleaf
