#include "app/importing/import_job.h"

#include <string_view>
#include <utility>

#include "hierarchy/progress.h"
#include "io/series_files.h"

namespace interleaf {

BackgroundJob<ImportedSeries>::Work import_work(std::vector<std::filesystem::path> files,
                                                ImportChoices choices) {
    return [files = std::move(files), choices = std::move(choices)](const Progress& progress) {
        return import_series(every_step(series_files(files), choices.every), series_name(files.front()),
                             choices, [&](std::string_view stage, double part) {
                                 if (!progress(stage, part)) throw Cancelled();
                             });
    };
}

}  // namespace interleaf
