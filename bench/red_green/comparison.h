// The two unions that the same surfaces need: of keys by bisection and of keys by red-green refinement, over
// the same roots and refined by the same error.
#pragma once

#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "overlay.h"
#include <nlohmann/json.hpp>

#include "hierarchy/hierarchy.h"
#include "shapes/shapes.h"

namespace interleaf::bench {

/// A surface with all data that are measured on it only once.
class Subject {
  public:
    /// \param shape  the name of a shape other than the icosahedron
    Subject(RedComplex& complex, std::string_view shape);

    std::string_view name() const { return shape_->name; }

    /// The diagonal of the surface's box.
    double diagonal() const { return diagonal_; }

    /// The key whose leaves are within \p tolerance times the diagonal of their parts of the surface, less
    /// make_key()'s margin.
    RedGreenKey red_green(double tolerance);
    Hierarchy bisected(double tolerance) const;

    /// The minimum tolerance, to a relative 1/1000, whose key has at most \p leaves leaves.
    double red_green_tolerance(std::size_t leaves);
    double bisection_tolerance(std::size_t leaves) const;

  private:
    RedComplex* complex_;
    const Shape* shape_;
    double diagonal_;
    LeafErrors errors_;
};

/// The red complex over the icosahedron, on the unit sphere.
RedComplex sphere_complex();

/// The keys of \p subjects, each at its own tolerance.
std::vector<RedGreenKey> red_green_keys(std::span<Subject* const> subjects,
                                        std::span<const double> tolerances);
std::vector<Hierarchy> bisected_keys(std::span<Subject* const> subjects, std::span<const double> tolerances);

/// The figures of both unions of the same subjects.
nlohmann::ordered_json red_green_figures(std::span<Subject* const> subjects,
                                         std::span<const double> tolerances);
nlohmann::ordered_json bisection_figures(std::span<Subject* const> subjects,
                                         std::span<const double> tolerances);

}  // namespace interleaf::bench
