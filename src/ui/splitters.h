// The edges between panels. Dragging an edge changes the size of the panel; a double click gives it its usual size.
#pragma once

#include <optional>

#include "ui/layout.h"
#include "ui/widgets/appearance.h"

namespace interleaf {

/// \param layout  of the window; the edges are shown over it
/// \param sizes   those that \p layout was made of
/// \param scale   scale of the user interface
/// \return the new sizes; none if no edge was dragged
std::optional<PanelSizes> splitters(const Layout& layout, const PanelSizes& sizes, float scale);

}  // namespace interleaf
