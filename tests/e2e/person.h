// What a user knows about the window: the places of its parts, and the content of the document.
#pragma once

#include <filesystem>
#include <string>

#include "e2e/running_viewer.h"
#include <glm/vec2.hpp>

namespace interleaf {

/// A file of the built-in family.
std::filesystem::path builtin_file(const std::string& name);

/// The pixel in the middle of the view.
glm::vec2 view_middle(const RunningViewer::State& state);

/// The pixel in the middle of a key's row in the list.
/// \pre the list is not scrolled
glm::vec2 row_pixel(const RunningViewer::State& state, std::size_t key);

/// The pixels of \p time on the timeline's track, and of the name below it.
glm::vec2 track_pixel(const RunningViewer::State& state, double time);
glm::vec2 time_name_pixel(const RunningViewer::State& state, double time);

/// The pixel of a point of the domain.
glm::vec2 domain_pixel(const RunningViewer::State& state, glm::vec2 point);

/// The saved part of the document: its name, keys, times and domain.
RunningViewer::State family_of(const RunningViewer::State& state);

RunningViewer::State wait_for_keys(const RunningViewer& viewer, std::size_t count);

/// Waits until a question or the file browser is open, or until none is.
void wait_for_question(const RunningViewer& viewer);
void wait_for_no_question(const RunningViewer& viewer);

/// Clicks an entry of the menu that is opening.
/// \param count  number of lines of the menu, which have about the same height
void choose_in_menu(const RunningViewer& viewer, std::size_t entry, std::size_t count);

}  // namespace interleaf
