#include "app/landmarks/landmark_editing.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "ui/widgets/style.h"

namespace interleaf {
namespace {

/// A proposal this near to a landmark, in radii of the body's ball, is taken.
constexpr double taken_within = 0.06;

/// From this way on the sphere on, as a chord, a landmark has the color of a far one.
constexpr double far_way = 0.7;

constexpr glm::vec3 near_color{0.45F, 0.84F, 0.55F};
constexpr glm::vec3 far_color{0.95F, 0.36F, 0.30F};

bool are_same(const std::vector<Landmark>& a, const std::vector<Landmark>& b) {
    return std::ranges::equal(a, b, [](const Landmark& left, const Landmark& right) {
        return left.name == right.name && left.position == right.position &&
               left.direction == right.direction;
    });
}

}  // namespace

void LandmarkEditing::open(Task task) {
    task_ = std::move(task);
    history_ = LandmarkHistory(task_.points);
    selected_.reset();
    other_ = task_.other;
    side_ = 0;
    chosen_proposal_.reset();
    done_.reset();
    files_.clear_fault();
    sides_ = {};
    blend_ = {};
    bodies_ = {};
    wished_mesh_ = 0;
    preview_ = std::make_unique<LandmarkPreview>(task_.sources, task_.roots);
    dialog_.open();
    select_unpaired();
    wish_blend();
}

bool LandmarkEditing::is_working() const {
    return dialog_.is_open() && preview_->is_working();
}

void LandmarkEditing::show(const Rect& area) {
    if (!dialog_.is_open()) return;
    if (files_.is_asking()) return files_.show(area);
    LandmarkDialogResult done = dialog_.show(area, shown());
    if (done.is_any()) done_ = std::move(done);
}

std::optional<LandmarkPoints> LandmarkEditing::update(float density) {
    std::erase_if(leaving_, [](const auto& preview) { return preview->is_over(); });
    if (!preview_) return std::nullopt;
    std::optional<bool> closes;
    if (auto changed = files_.update(points(), task_.sources.size())) {
        history_.push(*std::move(changed));
        selected_.reset();
        select_unpaired();
    }
    if (const auto done = std::exchange(done_, std::nullopt)) {
        closes = done->closes;
        if (!closes) apply(*done);
    }
    if (!closes) {
        follow_work(density);
        return std::nullopt;
    }
    preview_->stop();
    leaving_.push_back(std::move(preview_));
    sides_ = {};
    blend_ = {};
    return *closes ? std::optional(history_.points()) : std::nullopt;
}

// ---- places ----

glm::dvec3 LandmarkEditing::shown_place(std::size_t mesh, const glm::dvec3& place) const {
    std::vector<glm::dvec3> one{place};
    turn_up(one, task_.sources[mesh].up);
    return one.front();
}

glm::dvec3 LandmarkEditing::file_place(std::size_t mesh, const glm::dvec3& place) const {
    std::vector<glm::dvec3> one{place};
    turn_back(one, task_.sources[mesh].up);
    return one.front();
}

/// The landmarks that the first mesh and the other one have, turned so that y is up.
std::vector<Landmark> LandmarkEditing::shown_landmarks(std::size_t mesh) const {
    std::vector<Landmark> landmarks;
    for (const LandmarkPoint& point : points())
        if (is_paired(point, other_))
            landmarks.push_back({point.name, shown_place(mesh, *point.places[mesh]),
                                 mesh == 0 ? point.direction : std::nullopt});
    return landmarks;
}

/// The proposals at which no landmark is yet.
std::vector<glm::dvec3> LandmarkEditing::free_proposals(std::size_t side) const {
    std::vector<glm::dvec3> proposals;
    if (!bodies_[side] || !sides_[side].has_mesh()) return proposals;
    const std::size_t mesh = mesh_of(side);
    const double reach = taken_within * ball_of(bodies_[side]->mesh).radius;
    for (const glm::dvec3& proposal : bodies_[side]->proposals)
        if (std::ranges::none_of(points(), [&](const LandmarkPoint& point) {
                return point.places[mesh] &&
                       glm::distance(shown_place(mesh, *point.places[mesh]), proposal) < reach;
            }))
            proposals.push_back(proposal);
    return proposals;
}

// ---- what is shown ----

/// The last blend, if it is one of the two shown meshes; else null.
std::shared_ptr<const LandmarkBlend> LandmarkEditing::present_blend() const {
    auto blend = preview_ ? preview_->blend() : nullptr;
    return blend && blend->mesh == other_ ? blend : nullptr;
}

bool LandmarkEditing::has_blend() const {
    const auto blend = present_blend();
    return blend && blend->first_key && !preview_->is_working();
}

/// A color per landmark: by how far it had to come on the sphere, in amber if it has no partner.
std::vector<ImU32> LandmarkEditing::mark_colors() const {
    const auto blend = present_blend();
    std::vector<ImU32> colors;
    colors.reserve(points().size());
    for (const LandmarkPoint& point : points()) {
        if (!is_paired(point, other_)) {
            colors.push_back(colors::notice);
            continue;
        }
        ImU32 color = colors::accent;
        if (blend) {
            const auto found = std::ranges::find(blend->other, point.name, &Landmark::name);
            const auto k = static_cast<std::size_t>(found - blend->other.begin());
            if (k < blend->ways.size())
                color = to_color(glm::mix(near_color, far_color,
                                          static_cast<float>(std::min(blend->ways[k] / far_way, 1.0))));
        }
        colors.push_back(color);
    }
    return colors;
}

LandmarkPictureShown LandmarkEditing::side_shown(std::size_t side, const std::vector<ImU32>& colors) const {
    const std::size_t mesh = mesh_of(side);
    const LandmarkSurface& surface = sides_[side];
    LandmarkPictureShown picture{.title = task_.names[mesh],
                                 .remark = "reading",
                                 .texture = surface.texture(),
                                 .marks = {},
                                 .proposals = {}};
    if (bodies_[side]) picture.remark = bodies_[side]->fault;
    if (!surface.has_mesh()) return picture;
    for (std::size_t k = 0; k < points().size(); ++k) {
        const LandmarkPoint& point = points()[k];
        if (!point.places[mesh]) continue;
        const auto [place, is_hidden] = surface.project(shown_place(mesh, *point.places[mesh]));
        picture.marks.push_back({.place = place,
                                 .text = fmt::format("{}", k + 1),
                                 .color = colors[k],
                                 .index = k,
                                 .is_selected = selected_ == k,
                                 .glows = !is_paired(point, other_),
                                 .is_hidden = is_hidden});
    }
    for (const glm::dvec3& proposal : free_proposals(side)) {
        const auto [place, is_hidden] = surface.project(proposal);
        const bool is_chosen = side == side_ && chosen_proposal_ == proposal;
        if (is_hidden && !is_chosen) continue;
        if (is_chosen) picture.chosen_proposal = picture.proposals.size();
        picture.proposals.push_back(place);
    }
    return picture;
}

LandmarkDialogShown LandmarkEditing::shown() const {
    const std::vector<ImU32> colors = mark_colors();
    const auto blend = present_blend();
    LandmarkDialogShown shown{
        .sides = {side_shown(0, colors), side_shown(1, colors)},
        .blend = {.title = "Blend", .remark = {}, .texture = blend_.texture(), .marks = {}, .proposals = {}},
        .others = {task_.names.begin() + 1, task_.names.end()},
        .other = other_ - 1,
        .rows = {},
        .selected = selected_,
        .name_fault = {},
        .warnings = {},
        .can_undo = history_.can_undo(),
        .can_redo = history_.can_redo(),
        .can_swap = shown_landmarks(0).size() > 2,
        .can_save = {}};
    for (std::size_t side = 0; side < 2; ++side)
        shown.can_save[side] = !landmarks_on(points(), mesh_of(side)).empty();
    if (preview_ && preview_->is_working())
        shown.blend.remark = blend ? "remaking" : "working";
    else if (blend)
        shown.blend.remark =
            blend->fault.empty() ? fmt::format("made in {:.1f} s", blend->seconds) : "no blend";
    if (selected_) shown.name_fault = fault_of_name(points(), *selected_, dialog_.typed_name());
    for (std::size_t k = 0; k < points().size(); ++k) {
        const LandmarkPoint& point = points()[k];
        LandmarkRow row{.name = point.name, .state = {}, .color = colors[k]};
        if (!is_paired(point, other_))
            row.state = point.places[0]        ? fmt::format("not on {}", task_.names[other_])
                        : point.places[other_] ? fmt::format("not on {}", task_.names[0])
                                               : "on neither";
        shown.rows.push_back(std::move(row));
    }
    if (!files_.fault().empty()) shown.warnings.push_back(files_.fault());
    if (blend && !blend->fault.empty()) shown.warnings.push_back(blend->fault);
    if (blend) shown.warnings.insert(shown.warnings.end(), blend->warnings.begin(), blend->warnings.end());
    return shown;
}

// ---- what the person did ----

void LandmarkEditing::add(std::size_t side, const glm::dvec3& place) {
    LandmarkPoints changed = points();
    const std::size_t mesh = mesh_of(side);
    selected_ = add_place(changed, task_.sources.size(), mesh, file_place(mesh, place), selected_);
    history_.push(std::move(changed));
    if (is_paired(points()[*selected_], other_)) select_unpaired();
}

/// Selects the first landmark of the first mesh that has no partner yet, so that the next click gives it one.
void LandmarkEditing::select_unpaired() {
    const auto lacks_partner = [&](const LandmarkPoint& point) {
        return point.places[0].has_value() && !point.places[other_];
    };
    const auto next = std::ranges::find_if(points(), lacks_partner);
    if (next != points().end()) selected_ = static_cast<std::size_t>(next - points().begin());
}

void LandmarkEditing::apply_to_side(std::size_t side, const LandmarkPictureInput& input) {
    LandmarkSurface& surface = sides_[side];
    const std::size_t mesh = mesh_of(side);
    if (input.is_any()) side_ = side;
    for (std::size_t each = 0; each < 2; ++each)
        if (each == side || dialog_.turns_together()) sides_[each].camera.orbit(input.orbit);
    surface.camera.pan(input.pan);
    if (input.zoom != 1) surface.zoom(input.zoom, input.pointer);
    if (input.selected) selected_ = input.selected;
    if (input.proposal) {
        std::vector<glm::dvec3> visible;
        for (const glm::dvec3& proposal : free_proposals(side))
            if (!surface.project(proposal).is_hidden || (side == side_ && chosen_proposal_ == proposal))
                visible.push_back(proposal);
        if (*input.proposal < visible.size()) add(side, visible[*input.proposal]);
    }
    const auto pointed_at = [&] { return surface.point_at(input.pointer); };
    if (input.is_clicked)
        if (const auto place = pointed_at()) add(side, *place);
    if (!input.dragged || *input.dragged >= points().size()) return;
    if (mesh == 0 && points()[*input.dragged].direction) return;
    if (input.drag_begins) has_dragged_ = false;
    if (const auto place = pointed_at()) {
        LandmarkPoints changed = points();
        changed[*input.dragged].places[mesh] = file_place(mesh, *place);
        if (std::exchange(has_dragged_, true))
            history_.amend(std::move(changed));
        else
            history_.push(std::move(changed));
    }
}

void LandmarkEditing::step_proposal(int by) {
    const std::vector<glm::dvec3> proposals = free_proposals(side_);
    if (proposals.empty()) {
        chosen_proposal_.reset();
        return;
    }
    const auto found = chosen_proposal_ ? std::ranges::find(proposals, *chosen_proposal_) : proposals.end();
    const auto count = static_cast<int>(proposals.size());
    int next = by > 0 ? 0 : count - 1;
    if (found != proposals.end()) next = (static_cast<int>(found - proposals.begin()) + by + count) % count;
    chosen_proposal_ = proposals[static_cast<std::size_t>(next)];
}

void LandmarkEditing::apply(const LandmarkDialogResult& done) {
    files_.clear_fault();
    if (done.loads) return files_.ask_to_load(file_mesh(*done.loads));
    if (done.saves) return files_.ask_to_save(file_mesh(*done.saves));
    for (std::size_t side = 0; side < 2; ++side) apply_to_side(side, done.sides[side]);
    blend_.camera.orbit(done.blend.orbit);
    blend_.camera.pan(done.blend.pan);
    if (done.blend.zoom != 1) blend_.zoom(done.blend.zoom, done.blend.pointer);
    if (done.selected) selected_ = done.selected;
    if (done.side) {
        side_ = *done.side;
        chosen_proposal_.reset();
    }
    if (done.other) {
        other_ = *done.other + 1;
        sides_[1] = {};
        blend_ = {};  // the next blend is framed anew
        bodies_[1] = nullptr;
        chosen_proposal_.reset();
    }
    if (done.steps_proposal != 0) step_proposal(done.steps_proposal);
    if (done.accepts_proposal) {
        if (!chosen_proposal_) step_proposal(1);
        if (const auto proposal = std::exchange(chosen_proposal_, std::nullopt)) add(side_, *proposal);
    }
    LandmarkPoints changed = points();
    if (done.name && selected_) changed[*selected_].name = *done.name;
    // The next step of a drag is then a change of its own.
    if (done.removes || done.undoes || done.redoes) has_dragged_ = false;
    if (done.removes && selected_) {
        changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(*selected_));
        selected_.reset();
    }
    if (done.swaps) swap_sides(changed, other_);
    history_.push(std::move(changed));
    if (done.undoes) history_.undo();
    if (done.redoes) history_.redo();
    if (selected_ && *selected_ >= points().size()) selected_.reset();
}

