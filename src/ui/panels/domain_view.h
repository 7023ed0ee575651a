// The part of a parameter domain's plane that its panel shows: zoom with the wheel at the pointer, and pan.
#pragma once

#include <optional>

#include <glm/vec2.hpp>

#include "family/parameter_domain.h"
#include "ui/widgets/plot_frame.h"

namespace interleaf {

/// \p visible, made smaller or larger by \p factor about \p fixed, which keeps its place. Stays within
/// \p whole, and is not smaller than a ten-thousandth of it.
DomainBox zoomed(const DomainBox& visible, const DomainBox& whole, glm::dvec2 fixed, double factor);

/// \p visible, moved by \p offset as far as \p whole permits.
DomainBox panned(const DomainBox& visible, const DomainBox& whole, glm::dvec2 offset);

/// The part of \p whole that the panel shows.
/// \param wanted  none for all; from an earlier state of the domain, perhaps
DomainBox shown_part(const DomainBox& whole, const std::optional<DomainBox>& wanted);

/// The part to show after the user has turned the wheel over the last item, or dragged it with the middle
/// button; none for no change.
/// \param frame  shows \p visible
std::optional<DomainBox> moved_view(const PlotFrame& frame, const DomainBox& visible, const DomainBox& whole);

}  // namespace interleaf
