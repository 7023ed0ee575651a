// The assignment problem: as many partners as there are, each given to one, at the least total cost.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace interleaf {

/// The partner of each of \p count rows, all different, such that the sum of cost[row * count + partner] is
/// least. By shortest augmenting paths (Kuhn 1955; in the form of Jonker and Volgenant 1987) in time
/// count^3. Costs are finite.
std::vector<std::size_t> assignment(std::size_t count, std::span<const double> cost);

}  // namespace interleaf
