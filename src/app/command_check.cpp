#include "app/command_check.h"

#include <algorithm>
#include <new>
#include <span>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "app/error_message.h"
#include "app/open_family.h"
#include "app/shown_text.h"
#include "hierarchy/error.h"

namespace interleaf {
namespace {

// Readers check every invariant of what they read, so a file that can be read is sound.
CheckResult check(const std::filesystem::path& file) {
    try {
        std::vector<std::string> changes;
        const Family family = open_family(std::span(&file, 1), &changes);
        fmt::print("{}: sound, {}\n", shown_text(file.string()),
                   family.keys.size() == 1 ? "1 key" : fmt::format("{} keys", family.keys.size()));
        for (const std::string& change : changes) fmt::print("{}: {}\n", shown_text(file.string()), change);
        return CheckResult::sound;
    } catch (const InputError& error) {
        print_error(error.what());
        return CheckResult::at_fault;
    } catch (const MachineError& error) {
        print_error(error.what());
        return CheckResult::unread;
    } catch (const std::bad_alloc&) {
        print_error(fmt::format("{}: out of memory", file.string()));
        return CheckResult::unread;
    }
}

}  // namespace

CheckResult run_check(std::span<const std::filesystem::path> files) {
    CheckResult result = CheckResult::sound;
    for (const std::filesystem::path& file : files) result = std::max(result, check(file));
    return result;
}

}  // namespace interleaf
