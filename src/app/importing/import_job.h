// Imports a series as work for a separate thread, so that the window goes on.
#pragma once

#include <filesystem>
#include <vector>

#include "app/importing/series_import.h"
#include "app/work/background_job.h"

namespace interleaf {

/// The import of \p files as one family, named after the first file. It throws what series_files() and import_series()
/// throw, and Cancelled.
/// \param files  as series_files()
BackgroundJob<ImportedSeries>::Work import_work(std::vector<std::filesystem::path> files,
                                                ImportChoices choices);

}  // namespace interleaf
