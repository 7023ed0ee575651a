// The commands of the Edit and Key menus, and the drags of keys, times and domain vertices in the panels.
// Each is an undoable step of the document. A command that cannot be carried out sets the message.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/document/viewer_state.h"

namespace interleaf {

using FamilyChange = std::function<Family(const Family&)>;

/// Makes the result of \p change the document's next state. \p step names the edit.
void edit(ViewerState& state, std::string step, const FamilyChange& change, double now);

/// The same for one movement of a drag: all movements until end_drag() are one step. A movement that \p
/// change rejects has no effect, so a drag can pass through invalid places.
void drag_edit(ViewerState& state, std::string step, const FamilyChange& change, double now);
void end_drag(ViewerState& state);

/// Ends the drag and takes its step back, as if it had never been.
void cancel_drag(ViewerState& state, double now);

void undo(ViewerState& state, double now);
void redo(ViewerState& state, double now);

/// The functions below that work on a key work on the selected key, and do nothing without a selection.

void keep_blend(ViewerState& state, double now);
/// Adds the keys of \p added, which get the origin (family/origin.h) and the offsets of fields (family/field_scale.h)
/// of the document, and the landmarks of \p added that the document lacks.
void add_keys(ViewerState& state, const Family& added, double now);
void duplicate_key(ViewerState& state, double now);
void remove_key(ViewerState& state, double now);
void move_key(ViewerState& state, std::size_t to, double now);

/// These functions ask the user for a name or a time first.
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

/// Selects \p key and shows only this key.
void select_key(ViewerState& state, std::size_t key, double now);

}  // namespace interleaf
