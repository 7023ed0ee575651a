#include "app/command_view.h"

#include <cstdlib>

#include <fmt/core.h>

#include "app/open_family.h"
#include "render/context.h"

namespace interleaf {

void run_view(const ViewOptions& options) {
    Family family = open_family(options.family);
    try {
        run_viewer(std::move(family),
                   options.family.empty() ? std::vector<std::filesystem::path>() : files_of(options.family),
                   options.viewer);
    } catch (const DisplayError& error) {
        const bool has_display =
            std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
        throw MachineError(fmt::format("{}; to draw without a window: interleaf render --at 0.3,0.4 -o a.png",
                                       has_display ? error.what() : "there is no display"));
    }
}

}  // namespace interleaf
