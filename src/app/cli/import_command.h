// `interleaf import`: makes a family of a series of flat meshes, one file per time step.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/importing/series_import.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

struct ImportOptions {
    std::vector<std::filesystem::path>
        series;          ///< a list of steps (.pvd, .series), or files or patterns in their order
    std::string output;  ///< a folder
    ImportChoices choices;
    std::size_t every = 1;  ///< takes the steps 0, every, 2 every, ...
    bool json = false;      ///< prints the report as JSON
    HierarchyFileOptions form;
};

/// Writes the family. Prints on standard output how the hierarchies were found, and how each key compares with
/// its step.
/// \throw InputError, UsageError, MachineError
void run_import(const ImportOptions& options);

}  // namespace interleaf
