// Ctrl-C while long work goes on: the work is told, ends in good order, and then the interrupt takes effect.
#pragma once

#include <signal.h>

namespace interleaf {

/// Holds SIGINT and SIGTERM back while it lives. One that came meanwhile ends the program, as it would have
/// before, when this is destroyed: after what must not stay half done.
class HeldInterrupts {
  public:
    HeldInterrupts();
    ~HeldInterrupts();
    HeldInterrupts(const HeldInterrupts&) = delete;
    HeldInterrupts& operator=(const HeldInterrupts&) = delete;

    /// Whether one has come.
    bool is_waiting() const;

  private:
    sigset_t held_{};
    sigset_t before_{};
};

}  // namespace interleaf
