// A sequence: a family whose keys are the states of an evolution, in equal steps of time. The mesh of every
// state is adapted to it, so the keys have different meshes over common roots.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "family/family.h"

namespace interleaf {

struct SequenceOptions {
    /// Number of equal time steps, 1 to 1000. The family has one key more.
    unsigned steps = 30;

    /// Estimated largest distance of a key from the surface that it stands for, as a fraction of the diagonal
    /// of the box of the first state; 1e-5 to 0.05.
    double tolerance = 0.0005;
};

/// Receives the part of the whole work that is done, 0 to 1. It may throw to end the work. An empty function
/// is never called.
using SequenceProgress = std::function<void(double part)>;

/// \throw UsageError if a member is out of its range
void check_options(const SequenceOptions& options);

/// The family \p name of \p states: keys "step 00", "step 01" and so on, with a linear timeline in equal
/// steps from 0 to \p duration seconds, and without a parameter domain.
/// \pre  there are two states at least, over the same roots
Family family_of_states(std::string_view name, std::vector<Hierarchy> states, double duration);

}  // namespace interleaf
