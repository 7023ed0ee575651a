#include "app/cli/check_command.h"

#include <algorithm>
#include <new>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>

#include "app/cli/error_message.h"
#include "app/cli/mesh_figures.h"
#include "app/document/opening.h"
#include "hierarchy/error.h"
#include "text/shown_text.h"

namespace interleaf {
namespace {

/// A mesh is sound if a key can be fitted to it as it is.
CheckResult check_mesh(const std::filesystem::path& file) {
    const std::vector<std::string> faults = faults_of_mesh(file);
    for (const std::string& fault : faults) print_error(fmt::format("{}: {}", file.string(), fault));
    if (!faults.empty()) return CheckResult::at_fault;
    fmt::print("{}: sound, a mesh to fit a key to\n", shown_text(file.string()));
    return CheckResult::sound;
}

CheckResult check_meshes(std::span<const std::filesystem::path> files) {
    CheckResult result = CheckResult::sound;
    for (const std::filesystem::path& file : files) result = std::max(result, check_mesh(file));
    return result;
}

/// Checks any file. The readers check every invariant, so a file that can be read is sound.
CheckResult check(const std::filesystem::path& file) {
    try {
        Opening opened = open_files(std::span(&file, 1));
        if (const auto* meshes = std::get_if<MeshesToFit>(&opened);
            meshes != nullptr && meshes->reason.empty())
            return check_meshes(meshes->files);
        std::vector<std::string> changes;
        const Family family = family_of(std::move(opened), &changes);
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
