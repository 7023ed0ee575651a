#include "app/cli/progress_line.h"

#include <cstdio>
#include <string>

#include <fmt/core.h>
#include <unistd.h>

namespace interleaf {
namespace {

constexpr std::string_view wipe = "\r\033[K";
constexpr std::chrono::milliseconds between_lines{100};

}  // namespace

ProgressLine::ProgressLine() : is_terminal_(::isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() {
    if (is_shown_) fmt::print(stderr, "{}", wipe);
}

void ProgressLine::show(std::string_view what, double part) {
    const Clock::time_point now = Clock::now();
    if (!is_terminal_ || now - last_ < between_lines) return;
    last_ = now;
    is_shown_ = true;
    const double seconds = std::chrono::duration<double>(now - begin_).count();
    std::string left;
    if (seconds > 1 && part > 0.02) left = fmt::format(", about {:.0f} s left", seconds * (1 - part) / part);
    fmt::print(stderr, "{}{}: {:.0f} %{}", wipe, what, 100 * part, left);
    std::fflush(stderr);
}

}  // namespace interleaf
