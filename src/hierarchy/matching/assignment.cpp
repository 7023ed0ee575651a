#include "hierarchy/matching/assignment.h"

#include <cassert>
#include <limits>

namespace interleaf {

namespace {

constexpr auto nobody = static_cast<std::size_t>(-1);

/// Adds rows one after the other. The prices keep cost - row price - column price at 0 for assigned pairs,
/// and never negative for others. So at every time the partners of the rows added so far have the minimum
/// cost.
class Prices {
  public:
    Prices(std::size_t count, std::span<const double> cost)
        : count_(count),
          cost_(cost),
          row_price_(count, 0),
          column_price_(count, 0),
          row_of_(count, nobody),
          came_from_(count),
          distance_(count),
          done_(count) {}

    void take_in(std::size_t row) {
        std::size_t free = nearest_free_column(row);
        while (free != nobody) {  // along the path, each row passes its column on
            const std::size_t before = came_from_[free];
            row_of_[free] = before == nobody ? row : row_of_[before];
            free = before;
        }
    }

    std::vector<std::size_t> partners() const {
        std::vector<std::size_t> partners(count_);
        for (std::size_t column = 0; column < count_; ++column) partners[row_of_[column]] = column;
        return partners;
    }

  private:
    /// Dijkstra's search from \p row over assigned columns to the nearest free one.
    std::size_t nearest_free_column(std::size_t row) {
        distance_.assign(count_, std::numeric_limits<double>::infinity());
        done_.assign(count_, false);
        std::size_t last = nobody;
        double reached = 0;
        for (std::size_t at = row;; at = row_of_[last]) {
            std::size_t nearest = nobody;
            for (std::size_t column = 0; column < count_; ++column) {
                if (done_[column]) continue;
                const double beyond =
                    reached + cost_[at * count_ + column] - row_price_[at] - column_price_[column];
                if (beyond < distance_[column]) {
                    distance_[column] = beyond;
                    came_from_[column] = last;
                }
                if (nearest == nobody || distance_[column] < distance_[nearest]) nearest = column;
            }
            assert(nearest != nobody);
            reached = distance_[nearest];
            if (row_of_[nearest] == nobody) {
                reprice(row, reached);
                return nearest;
            }
            done_[nearest] = true;
            last = nearest;
        }
    }

    void reprice(std::size_t row, double reached) {
        row_price_[row] += reached;
        for (std::size_t column = 0; column < count_; ++column) {
            if (!done_[column]) continue;
            column_price_[column] -= reached - distance_[column];
            row_price_[row_of_[column]] += reached - distance_[column];
        }
    }

    std::size_t count_;
    std::span<const double> cost_;
    std::vector<double> row_price_, column_price_;
    std::vector<std::size_t> row_of_;     ///< by column
    std::vector<std::size_t> came_from_;  ///< by column: the previous column on the shortest path to it
    std::vector<double> distance_;
    std::vector<bool> done_;
};

}  // namespace

std::vector<std::size_t> assignment(std::size_t count, std::span<const double> cost) {
    Prices prices(count, cost);
    for (std::size_t row = 0; row < count; ++row) prices.take_in(row);
    return prices.partners();
}

}  // namespace interleaf
