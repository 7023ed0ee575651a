#include "app/cli/held_interrupts.h"

#include <initializer_list>

namespace interleaf {

namespace {

/// Whether \p signal has no effect on this program, such as SIGINT on a job that a script runs beside others.
bool is_ignored(int signal) {
    struct sigaction action {};
    return sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

HeldInterrupts::HeldInterrupts() {
    sigemptyset(&held_);
    for (const int signal : {SIGINT, SIGTERM})
        if (!is_ignored(signal)) sigaddset(&held_, signal);
    pthread_sigmask(SIG_BLOCK, &held_, &before_);
}

HeldInterrupts::~HeldInterrupts() {
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
}

bool HeldInterrupts::is_waiting() const {
    sigset_t waiting;
    sigpending(&waiting);
    for (const int signal : {SIGINT, SIGTERM})
        if (sigismember(&held_, signal) == 1 && sigismember(&waiting, signal) == 1) return true;
    return false;
}

}  // namespace interleaf
