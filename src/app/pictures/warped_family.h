// The active keys of a flat family, warped by a field (family/warp.h): what the window shows while its height slider
// is up.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "family/family.h"
#include "family/warp.h"

namespace interleaf {

class WarpedFamily {
  public:
    /// Warps the active keys of \p weights.
    /// \param family   must exist while family() is used
    /// \param sources  for each key of \p family an index that sources() passes on; empty if they are equal
    /// \param warp     none to show \p family as it is
    void follow(const Family& family, const Weights& weights, std::span<const std::size_t> sources,
                const std::optional<Warp>& warp);

    bool is_warped() const { return warp_.has_value(); }

    /// The family to show: that of the last follow() itself without a warp; otherwise one of warped keys, without a
    /// timeline and a domain.
    const Family& family() const { return warp_ ? warped_ : *source_; }

    /// The weights and sources of family().
    const Weights& weights() const { return weights_; }
    const std::vector<std::size_t>& sources() const { return sources_; }

  private:
    struct WarpedKey {
        SharedHierarchy flat;
        SharedHierarchy warped;
    };

    const Family* source_ = nullptr;
    std::optional<Warp> warp_;
    Family warped_;
    Weights weights_;
    std::vector<std::size_t> sources_;
    std::vector<WarpedKey> keys_;  ///< by warp_
};

}  // namespace interleaf
