// The inspector: what the hierarchies of the active keys have at one node, and steps to other nodes.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "hierarchy/nodes/node_index.h"
#include "hierarchy/nodes/node_path.h"
#include "hierarchy/nodes/node_steps.h"
#include "hierarchy/triangle.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// What an active key has at the node.
struct InspectedKey {
    std::string name;
    glm::vec3 color;  ///< of the key, sRGB-encoded
    NodeState state;
    unsigned leaf_level;               ///< of the leaf that the node is or lies in
    std::size_t leaf_count;            ///< leaves that the node consists of
    std::array<glm::vec3, 3> corners;  ///< positions of the node's corners
    std::array<Index, 3> vertices;     ///< of the key; no_index for a corner that is none
};

struct InspectedNode {
    NodePath node;
    NodeState state;                 ///< in the union of the active keys
    std::array<glm::vec3, 3> blend;  ///< positions of the corners in the blend
    std::vector<InspectedKey> keys;  ///< the active keys
    std::array<std::optional<NodePath>, all_node_steps.size()> steps;  ///< by NodeStep: where it leads
    bool is_at_left = false;  ///< of the view, where the inspector usually is
};

struct InspectorResult {
    std::optional<NodeStep> step;
    bool is_over = false;
};

/// Shows the inspector over the upper left corner of \p view, or over the lower right one if the node is at the left.
/// \param shortcuts  by NodeStep: the keys that do the same
InspectorResult inspector_panel(const InspectedNode& shown, std::span<const std::string> shortcuts,
                                const Rect& view);

/// Whether \p place, in the window, is in the part of \p view where the inspector usually is.
bool is_at_left(glm::vec2 place, const Rect& view);

/// The path of \p node as digits, the first bisection first, in groups of four; "–" for a root.
std::string path_text(const NodePath& node);

/// \p value, which is a multiple of a power of two, as a fraction: "3/8"; as a decimal where that is long.
std::string dyadic_text(double value);

}  // namespace interleaf
