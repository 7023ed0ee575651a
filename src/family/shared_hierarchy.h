// An immutable hierarchy that many families may share as a key. Copying a family copies none of its
// hierarchies, so a document can keep every state.
#pragma once

#include <memory>
#include <utility>

#include "hierarchy/hierarchy.h"

namespace interleaf {

class SharedHierarchy {
  public:
    SharedHierarchy() : SharedHierarchy(Hierarchy()) {}
    SharedHierarchy(Hierarchy hierarchy)
        : hierarchy_(std::make_shared<const Hierarchy>(std::move(hierarchy))) {}

    const Hierarchy& operator*() const { return *hierarchy_; }
    const Hierarchy* operator->() const { return hierarchy_.get(); }

    /// Whether both are the same hierarchy in memory, not merely an equal one.
    bool is_same(const SharedHierarchy& other) const { return hierarchy_ == other.hierarchy_; }

  private:
    std::shared_ptr<const Hierarchy> hierarchy_;
};

}  // namespace interleaf
