// The weights of the keys as sliders, and the choice of what drives them.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "family/family.h"

namespace interleaf {

/// A source of weights that the user can choose.
struct DriverButton {
    const char* label;
    std::string tooltip;
};

struct WeightsPanel {
    const Family& family;
    const Weights& weights;
    std::span<const DriverButton> drivers;
    std::size_t driver;      ///< index into `drivers`
    bool can_reset = false;  ///< whether there are weights to go back to
};

struct WeightsPanelResult {
    std::optional<std::size_t> driver;  ///< the chosen one, index into `drivers`
    std::optional<Weights> weights;     ///< new weights
    bool resets = false;                ///< the weights from which the sliders have departed are wanted again
};

/// Largest absolute value of a typed weight. Larger ones would leave the range of positions.
inline constexpr double max_typed_weight = 1e6;

WeightsPanelResult weights_panel(const WeightsPanel& panel);

}  // namespace interleaf
