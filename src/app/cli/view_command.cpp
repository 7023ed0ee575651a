#include "app/cli/view_command.h"

#include <cstdlib>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "app/document/opening.h"
#include "hierarchy/error.h"
#include "render/context.h"

namespace interleaf {

namespace {

/// Opens the window. For meshes, the window shows the built-in family and offers to fit the meshes.
void show(Opening opened, const std::vector<std::filesystem::path>& sources, const ViewerOptions& options) {
    std::visit(
        Cases{
            [&](OpenedFamily& family) { run_viewer(std::move(family.family), sources, {}, options); },
            [&](OpenedKeys& keys) { run_viewer(std::move(keys.family), sources, {}, options); },
            [&](MeshesToFit& meshes) { run_viewer(open_family({}), {}, std::move(meshes.files), options); }},
        opened);
}

}  // namespace

void run_view(const ViewOptions& options) {
    const std::vector<std::filesystem::path> files = files_of(options.family);
    Opening opened = open_files(files);
    try {
        show(std::move(opened), files, options.viewer);
    } catch (const DisplayError& error) {
        const bool has_display =
            std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
        throw MachineError(fmt::format("{}; to draw without a window: interleaf render --at 0.3,0.4 -o a.png",
                                       has_display ? error.what() : "there is no display"));
    }
}

}  // namespace interleaf
