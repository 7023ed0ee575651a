#include "app/cli/view_command.h"

#include <cstdlib>
#include <utility>
#include <variant>

#include <fmt/core.h>

#include "app/cli/morph_selection.h"
#include "app/document/opening.h"
#include "app/document/shown_field.h"
#include "family/family_fields.h"
#include "family/family_time.h"
#include "hierarchy/error.h"
#include "render/context.h"
#include "sequence/series/series.h"

namespace interleaf {

namespace {

/// Whether an option needs the keys of the series when the window opens.
bool needs_keys(const ViewerOptions& options) {
    return options.at || options.time || options.along || options.picture ||
           options.display.coloring != Coloring::plain || options.display.height > 0 ||
           options.display.arrows;
}

/// Opens the window on the keys of a series, colored by their field unless the display says otherwise. The window
/// imports the series itself, over the built-in family, unless an option needs the keys; likewise where the series
/// needs a tolerance, for which the window asks.
void show_series(const SeriesToImport& series, const ViewOptions& view) {
    ViewerOptions options = view.viewer;
    if (!needs_keys(options)) return run_viewer(open_family({}), {}, series.files, options);
    OpenedKeys keys;
    try {
        keys = import_steps(series);
    } catch (const NeedsTolerance&) {
        // The options mean the series, not the built-in family.
        if (options.display.coloring == Coloring::field) options.display.coloring = Coloring::plain;
        options.display.raised_by.clear();
        options.display.height = 0;
        options.display.arrows = false;
        options.display.arrow_parts = {};
        options.at.reset();
        options.time.reset();
        options.along.reset();
        run_viewer(open_family({}), {}, series.files, options);
        return;
    }
    if (options.display.coloring == Coloring::plain) color_by_field(options.display, fields_of(keys.family));
    if (options.along) require_source(keys.family, *options.along);
    run_viewer(std::move(keys.family), series.files, {}, options);
}

/// Opens the window. For meshes, the window shows the built-in family and offers to fit the meshes.
/// \param opened  is emptied
void show(Opening& opened, const std::vector<std::filesystem::path>& sources, const ViewOptions& view) {
    const auto run = [&view](Family family, const std::vector<std::filesystem::path>& from,
                             std::vector<std::filesystem::path> meshes) {
        if (view.viewer.along) require_source(family, *view.viewer.along);
        run_viewer(std::move(family), from, std::move(meshes), view.viewer);
    };
    std::visit(Cases{[&](OpenedFamily& family) { run(std::move(family.family), sources, {}); },
                     [&](OpenedKeys& keys) { run(std::move(keys.family), sources, {}); },
                     [&](MeshesToFit& meshes) { run(open_family({}), {}, std::move(meshes.files)); },
                     [&](const SeriesToImport& series) { show_series(series, view); }},
               opened);
}

}  // namespace

void run_view(const ViewOptions& options) {
    const std::vector<std::filesystem::path> files = files_of(options.family);
    Opening opened = open_files(files);
    try {
        show(opened, files, options);
    } catch (const DisplayError& error) {
        const bool has_display =
            std::getenv("DISPLAY") != nullptr || std::getenv("WAYLAND_DISPLAY") != nullptr;
        throw MachineError(fmt::format("{}; to draw without a window: interleaf render --at 0.3,0.4 -o a.png",
                                       has_display ? error.what() : "there is no display"));
    }
}

}  // namespace interleaf
