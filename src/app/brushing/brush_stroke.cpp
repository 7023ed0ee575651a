#include "app/brushing/brush_stroke.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "app/document/edit_commands.h"
#include "family/warp.h"
#include "hierarchy/error.h"
#include "hierarchy/measure.h"
#include "ui/widgets/number_text.h"

namespace interleaf {

namespace {

/// The level above and below which half of the leaves are.
int median_level(const Hierarchy& key) {
    std::vector<Leaf> leaves = leaves_of(key);
    const auto middle = leaves.begin() + static_cast<std::ptrdiff_t>(leaves.size() / 2);
    std::ranges::nth_element(leaves, middle, {}, &Leaf::level);
    return middle->level;
}

std::string words_for(const BrushFigures& figures) {
    if (figures.leaves < figures.leaves_before)
        return grouped(figures.leaves_before - figures.leaves) + " fewer";
    std::string text = grouped(figures.leaves - figures.leaves_before) + " more";
    if (figures.by_closure > 0) text += fmt::format(", {} by closure", grouped(figures.by_closure));
    if (figures.is_full) text += fmt::format("; stopped at {} leaves", grouped(max_brushed_leaves));
    return text;
}

/// Whether a field may raise the shown key, whose surface is then not where its vertices are.
bool is_raised(const ViewerState& state) {
    const Display& display = state.session.display;
    if (display.height <= 0 || state.session.driver() != Driver::key) return false;
    const bool is_by_color = display.raised_by.empty() && display.coloring == Coloring::field;
    const std::string& name = is_by_color ? display.field : display.raised_by;
    const Hierarchy& key = *state.document.family().keys[state.session.weights().front().key].hierarchy;
    const auto raises = [&](const Field& field) {
        return field.kind == FieldKind::scalar && field.name == name;
    };
    return std::ranges::any_of(key.fields, raises) && flat_axis(bounding_box(key.positions));
}

}  // namespace

std::optional<std::size_t> brushed_key(const ViewerState& state) {
    const bool is_ready = state.brush.is_on && !state.is_comparing && state.session.driver() == Driver::key;
    if (!is_ready || !state.selected_key || is_raised(state)) return std::nullopt;
    return state.session.weights().front().key == *state.selected_key ? state.selected_key : std::nullopt;
}

const char* brush_hint(const ViewerState& state) {
    if (brushed_key(state)) return "";
    return is_raised(state) ? "Set Height to 0 to brush" : "Click a key in the list to brush it";
}

float brush_radius(const ViewerState& state, std::size_t key) {
    return state.brush.radius *
           bounding_box(state.document.family().keys[key].hierarchy->positions).diagonal();
}

void toggle_brush(ViewerState& state, double now) {
    Brush& brush = state.brush;
    brush.is_on = !brush.is_on;
    brush.report.clear();
    if (!brush.is_on) return;
    const Weights& weights = state.session.weights();
    select_key(state, state.selected_key.value_or(std::ranges::max_element(weights, {}, &Weight::value)->key),
               now);
    state.session.display.detail = 1;
    state.session.display.follows_camera = false;
    const int level = median_level(*state.document.family().keys[*state.selected_key].hierarchy);
    brush.refined_level = std::min(level + 2, max_brush_level);
    brush.coarsened_level = std::clamp(level - 2, 0, max_brush_level);
}

void BrushStroke::begin(ViewerState& state, bool coarsens) {
    const std::optional<std::size_t> key = brushed_key(state);
    if (!key) return;
    const SharedHierarchy hierarchy = state.document.family().keys[*key].hierarchy;
    if (state.comparisons.empty()) descendants_.clear();  // another document
    follow_surface(state, hierarchy);
    BrushedKey::PlaceVertex place;
    if (surface_ != nullptr)
        place = [surface = surface_.get()](const glm::vec3& middle, float length) {
            return surface->place(middle, length);
        };
    active_.reset(new Active{.key = *key,
                             .coarsens = coarsens,
                             .radius = brush_radius(state, *key),
                             .brushed = BrushedKey(*hierarchy, std::move(place)),
                             .family = state.document.snapshot(),
                             .shown_leaves = hierarchy->leaf_count()});
    state.brush.is_stroking = true;
    state.brush.wants_to_cancel = false;
    state.brush.report.clear();
}

/// Finds the mesh that \p key was fitted to, before or after strokes.
void BrushStroke::follow_surface(const ViewerState& state, const SharedHierarchy& key) {
    std::shared_ptr<const FitComparison> comparison;
    for (const auto& each : state.comparisons)
        if (each->key.is_same(key)) comparison = each;
    for (const Descendant& each : descendants_)
        if (each.key.is_same(key)) comparison = each.comparison;
    if (comparison == nullptr)
        surface_.reset();
    else if (surface_ == nullptr || surface_->comparison() != comparison)
        surface_ = std::make_unique<FittedSurface>(std::move(comparison));
}

bool BrushStroke::is_stale(const ViewerState& state) const {
    return active_->family != state.document.snapshot();
}

void BrushStroke::touch(ViewerState& state, std::span<const Ray> rays, bool shows, double now) {
    if (active_ == nullptr) return;
    if (is_stale(state)) return put_down(state);
    BrushedKey& brushed = active_->brushed;
    try {
        for (const Ray& ray : rays) {
            const std::optional<BrushTouch> touch = brushed.touch(ray, active_->radius);
            if (!touch) continue;
            if (active_->coarsens)
                brushed.coarsen(*touch, static_cast<unsigned>(std::max(state.brush.coarsened_level, 0)));
            else
                brushed.refine(*touch, static_cast<unsigned>(std::max(state.brush.refined_level, 0)));
        }
    } catch (const InputError& error) {
        state.message = message_of(error);
        return end(state, now);
    }
    if (shows) show(state, now);
}

/// Gives the document the present leaves, if they have changed since.
void BrushStroke::show(ViewerState& state, double now) {
    const std::size_t leaves = active_->brushed.figures().leaves;
    if (leaves == active_->shown_leaves) return;
    const std::size_t key = active_->key;
    const SharedHierarchy brushed(active_->brushed.freeze());
    const std::string& name = state.document.family().keys[key].name;
    drag_edit(
        state, fmt::format("{} {}", active_->coarsens ? "Coarsen" : "Refine", name),
        [&](const Family& family) {
            Family result = family;
            result.keys[key].hierarchy = brushed;
            return result;
        },
        now);
    active_->shown_leaves = leaves;
    active_->family = state.document.snapshot();
    report(state);
}

void BrushStroke::report(ViewerState& state) const {
    const BrushFigures& figures = active_->brushed.figures();
    state.brush.report =
        fmt::format("{}: {} to {} leaves ({})", state.document.family().keys[active_->key].name,
                    grouped(figures.leaves_before), grouped(figures.leaves), words_for(figures));
}

void BrushStroke::end(ViewerState& state, double now) {
    if (active_ == nullptr) return;
    if (!is_stale(state)) {
        show(state, now);
        const BrushFigures& figures = active_->brushed.figures();
        if (surface_ != nullptr)
            descendants_.push_back(
                {state.document.family().keys[active_->key].hierarchy, surface_->comparison()});
        if (figures.leaves == figures.leaves_before)
            state.brush.report =
                active_->coarsens ? "Nothing to coarsen here: no vertex is surrounded by finer leaves alone"
                                  : "Nothing to refine here: all leaves have this level";
    }
    end_drag(state);
    put_down(state);
}

void BrushStroke::cancel(ViewerState& state, double now) {
    if (active_ == nullptr) return;
    if (!is_stale(state)) cancel_drag(state, now);
    put_down(state);
    state.brush.report = "Stroke taken back";
}

void BrushStroke::put_down(ViewerState& state) {
    active_.reset();
    state.brush.is_stroking = false;
    state.brush.wants_to_cancel = false;
}

}  // namespace interleaf
