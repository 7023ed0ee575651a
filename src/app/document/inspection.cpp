#include "app/document/inspection.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

#include "render/palette.h"

namespace interleaf {

void Inspection::follow(ViewerState& state, const TurnedCorners& turned) {
    const std::optional<NodeStep> step = std::exchange(state.node_step, std::nullopt);
    const RootComplex& roots = state.document.family().keys.front().hierarchy->roots;
    if (roots_ && roots_ != roots) state.inspected.reset();
    if (state.inspected && state.inspected->root >= roots.triangle_count()) state.inspected.reset();
    roots_ = roots;
    if (!state.inspected) {
        keys_.clear();
        subject_.reset();
        shown_.reset();
        return;
    }
    const Session& session = state.session;
    index_active_keys(session);
    const std::vector<const NodeIndex*> indices = indices_of(session);
    if (step)
        if (const auto node = stepped(indices, *state.inspected, *step)) state.inspected = node;
    const bool is_turning = turned && turns(session.family().blend, session.weights().size());
    Subject subject{*state.inspected, session.weights(), state.document.snapshot(), is_turning};
    if (subject_ == subject) return;

    const NodePath& node = subject.node;
    InspectedNode shown{
        .node = node, .state = union_state(indices, node), .blend = {}, .keys = {}, .steps = {}};
    for (const NodeStep each : all_node_steps)
        shown.steps.at(static_cast<std::size_t>(each)) = stepped(indices, node, each);
    for (const Weight& weight : session.weights()) {
        shown.keys.push_back(inspected_key(session.family().keys[weight.key], weight.key, node));
        for (std::size_t corner = 0; corner < 3; ++corner)
            shown.blend.at(corner) += static_cast<float>(weight.value) * shown.keys.back().corners.at(corner);
    }
    const auto corners = is_turning ? turned(node) : std::nullopt;
    if (corners)
        shown.blend = *corners;
    else if (is_turning && shown_ && shown_->node == node)
        shown.blend = shown_->blend;
    shown.is_at_left = shown_ && shown_->node == node && shown_->is_at_left;
    shown_ = std::move(shown);
    if (is_turning && !corners)
        subject_.reset();  // asks again in the next frame
    else
        subject_ = std::move(subject);
}

/// Keeps the indices of the active keys, makes those that are missing, and drops all others.
void Inspection::index_active_keys(const Session& session) {
    std::vector<IndexedKey> keys;
    keys.reserve(session.weights().size());
    for (const Weight& weight : session.weights()) {
        const SharedHierarchy& hierarchy = session.family().keys[weight.key].hierarchy;
        const auto is_same = [&](const IndexedKey& key) { return key.hierarchy.is_same(hierarchy); };
        if (std::ranges::any_of(keys, is_same)) continue;
        const auto known = std::ranges::find_if(keys_, is_same);
        keys.push_back(known != keys_.end() ? std::move(*known)
                                            : IndexedKey{hierarchy, NodeIndex(*hierarchy)});
    }
    keys_ = std::move(keys);
}

std::vector<const NodeIndex*> Inspection::indices_of(const Session& session) const {
    std::vector<const NodeIndex*> indices;
    indices.reserve(session.weights().size());
    for (const Weight& weight : session.weights())
        indices.push_back(&indexed(session.family().keys[weight.key].hierarchy).index);
    return indices;
}

/// \pre index_active_keys() has been called with \p hierarchy among the active keys
const Inspection::IndexedKey& Inspection::indexed(const SharedHierarchy& hierarchy) const {
    return *std::ranges::find_if(keys_,
                                 [&](const IndexedKey& key) { return key.hierarchy.is_same(hierarchy); });
}

/// \param number  of the key in its family
InspectedKey Inspection::inspected_key(const Key& key, std::size_t number, const NodePath& node) const {
    const NodeIndex& index = indexed(key.hierarchy).index;
    const LeafRange leaves = index.leaves(node);
    InspectedKey shown{.name = key.name,
                       .color = key_color(number),
                       .state = index.state(node),
                       .leaf_level = index.level(leaves.begin),
                       .leaf_count = leaves.count(),
                       .corners = {},
                       .vertices = {}};
    const std::array<SurfacePoint, 3> corners = index.corners(node);
    for (std::size_t corner = 0; corner < 3; ++corner) {
        shown.corners.at(corner) = surface_position(corners.at(corner), key.hierarchy->positions);
        shown.vertices.at(corner) = vertex_at(corners.at(corner));
    }
    return shown;
}

}  // namespace interleaf
