#include "fit/sphere_map/orientation.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include <glm/geometric.hpp>

namespace interleaf {
namespace {

/// An exact sum of doubles: its parts do not overlap, and grow in size.
class Expansion {
  public:
    void add(double number) {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < size_; ++i) {
            const double sum = number + parts_[i];
            const double from_part = sum - number;
            const double rest = (number - (sum - from_part)) + (parts_[i] - from_part);
            if (rest != 0) parts_[kept++] = rest;
            number = sum;
        }
        if (number != 0) parts_[kept++] = number;
        size_ = kept;
    }

    /// Adds the product of three numbers. Each product of two is a double plus its rounding error.
    void add_product(double a, double b, double c) {
        const double high = a * b;
        const double low = std::fma(a, b, -high);
        for (const double factor : {low, high}) {
            const double product = factor * c;
            add(std::fma(factor, c, -product));
            add(product);
        }
    }

    /// The sign of the sum: the largest part outweighs all others together.
    int sign() const {
        if (size_ == 0) return 0;
        return parts_[size_ - 1] > 0 ? 1 : -1;
    }

  private:
    std::array<double, 24> parts_{};  // six products of four parts each
    std::size_t size_ = 0;
};

}  // namespace

int orientation(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    // Differences of near points are exact or nearly exact, so the filter can decide triangles far smaller
    // than its error on det(a, b, c) itself.
    constexpr double relative_error = 33 * std::numeric_limits<double>::epsilon();
    const glm::dvec3 ab = b - a;
    const glm::dvec3 ac = c - a;
    const double determinant = glm::dot(a, glm::cross(ab, ac));
    // Squared, since a square root takes as long as all the rest. Where the squares underflow, no sign is decided here.
    const double squared_bound =
        relative_error * relative_error * (glm::dot(a, a) * glm::dot(ab, ab) * glm::dot(ac, ac));
    if (determinant * determinant > squared_bound) return determinant > 0 ? 1 : -1;

    Expansion sum;
    sum.add_product(a.x, b.y, c.z);
    sum.add_product(a.y, b.z, c.x);
    sum.add_product(a.z, b.x, c.y);
    sum.add_product(-a.x, b.z, c.y);
    sum.add_product(-a.y, b.x, c.z);
    sum.add_product(-a.z, b.y, c.x);
    return sum.sign();
}

}  // namespace interleaf
