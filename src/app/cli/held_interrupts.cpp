#include "app/cli/held_interrupts.h"

namespace interleaf {

HeldInterrupts::HeldInterrupts() {
    sigemptyset(&held_);
    sigaddset(&held_, SIGINT);
    sigaddset(&held_, SIGTERM);
    pthread_sigmask(SIG_BLOCK, &held_, &before_);
}

HeldInterrupts::~HeldInterrupts() {
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool HeldInterrupts::is_waiting() const {
    sigset_t waiting;
    sigpending(&waiting);
    return sigismember(&waiting, SIGINT) == 1 || sigismember(&waiting, SIGTERM) == 1;
}

}  // namespace interleaf
