// Why a command is not possible now, in a few words for the command palette.
#include "app/window/commands.h"

namespace interleaf {

namespace {

std::string_view obstacle_of_document(CommandId id, const ViewerState& state) {
    using enum CommandId;
    switch (id) {
        case undo:
            return "nothing to undo";
        case redo:
            return "nothing to redo";
        case edit_domain:
        case put_in_domain:
        case record_path:
        case go_to_place:
        case use_arrows_in_domain:
        case drive_by_domain:
            return "the family has no parameter domain";
        case take_out_of_domain:
            return "the domain does not have the key";
        case set_field_unit:
            return "color by a scalar field first";
        case set_time_unit:
            return "the family has no timeline";
        case set_landmarks:
            return "no meshes have been fitted";
        case follow_path:
        case smooth_path:
        case remove_path:
            return "the family has no path";
        case compare_with_mesh:
            return "no key has been fitted to a mesh here";
        case show_all_times:
            return "all times are shown";
        case show_whole_domain:
            return "the whole domain is shown";
        case remove_present_time:
            return "there is no key at the present time";
        case go_to_parent:
        case go_to_sibling:
        case go_to_first_child:
        case go_to_second_child:
        case cross_refinement_edge:
        case cross_second_edge:
        case cross_third_edge:
            return "no triangle is inspected";
        case sum_to_one:
            return "the weights sum to 1, or to 0";
        case reset_weights:
            return "no slider has moved";
        default:
            break;
    }
    if (!state.session.has_time()) return "the family has no timeline";
    switch (id) {
        case play_all:
            return "the whole timeline is played";
        case next_interpolation:
        case bernstein_pieces:
            return "a path drives";
        default:
            return "not in this state";
    }
}

}  // namespace

std::string_view obstacle_of(const Command& command, const ViewerState& state) {
    if (is_enabled(command, state)) return {};
    if (command.scope != CommandScope::window && state.is_comparing)
        return "close the comparison first (Esc)";
    if (command.scope == CommandScope::selected_key && !state.selected_key) return "select a key first";
    return obstacle_of_document(command.id, state);
}

}  // namespace interleaf
