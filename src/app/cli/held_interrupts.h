// Ctrl-C during long work: the work learns of the interrupt and ends in an orderly way, and then the
// interrupt takes effect.
#pragma once

#include <signal.h>

namespace interleaf {

/// Holds back SIGINT and SIGTERM during its lifetime. Its destructor releases a signal that came meanwhile,
/// which then has its usual effect: it ends the program. So no work is left half done. A signal that the program
/// ignores stays without effect.
class HeldInterrupts {
  public:
    HeldInterrupts();
    ~HeldInterrupts();
    HeldInterrupts(const HeldInterrupts&) = delete;
    HeldInterrupts& operator=(const HeldInterrupts&) = delete;

    /// Whether a signal has come.
    bool is_waiting() const;

  private:
    sigset_t held_{};
    sigset_t before_{};
};

}  // namespace interleaf
