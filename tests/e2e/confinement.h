// Keeps a program that is driven at random from changing anything on this machine but what is made for it.
#pragma once

#include <filesystem>
#include <span>

namespace interleaf {

/// Whether confine_writes() works on this machine: Linux 5.13 or later, with Landlock.
bool can_confine_writes();

/// From now on this process and its children can write, make, rename and remove files only in \p folders, and
/// write to \p files, which exist. Reading stays as it was. Nothing takes this back.
/// \return whether it is so; between fork() and exec(), no exception would get far
bool confine_writes(std::span<const std::filesystem::path> folders,
                    std::span<const std::filesystem::path> files);

}  // namespace interleaf
