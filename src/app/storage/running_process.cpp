#include "app/storage/running_process.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <system_error>

#include <fmt/core.h>
#include <unistd.h>

#include "hierarchy/error.h"
#include "text/parsed_number.h"

namespace interleaf {

std::optional<ProcessIdentity> running_process(pid_t number) {
    std::ifstream file(fmt::format("/proc/{}/stat", number));
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    // "NUMBER (NAME) STATE ...": the name itself may contain blanks and parentheses.
    const std::size_t end_of_name = text.rfind(')');
    if (end_of_name == std::string::npos) return std::nullopt;
    std::istringstream fields(text.substr(end_of_name + 1));
    std::string field;
    fields >> field;
    if (field == "Z" || field == "X") return std::nullopt;
    constexpr int state = 3;
    constexpr int start_time = 22;
    for (int i = state; i < start_time; ++i) fields >> field;
    const auto started = parsed_number<decltype(ProcessIdentity::start_time)>(field);
    if (!fields || !started) return std::nullopt;
    return ProcessIdentity{.number = number, .start_time = *started};
}

ProcessIdentity this_process() {
    if (const auto process = running_process(::getpid())) return *process;
    throw MachineError("/proc: cannot read when this program was started");
}

}  // namespace interleaf
