// The shading of the blend: the chosen one, or what suits the active keys.
#pragma once

#include "app/document/session.h"
#include "family/family.h"
#include "render/display.h"

namespace interleaf {

/// The shading of \p display; where it has none, flat if all active keys of \p weights have few leaves.
Shading shown_shading(const Display& display, const Family& family, const Weights& weights);
Shading shown_shading(const Session& session);

}  // namespace interleaf
