// The inspected node: the facts that the inspector shows about it, and steps to other nodes.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "app/document/viewer_state.h"
#include "family/shared_hierarchy.h"
#include "hierarchy/nodes/node_index.h"
#include "hierarchy/nodes/node_path.h"
#include "hierarchy/root_complex.h"
#include "ui/panels/inspector_panel.h"

namespace interleaf {

class Inspection {
  public:
    /// The corners of a node on the shown surface; none if it is late.
    using TurnedCorners = std::function<std::optional<std::array<glm::vec3, 3>>(const NodePath& node)>;

    /// Takes the step that \p state asks for, and updates the facts to its node and its active keys. Ends the
    /// inspection where the document has other roots than before.
    /// \param turned  gives the corners where parts turn; until it knows them, they stay as they were. Null for
    ///     weighted sums of the keys' corners.
    void follow(ViewerState& state, const TurnedCorners& turned = nullptr);

    /// Null if nothing is inspected.
    const InspectedNode* shown() const { return shown_ ? &*shown_ : nullptr; }

    /// Says whether the shown node is at the left of the view. This holds until another node is shown.
    void set_at_left(bool is_at_left) {
        if (shown_) shown_->is_at_left = is_at_left;
    }

  private:
    /// The index of a key, made when a node is first inspected.
    struct IndexedKey {
        SharedHierarchy hierarchy;
        NodeIndex index;
    };
    /// What the facts are of.
    struct Subject {
        NodePath node;
        Weights weights;
        std::shared_ptr<const Family> family;
        bool is_turning;
        bool operator==(const Subject&) const = default;
    };
    void index_active_keys(const Session& session);
    std::vector<const NodeIndex*> indices_of(const Session& session) const;
    const IndexedKey& indexed(const SharedHierarchy& hierarchy) const;
    InspectedKey inspected_key(const Key& key, std::size_t number, const NodePath& node) const;

    std::optional<RootComplex> roots_;  ///< of the document; none before the first
    std::vector<IndexedKey> keys_;
    std::optional<Subject> subject_;
    std::optional<InspectedNode> shown_;
};

}  // namespace interleaf
