// The slider of the level of detail, and the choice to let the detail follow the camera.
#pragma once

#include <cstddef>

namespace interleaf {

struct DetailChoice {
    float detail;         ///< 0 for the roots to 1 for the whole keys
    bool follows_camera;  ///< finer where it is seen large, instead of `detail`
    bool operator==(const DetailChoice&) const = default;
};

/// \param leaves       number of leaves of the shown surface
/// \param is_coarse    whether the surface is shown with less detail than chosen, because it moves
/// \return what the user wants
DetailChoice detail_panel(DetailChoice choice, std::size_t leaves, bool is_coarse);

}  // namespace interleaf
