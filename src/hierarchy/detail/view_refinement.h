// Refines the union of several keys, from the roots, to the level of detail that suits one view of their blend
// at a bounded number of leaves.
//
// The refinement is the greedy one of vertex_errors.h. It runs anew for each view, over the union of the keys,
// which it never builds: it bisects the triangle with the largest view error next, with closure, in all keys
// that bisect it, until the next bisection would exceed the budget. The error of a vertex is the least view
// error chosen until then. The threshold of the cut is the first error that the budget does not allow. So the
// cost depends on the budget alone: at most one entry in a queue per new triangle.
//
// A vertex grows out of the middle of its edge while its error goes from the threshold to `growth_band` times
// the threshold. So the surface is a continuous function of view and weights. docs/theory.md has the proofs.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/detail/key_detail.h"
#include "hierarchy/detail/view_error.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

/// A vertex is whole from this multiple of the threshold on.
inline constexpr float growth_band = 1.5F;

/// The result of a refinement, in the order in which it made vertices and triangles.
struct RefinedView {
    struct Vertex {
        std::array<Index, 2> edge = {no_index, no_index};  ///< the ends of its edge; none for a root vertex
        float error = 0;                                   ///< infinity for a root vertex
    };
    struct Node {
        Triangle vertices{};
        Index midpoint = no_index;     ///< no_index for a leaf
        Index first_child = no_index;  ///< the second child follows it
    };
    std::vector<Vertex> vertices{};  ///< the root vertices first, ends of edges before midpoints
    std::vector<Node> nodes{};       ///< the roots first

    /// own[v * key count + i]: the vertex of key i that vertex v is; no_index if key i has none there.
    std::vector<Index> own{};

    /// places[n * key count + i]: the bisection of key i at node n, in KeyDetail::bisections; no_index if key i
    /// does not bisect it.
    std::vector<Index> places{};

    std::size_t leaf_count = 0;
    float threshold = 0;  ///< 0 if all keys are whole

    /// 0 while \p vertex is at the middle of its edge, to 1 when it is at its own place.
    float growth(Index vertex) const;
};

class ViewRefinement {
  public:
    /// \param keys     over one root complex; they and their details must outlive the refinement
    /// \param details  measure_detail() of each key
    /// \pre  there is a key
    ViewRefinement(std::vector<const Hierarchy*> keys, std::vector<const KeyDetail*> details);

    /// \param weights     one per key
    /// \param max_leaves  the budget; the roots are there in any case
    const RefinedView& refine(std::span<const float> weights, const ViewPoint& view, std::size_t max_leaves);

    const std::vector<const Hierarchy*>& keys() const { return keys_; }

  private:
    /// The state of a bisection of a key.
    struct State {
        Index node = no_index;    ///< the node that exists and has this bisection
        Index vertex = no_index;  ///< its midpoint: no_index, pending, or made; kept at the first of partners
    };
    struct Candidate {
        float error;
        Index node;
        bool operator<(const Candidate& other) const {
            return error != other.error ? error < other.error : node > other.node;
        }
    };

    void start();
    void forget();
    bool make(Index node, float error);
    bool close(std::size_t key, Index place);
    void bisect_node(Index node, float error);
    Index vertex_at(Index node, float error);
    void add_midpoint(Index node, float error);
    void add_child(const Triangle& vertices, Index parent, std::size_t child);
    Index& vertex_of(std::size_t key, Index place);
    bool is_due(Index node);
    void push(Index node, float error);
    float view_error(Index node) const;

    std::vector<const Hierarchy*> keys_;
    std::vector<const KeyDetail*> details_;
    bool is_closed_;
    std::vector<std::vector<State>> states_;  ///< of each key, by place
    std::span<const float> weights_;
    ViewPoint view_;
    std::size_t max_leaves_ = 0;
    std::vector<glm::vec3> positions_;  ///< positions_[v * key count + i]: of vertex v on key i
    std::vector<Candidate> candidates_;
    std::vector<Index> closure_;  ///< places, the first of partners
    RefinedView refined_;
};

}  // namespace interleaf
