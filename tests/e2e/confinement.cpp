#include "e2e/confinement.h"

#include <cstdint>

#include <fcntl.h>
#include <linux/landlock.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace interleaf {

namespace {

// Rights of newer kernels, which the headers may lack.
constexpr std::uint64_t refer = 1ULL << 13;      // since version 2
constexpr std::uint64_t truncate_ = 1ULL << 14;  // since version 3

constexpr std::uint64_t first_rights = LANDLOCK_ACCESS_FS_WRITE_FILE | LANDLOCK_ACCESS_FS_REMOVE_DIR |
                                       LANDLOCK_ACCESS_FS_REMOVE_FILE | LANDLOCK_ACCESS_FS_MAKE_CHAR |
                                       LANDLOCK_ACCESS_FS_MAKE_DIR | LANDLOCK_ACCESS_FS_MAKE_REG |
                                       LANDLOCK_ACCESS_FS_MAKE_SOCK | LANDLOCK_ACCESS_FS_MAKE_FIFO |
                                       LANDLOCK_ACCESS_FS_MAKE_BLOCK | LANDLOCK_ACCESS_FS_MAKE_SYM;

long version() {
    return syscall(SYS_landlock_create_ruleset, nullptr, 0, LANDLOCK_CREATE_RULESET_VERSION);
}

bool allow(int rules, const std::filesystem::path& path, std::uint64_t rights) {
    landlock_path_beneath_attr rule{};
    rule.allowed_access = rights;
    rule.parent_fd = open(path.c_str(), O_PATH | O_CLOEXEC);
    if (rule.parent_fd < 0) return false;
    const long result = syscall(SYS_landlock_add_rule, rules, LANDLOCK_RULE_PATH_BENEATH, &rule, 0);
    close(rule.parent_fd);
    return result == 0;
}

}  // namespace

bool can_confine_writes() {
    return version() >= 1;
}

bool confine_writes(std::span<const std::filesystem::path> folders,
                    std::span<const std::filesystem::path> files) {
    std::uint64_t rights = first_rights;
    if (version() >= 2) rights |= refer;
    if (version() >= 3) rights |= truncate_;
    landlock_ruleset_attr handled{};
    handled.handled_access_fs = rights;
    const auto rules =
        static_cast<int>(syscall(SYS_landlock_create_ruleset, &handled, sizeof handled.handled_access_fs, 0));
    if (rules < 0) return false;
    bool is_done = true;
    for (const std::filesystem::path& folder : folders) is_done = allow(rules, folder, rights) && is_done;
    const std::uint64_t file_rights = rights & (LANDLOCK_ACCESS_FS_WRITE_FILE | truncate_);
    for (const std::filesystem::path& file : files) is_done = allow(rules, file, file_rights) && is_done;
    is_done = is_done && prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) == 0 &&
              syscall(SYS_landlock_restrict_self, rules, 0) == 0;
    close(rules);
    return is_done;
}

}  // namespace interleaf
