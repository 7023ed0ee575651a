// What the dialog before an import shows of a series, and what the user's choices in it mean.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "app/importing/series_import.h"
#include "ui/dialogs/import_dialog.h"

namespace interleaf {

/// The content of the dialog for the series of \p files, whose first step is read.
/// \throw InputError, MachineError  as series_files() and read_field_mesh()
ImportDialogShown import_offer(const std::vector<std::filesystem::path>& files);

/// What the dialog shows for \p choices. Fields that \p offer has not are dropped, and all are wanted if none is left.
ImportDialogChoices dialog_choices(const ImportChoices& choices, const ImportDialogShown& offer);

/// What is wrong with \p choices; "" if nothing is.
std::string fault_of(const ImportDialogChoices& choices, const ImportDialogShown& offer);

/// \pre fault_of() finds nothing
ImportChoices import_choices(const ImportDialogChoices& choices, const ImportDialogShown& offer);

}  // namespace interleaf
