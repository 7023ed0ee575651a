// The three kinds of failure that Interleaf reports to its user. They are thrown where the fault is found and
// caught once, at the edge: the command line turns them into exit statuses 1, 2 and 3, the window into a
// message. Programming errors are assertions, not exceptions.
#pragma once

#include <stdexcept>

namespace interleaf {

/// The input is at fault: a file, a mesh, a number in either. The text says where the fault is, and what was
/// expected.
struct InputError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The command line is at fault.
struct UsageError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// The machine is at fault: no display, disk full, no permission to write.
struct MachineError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace interleaf
