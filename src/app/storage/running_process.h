// A process of this machine, told apart from a later one that has got the same number.
#pragma once

#include <cstdint>
#include <optional>

#include <sys/types.h>

namespace interleaf {

struct ProcessIdentity {
    pid_t number;
    std::uint64_t start_time;  ///< clock ticks since the machine was started: proc(5), stat, field 22

    bool operator==(const ProcessIdentity&) const = default;
};

/// The process called \p number; none when there is no such process, or it has ended and is not yet forgotten
/// by its parent.
std::optional<ProcessIdentity> running_process(pid_t number);

/// This process. \throw MachineError where there is no /proc
ProcessIdentity this_process();

}  // namespace interleaf
