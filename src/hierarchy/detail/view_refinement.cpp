#include "hierarchy/detail/view_refinement.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "hierarchy/measure.h"

namespace interleaf {

namespace {

/// A vertex of a key that the closure needs and that is not made yet.
constexpr Index pending_vertex = no_index - 1;

/// A part of a triangle's size counts as an error, too. So no error is 0, flat parts are refined after all
/// others, and the surface changes continuously also where a whole key is within the budget.
constexpr float size_part = 1.0F / 4096;

constexpr float max_error = std::numeric_limits<float>::max();

}  // namespace

float RefinedView::growth(Index vertex) const {
    if (threshold <= 0 || vertices[vertex].edge[0] == no_index) return 1;
    const float error = vertices[vertex].error;
    if (!(error > threshold)) return 0;
    return std::min(std::log(error / threshold) / std::log(growth_band), 1.0F);
}

ViewRefinement::ViewRefinement(std::vector<const Hierarchy*> keys, std::vector<const KeyDetail*> details)
    : keys_(std::move(keys)),
      details_(std::move(details)),
      is_closed_(is_closed_manifold(keys_.at(0)->roots.triangles())),
      states_(keys_.size()) {
    assert(details_.size() == keys_.size());
    for (std::size_t key = 0; key < keys_.size(); ++key)
        states_[key].resize(details_[key]->bisections.size());
}

const RefinedView& ViewRefinement::refine(std::span<const float> weights, const ViewPoint& view,
                                          std::size_t max_leaves) {
    assert(weights.size() == keys_.size());
    weights_ = weights;
    view_ = view;
    max_leaves_ = max_leaves;
    forget();
    start();
    while (!candidates_.empty()) {
        const auto [error, node] = candidates_.front();
        std::pop_heap(candidates_.begin(), candidates_.end());
        candidates_.pop_back();
        if (refined_.nodes[node].first_child != no_index) continue;
        if (make(node, error)) continue;
        refined_.threshold = error;
        break;
    }
    return refined_;
}

/// Clears what the last refinement has left, in time proportional to its size.
void ViewRefinement::forget() {
    for (std::size_t n = 0; n < refined_.places.size(); ++n)
        if (refined_.places[n] != no_index) states_[n % keys_.size()][refined_.places[n]] = {};
    refined_.vertices.clear();
    refined_.nodes.clear();
    refined_.own.clear();
    refined_.places.clear();
    refined_.threshold = 0;
    positions_.clear();
    candidates_.clear();
}

void ViewRefinement::start() {
    const RootComplex& roots = keys_[0]->roots;
    for (Index v = 0; v < roots.vertex_count(); ++v) {
        refined_.vertices.push_back({.error = std::numeric_limits<float>::infinity()});
        for (std::size_t key = 0; key < keys_.size(); ++key) {
            refined_.own.push_back(v);
            positions_.push_back(keys_[key]->positions[v]);
        }
    }
    const auto triangles = roots.triangles();
    refined_.leaf_count = triangles.size();
    for (Index root = 0; root < triangles.size(); ++root) {
        refined_.nodes.push_back({.vertices = triangles[root]});
        for (std::size_t key = 0; key < keys_.size(); ++key) {
            const Index place = details_[key]->roots[root];
            refined_.places.push_back(place);
            if (place != no_index) states_[key][place].node = root;
        }
        push(root, std::numeric_limits<float>::infinity());
    }
}

/// Makes the midpoint of \p node, and before it all vertices that it depends on.
/// \return false, and changes nothing, if that exceeds the budget
bool ViewRefinement::make(Index node, float error) {
    const std::size_t count = keys_.size();
    std::size_t key = 0;
    while (refined_.places[node * count + key] == no_index) ++key;
    if (!close(key, refined_.places[node * count + key])) return false;
    // Triangles of the closure that do not exist yet are bisected when they are made.
    for (const Index place : closure_)
        for (const Index each : {place, details_[key]->bisections[place].partner}) {
            if (each == no_index) continue;
            const Index existing = states_[key][each].node;
            if (existing != no_index && refined_.nodes[existing].first_child == no_index)
                bisect_node(existing, error);
        }
    return true;
}

/// The vertex at the midpoint of bisection \p place of \p key.
Index& ViewRefinement::vertex_of(std::size_t key, Index place) {
    return states_[key][std::min(place, details_[key]->bisections[place].partner)].vertex;
}

/// Collects the midpoint of \p place in \p key and the vertices that it depends on, and marks them as pending.
/// The keys bisect parts of one infinite forest, so the closure in one key is the closure in all keys that have
/// the vertex.
bool ViewRefinement::close(std::size_t key, Index place) {
    const std::vector<DetailBisection>& bisections = details_[key]->bisections;
    closure_.clear();
    const auto add = [&](Index each) {
        Index& vertex = vertex_of(key, each);
        if (vertex != no_index) return;
        vertex = pending_vertex;
        closure_.push_back(std::min(each, bisections[each].partner));
    };
    add(place);
    std::size_t leaves = refined_.leaf_count;
    for (std::size_t n = 0; n < closure_.size() && leaves <= max_leaves_; ++n)
        for (const Index each : {closure_[n], bisections[closure_[n]].partner}) {
            if (each == no_index) continue;
            ++leaves;
            if (bisections[each].needed != no_index) add(bisections[each].needed);
        }
    if (leaves <= max_leaves_) return true;
    for (const Index each : closure_) states_[key][each].vertex = no_index;
    return false;
}

void ViewRefinement::bisect_node(Index node, float error) {
    const Index midpoint = vertex_at(node, error);
    const std::array<Triangle, 2> children = bisect(refined_.nodes[node].vertices, midpoint);
    const auto first_child = static_cast<Index>(refined_.nodes.size());
    refined_.nodes[node].midpoint = midpoint;
    refined_.nodes[node].first_child = first_child;
    ++refined_.leaf_count;
    for (std::size_t child = 0; child < 2; ++child) add_child(children[child], node, child);
    for (const Index child : {first_child, first_child + 1}) {
        if (is_due(child))
            bisect_node(child, error);
        else
            push(child, error);
    }
}

/// The midpoint of \p node, which is made on the first of its two visits.
Index ViewRefinement::vertex_at(Index node, float error) {
    const std::size_t count = keys_.size();
    for (std::size_t key = 0; key < count; ++key) {
        const Index place = refined_.places[node * count + key];
        if (place == no_index) continue;
        const Index found = vertex_of(key, place);
        if (found < pending_vertex) return found;
    }
    add_midpoint(node, error);
    return static_cast<Index>(refined_.vertices.size() - 1);
}

void ViewRefinement::add_midpoint(Index node, float error) {
    const std::size_t count = keys_.size();
    const auto [corner, a, b] = refined_.nodes[node].vertices;
    const auto made = static_cast<Index>(refined_.vertices.size());
    refined_.vertices.push_back({.edge = {a, b}, .error = error});
    for (std::size_t key = 0; key < count; ++key) {
        const Index place = refined_.places[node * count + key];
        if (place == no_index) {
            refined_.own.push_back(no_index);
            positions_.push_back((positions_[a * count + key] + positions_[b * count + key]) * 0.5F);
            continue;
        }
        const DetailBisection& own = details_[key]->bisections[place];
        vertex_of(key, place) = made;
        refined_.own.push_back(own.midpoint);
        positions_.push_back(own.position);
    }
}

void ViewRefinement::add_child(const Triangle& vertices, Index parent, std::size_t child) {
    const std::size_t count = keys_.size();
    const auto node = static_cast<Index>(refined_.nodes.size());
    refined_.nodes.push_back({.vertices = vertices});
    for (std::size_t key = 0; key < count; ++key) {
        const Index above = refined_.places[parent * count + key];
        const Index place = above == no_index ? no_index : details_[key]->bisections[above].children[child];
        refined_.places.push_back(place);
        if (place != no_index) states_[key][place].node = node;
    }
}

/// Whether the closure needs the bisection of the new triangle \p node.
bool ViewRefinement::is_due(Index node) {
    for (std::size_t key = 0; key < keys_.size(); ++key) {
        const Index place = refined_.places[node * keys_.size() + key];
        if (place != no_index && vertex_of(key, place) != no_index) return true;
    }
    return false;
}

/// Makes \p node a candidate if a key bisects it.
void ViewRefinement::push(Index node, float error) {
    const std::size_t begin = node * keys_.size();
    if (std::all_of(&refined_.places[begin], &refined_.places[begin] + keys_.size(),
                    [](Index place) { return place == no_index; }))
        return;
    candidates_.push_back({std::min(error, view_error(node)), node});
    std::push_heap(candidates_.begin(), candidates_.end());
}

/// What the picture of the blend loses if \p node is not bisected.
float ViewRefinement::view_error(Index node) const {
    const std::size_t count = keys_.size();
    const Triangle& corners = refined_.nodes[node].vertices;
    // The blend of the surfaces below the node lies in the blend of the balls around them.
    Ball ball;
    for (std::size_t key = 0; key < count; ++key) {
        std::array<glm::vec3, 3> p;
        for (std::size_t c = 0; c < 3; ++c) p[c] = positions_[std::size_t{corners[c]} * count + key];
        const glm::vec3 center = (p[0] + p[1] + p[2]) / 3.0F;
        float squared = 0;
        for (const glm::vec3& corner : p)
            squared = std::max(squared, glm::dot(corner - center, corner - center));
        const Index place = refined_.places[node * count + key];
        const float deviation = place != no_index ? details_[key]->bisections[place].deviation : 0;
        ball.center += weights_[key] * center;
        ball.radius += std::abs(weights_[key]) * (std::sqrt(squared) + deviation);
    }
    const SeenBall seen(view_, ball);
    float error = 0;
    for (std::size_t key = 0; key < count; ++key) {
        const Index place = refined_.places[node * count + key];
        if (place == no_index) continue;
        const DetailBisection& below = details_[key]->bisections[place];
        const float lost = below.deviation * seen.prominence(below.axis, below.sine, is_closed_);
        error += std::abs(weights_[key]) * (lost + size_part * ball.radius);
        // They are read next if the node is bisected.
        for (const Index child : below.children)
            if (child != no_index) {
                __builtin_prefetch(&details_[key]->bisections[child]);
                __builtin_prefetch(&states_[key][child]);
            }
    }
    error *= seen.magnification();
    return error < max_error ? error : max_error;  // coordinates may be near the end of the range of floats
}

}  // namespace interleaf
