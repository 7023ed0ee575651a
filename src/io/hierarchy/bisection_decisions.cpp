#include "io/hierarchy/bisection_decisions.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/hierarchy/bisection_walk.h"

namespace interleaf {

namespace {

/// Records the decisions of a hierarchy.
class DecisionWriter {
  public:
    explicit DecisionWriter(const Hierarchy& hierarchy) : hierarchy_(hierarchy) {
        decisions_.resize(hierarchy.node_count() + 1);
    }

    bool peek(std::size_t position) {
        const bool bisected = hierarchy_.is_bisected(position);
        decisions_[count_] = std::byte{bisected};
        return bisected;
    }
    void take(bool open) { count_ += open; }

    Buffer<std::byte> finish() {
        decisions_.resize(count_);
        return std::move(decisions_);
    }

  private:
    const Hierarchy& hierarchy_;
    Buffer<std::byte> decisions_;
    std::size_t count_ = 0;
};

/// Gives the stored decisions, one after the other.
class DecisionReader {
  public:
    explicit DecisionReader(std::span<const std::byte> decisions) : decisions_(decisions) {}

    bool peek(std::size_t) const { return next_ < decisions_.size() && decisions_[next_] != std::byte{0}; }
    void take(bool open) { next_ += open; }

    void require_end() const {
        if (next_ != decisions_.size())
            throw InputError(fmt::format("{} decisions, expected {}", decisions_.size(), next_));
    }

  private:
    std::span<const std::byte> decisions_;
    std::size_t next_ = 0;
};

}  // namespace

DecidedConnectivity open_decisions(const Hierarchy& hierarchy) {
    DecisionWriter writer(hierarchy);
    Connectivity connectivity =
        bisection_walk::Walk(hierarchy.roots, static_cast<Index>(hierarchy.midpoints.size()),
                             static_cast<Index>(hierarchy.vertex_count()), writer)
            .run();
    assert(std::ranges::equal(connectivity.bits, hierarchy.bits));
    assert(std::ranges::equal(connectivity.midpoints, hierarchy.midpoints));
    return {writer.finish(), std::move(connectivity)};
}

Connectivity rebuilt_connectivity(const RootComplex& roots, Index midpoint_count, Index vertex_count,
                                  std::span<const std::byte> decisions) {
    const auto faulty = std::ranges::find_if(decisions, [](std::byte b) { return b > std::byte{1}; });
    if (faulty != decisions.end())
        throw InputError(fmt::format("decision {} is {}, expected 0 or 1", faulty - decisions.begin(),
                                     std::to_integer<unsigned>(*faulty)));
    DecisionReader reader(decisions);
    Connectivity connectivity = bisection_walk::Walk(roots, midpoint_count, vertex_count, reader).run();
    reader.require_end();
    return connectivity;
}

}  // namespace interleaf
