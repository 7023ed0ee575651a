// The rows of the table of commands, menu by menu. commands() in commands.h puts them together.
#pragma once

#include <span>

#include "app/window/commands.h"

namespace interleaf {

std::span<const Command> document_commands();
std::span<const Command> playback_commands();
std::span<const Command> inspect_commands();
std::span<const Command> blend_commands();
std::span<const Command> camera_commands();
std::span<const Command> view_commands();
std::span<const Command> appearance_commands();
std::span<const Command> help_commands();

}  // namespace interleaf
