#include "app/cli/view_command.h"

#include <cstdlib>
#include <utility>

#include <fmt/core.h>

#include "app/document/open_family.h"
#include "app/fitting/fit_files.h"
#include "hierarchy/error.h"
#include "render/context.h"

namespace interleaf {

namespace {

/// What there is to show, and where it was read from.
struct Opened {
    Family family;
    std::vector<std::filesystem::path> sources;  ///< none for the built-in family
    std::vector<std::filesystem::path> meshes;   ///< to be fitted, over the built-in family
};

Opened open_to_view(const std::vector<std::filesystem::path>& paths) {
    if (paths.empty()) return {open_family({}), {}, {}};
    std::vector<std::filesystem::path> files = files_of(paths);
    if (are_surfaces(files)) return {open_family({}), {}, std::move(files)};
    try {
        return {open_family(files), files, {}};
    } catch (const InputError&) {
        if (files.size() < 2 || !are_obj_files(files)) throw;
        return {open_family({}), {}, std::move(files)};
    }
}

}  // namespace

void run_view(const ViewOptions& options) {
    Opened opened = open_to_view(options.family);
    try {
        run_viewer(std::move(opened.family), std::move(opened.sources), std::move(opened.meshes),
                   options.viewer);
    } catch (const DisplayError& error) {
        const bool has_display =
            std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
        throw MachineError(fmt::format("{}; to draw without a window: interleaf render --at 0.3,0.4 -o a.png",
                                       has_display ? error.what() : "there is no display"));
    }
}

}  // namespace interleaf
