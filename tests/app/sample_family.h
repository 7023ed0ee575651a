// A family to test the session with: the paper's square domain. Each of its keys is a triangle of its own.
#pragma once

#include <string>

#include "family/family.h"

namespace interleaf {

/// Keys a, b, c, d at the corners of the square from (-1, -1) on, e in the middle. The timeline passes a, b,
/// e, c along edges of the domain at times 0, 1, 3, 4, and goes back to a at time 5, where no edge leads from
/// c.
Family sample_family();

/// The same family, called \p name.
Family named(const std::string& name);

}  // namespace interleaf
