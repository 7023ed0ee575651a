// Prevents a program that gets random input from changing files of this machine that are not made for it.
#pragma once

#include <filesystem>
#include <span>

namespace interleaf {

/// Whether confine_writes() works on this machine: Linux 5.13 or later, with Landlock.
bool can_confine_writes();

/// From now on, this process and its children can write, create, rename and remove files only in \p folders,
/// and write to \p files, which must exist. They can still read everything. Nothing can undo this.
/// \return whether the confinement holds; not an exception, because none would get far between fork() and
///     exec()
bool confine_writes(std::span<const std::filesystem::path> folders,
                    std::span<const std::filesystem::path> files);

}  // namespace interleaf
