// What tests ask of every sequence.
#pragma once

#include <cstddef>
#include <vector>

#include "family/family.h"

namespace interleaf {

/// Checks that \p family is sound, that each key passes the checker and has the Euler number \p euler, and
/// that each blend half way between consecutive keys passes the checker.
void check_sequence(const Family& family, int euler);

/// Checks that both families have the same times and, to the last bit, the same keys.
void check_same_bits(const Family& family, const Family& other);

/// The number of leaves of each key.
std::vector<std::size_t> leaf_counts(const Family& family);

/// The least distance of a vertex from the y axis.
double neck_radius(const Hierarchy& key);

/// The radius of the neck of the catenoid between two rings of radius 1, \p distance apart: the larger c with
/// c cosh(distance / 2c) = 1, by bisection.
double exact_neck(double distance);

/// Checks that \p key is the sphere of the flow's ball: its volume to 0.5 %, its Hausdorff distance from the
/// sphere to 1 % of the radius.
void check_ball(const Hierarchy& key);

}  // namespace interleaf
