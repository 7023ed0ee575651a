// The assignment problem: gives each of n rows a different one of n partners, at the minimum total cost.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace interleaf {

/// Assigns a partner to each row, by shortest augmenting paths (Kuhn 1955; in the form of Jonker and
/// Volgenant 1987) in time count^3.
/// \param count  number of rows, and of partners
/// \param cost   cost[row * count + partner], finite
/// \return the partner of each row; all differ, and the sum of their costs is minimal
std::vector<std::size_t> assignment(std::size_t count, std::span<const double> cost);

}  // namespace interleaf
