// What the Edit and Key menus do, and the panels where they let keys, times and domain vertices be dragged:
// each an undoable step of the document. What cannot be done becomes the message.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/document/viewer_state.h"

namespace interleaf {

using FamilyChange = std::function<Family(const Family&)>;

/// Makes what \p change gives the document's next state; \p step names it.
void edit(ViewerState& state, std::string step, const FamilyChange& change, double now);

/// The same for one movement of a drag: until end_drag() all of them are one step. What \p change refuses is
/// passed over, so that a drag can go through places where it would be invalid.
void drag_edit(ViewerState& state, std::string step, const FamilyChange& change, double now);
void end_drag(ViewerState& state);

void undo(ViewerState& state, double now);
void redo(ViewerState& state, double now);

/// The functions below that work on a key do so on the selected one, and nothing without one.

void keep_blend(ViewerState& state, double now);
/// \param origin  that the keys' positions count from (family/origin.h)
void add_keys(ViewerState& state, std::vector<Key> keys, const glm::dvec3& origin, double now);
void duplicate_key(ViewerState& state, double now);
void remove_key(ViewerState& state, double now);
void move_key(ViewerState& state, std::size_t to, double now);

/// Ask for a name, or a time, first.
void ask_for_key_name(ViewerState& state);
void ask_for_family_name(ViewerState& state);
void ask_for_new_time(ViewerState& state);
void ask_for_time(ViewerState& state, std::size_t place);

void add_time(ViewerState& state, std::size_t key, double time, double now);
void remove_time(ViewerState& state, std::size_t place, double now);

void make_domain(ViewerState& state, double now);
void add_domain_vertex(ViewerState& state, glm::dvec2 at, std::size_t key, double snap, double now);
void remove_domain_vertex(ViewerState& state, Index vertex, double now);
void set_domain_vertex_key(ViewerState& state, Index vertex, std::size_t key, double now);

/// Selects \p key and shows it alone.
void select_key(ViewerState& state, std::size_t key, double now);

}  // namespace interleaf
