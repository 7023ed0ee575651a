#include "app/command_check.h"

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
bool is_sound(const std::filesystem::path& file) {
    try {
        std::vector<std::string> changes;
        const Family family = open_family(std::span(&file, 1), &changes);
        fmt::print("{}: sound, {}\n", shown_text(file.string()),
                   family.keys.size() == 1 ? "1 key" : fmt::format("{} keys", family.keys.size()));
        for (const std::string& change : changes) fmt::print("{}: {}\n", shown_text(file.string()), change);
        return true;
    } catch (const InputError& error) {
        print_error(error.what());
        return false;
    }
}

}  // namespace

bool run_check(std::span<const std::filesystem::path> files) {
    bool all_sound = true;
    for (const std::filesystem::path& file : files) all_sound = is_sound(file) && all_sound;
    return all_sound;
}

}  // namespace interleaf
