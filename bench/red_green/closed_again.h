// The other union of red-green keys: the united red forest, closed again by the same rules. It is a red-green
// mesh, so it can be a key again. But it lacks some green lines of the keys, so it only approximates the
// keys.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "red_forest.h"
#include "red_green_key.h"

namespace interleaf::bench {

struct ClosedAgain {
    RedForest forest;
    std::size_t triangles = 0;         ///< of its mesh, including green ones
    std::size_t added_splits = 0;      ///< red splits that no key has
    std::size_t leaves_with_loss = 0;  ///< red leaves in which the line of some key is lost
    std::vector<double> max_loss;      ///< by key: largest distance from the key to the same point here
};

ClosedAgain closed_again(std::span<const RedGreenKey> keys);

}  // namespace interleaf::bench