// ---- the work ----

/// Asks for a blend of the present landmarks, unless the last wish was for the same.
void LandmarkEditing::wish_blend() {
    std::vector<Landmark> first = shown_landmarks(0);
    std::vector<Landmark> other = shown_landmarks(other_);
    if (wished_mesh_ == other_ && are_same(first, wished_first_) && are_same(other, wished_other_)) return;
    wished_mesh_ = other_;
    wished_first_ = first;
    wished_other_ = other;
    preview_->wish(other_, std::move(first), std::move(other));
}

/// Takes over what the thread has made, and draws the pictures.
void LandmarkEditing::follow_work(float density) {
    wish_blend();
    for (std::size_t side = 0; side < 2; ++side) {
        bodies_[side] = preview_->body(mesh_of(side));
        if (!bodies_[side] || !bodies_[side]->fault.empty() || sides_[side].has_mesh()) continue;
        sides_[side].set_mesh({bodies_[side], &bodies_[side]->mesh});
    }
    const auto blend = present_blend();
    const bool has_blend = blend && blend->first_key && sides_[0].has_mesh() && sides_[1].has_mesh();
    const bool has_checker = dialog_.has_checker() && has_blend;
    const auto pixels = [&](glm::vec2 size) { return glm::ivec2(glm::round(size * density)); };
    for (std::size_t side = 0; side < 2; ++side) {
        if (!sides_[side].has_mesh()) continue;
        if (has_checker)
            sides_[side].show_keys({side == 0 ? blend->first_key : blend->other_key}, sides_[side].ball());
        else
            sides_[side].show_mesh();
        sides_[side].draw(pixels(dialog_.side_size()), {1},
                          has_checker ? Coloring::checker : Coloring::plain);
    }
    if (!has_blend) return;
    blend_.show_keys({blend->first_key, blend->placed_key}, sides_[0].ball());
    blend_.draw(pixels(dialog_.blend_size()), {1 - dialog_.blend(), dialog_.blend()},
                dialog_.has_checker() ? Coloring::checker : Coloring::plain);
}

}  // namespace interleaf
