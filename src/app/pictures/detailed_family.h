// The active keys of a family at a level of detail: each key is replaced by the two levels around the wanted
// detail (hierarchy/detail/detail_levels.h), so the blend of all of them changes continuously with the detail.
#pragma once

#include <cstddef>
#include <map>
#include <vector>

#include "app/pictures/key_details.h"
#include "family/family.h"

namespace interleaf {

class DetailedFamily {
  public:
    /// Updates the levels to the active keys of \p weights. Until \p details has measured all of them, the
    /// detail is full.
    /// \param detail  0 for the roots to 1 for the whole keys
    void follow(const Family& family, const Weights& weights, float detail, KeyDetails& details);

    /// The family to show instead: the family of the last follow() itself at full detail, which must still
    /// exist; otherwise one of levels, without a timeline and a domain.
    const Family& family() const { return is_whole_ ? *source_ : levels_; }

    /// The weights of family() with the same surface as those of the last follow(), at the wanted detail.
    const Weights& weights() const { return weights_; }

    /// For each key of family() its index in the family of the last follow(); empty at full detail, where the
    /// indices are equal.
    const std::vector<std::size_t>& sources() const { return sources_; }

  private:
    /// The cuts of a key that are in use.
    struct CutKey {
        SharedHierarchy hierarchy;
        KeyDetails::Measured measured;
        std::map<std::size_t, SharedHierarchy> cuts{};  ///< by the number of the level
    };
    /// The key in cuts_, which may be new.
    CutKey& cuts_of(const SharedHierarchy& hierarchy, KeyDetails::Measured measured);
    static SharedHierarchy cut_of(CutKey& key, std::size_t level);
    void add(CutKey& cuts, const Key& key, std::size_t source, double weight, float detail);
    void add_level(const Key& key, std::size_t source, SharedHierarchy level, double weight);

    const Family* source_ = nullptr;
    bool is_whole_ = true;
    Family levels_;
    Weights weights_;
    std::vector<std::size_t> sources_;
    std::vector<CutKey> cuts_;  ///< of the active keys
};

}  // namespace interleaf
