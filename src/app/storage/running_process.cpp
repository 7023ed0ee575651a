#include "app/storage/running_process.h"

#include <charconv>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <system_error>

#include <fmt/core.h>
#include <unistd.h>

#include "hierarchy/error.h"

namespace interleaf {

std::optional<ProcessIdentity> running_process(pid_t number) {
    std::ifstream file(fmt::format("/proc/{}/stat", number));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    // "NUMBER (NAME) STATE ...": the name may hold blanks and parentheses itself.
    const std::size_t end_of_name = text.rfind(')');
    if (end_of_name == std::string::npos) return std::nullopt;
    std::istringstream fields(text.substr(end_of_name + 1));
    std::string field;
    fields >> field;
    if (field == "Z" || field == "X") return std::nullopt;
    constexpr int state = 3;
    constexpr int start_time = 22;
    for (int i = state; i < start_time; ++i) fields >> field;
    ProcessIdentity process{.number = number, .start_time = 0};
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), process.start_time);
    if (!fields || error != std::errc() || end != field.data() + field.size()) return std::nullopt;
    return process;
}

ProcessIdentity this_process() {
    if (const auto process = running_process(::getpid())) return *process;
    throw MachineError("/proc: cannot read when this program was started");
}

}  // namespace interleaf
