// Identifies a process of this machine, so that a later process with the same number is not mistaken for it.
#pragma once

#include <cstdint>
#include <optional>

#include <sys/types.h>

namespace interleaf {

struct ProcessIdentity {
    pid_t number;
    std::uint64_t start_time;  ///< clock ticks since the boot of the machine: proc(5), stat, field 22

    bool operator==(const ProcessIdentity&) const = default;
};

/// The process with the number \p number; none if there is no such process, or if it has ended and its parent
/// has not collected it yet.
std::optional<ProcessIdentity> running_process(pid_t number);

/// This process.
/// \throw MachineError if there is no /proc
ProcessIdentity this_process();

}  // namespace interleaf
