#include "app/brushing/brushed_key.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "fit/mesh/space_triangle.h"
#include "hierarchy/color.h"

namespace interleaf {

namespace {

/// Sets the values of \p midpoint to the mean of those of \p a and \p b.
void interpolate(Field& field, Index a, Index b, Index midpoint) {
    const std::size_t width = component_count(field.kind);
    field.values.resize(std::max(field.values.size(), width * (midpoint + std::size_t{1})));
    float* const values = field.values.data();
    if (field.kind == FieldKind::color) {
        const auto color = [&](Index vertex) {
            const float* const at = values + width * vertex;
            return linear_light({at[0], at[1], at[2]});
        };
        const glm::vec3 mean = glm::clamp(encoded((color(a) + color(b)) * 0.5F), 0.0F, 1.0F);
        for (int c = 0; c < 3; ++c) values[width * midpoint + static_cast<std::size_t>(c)] = mean[c];
        return;
    }
    for (std::size_t c = 0; c < width; ++c)
        values[width * midpoint + c] = (values[width * a + c] + values[width * b + c]) * 0.5F;
}

}  // namespace

BrushedKey::BrushedKey(const Hierarchy& key, PlaceVertex place)
    : fields_(key.fields),
      place_(std::move(place)),
      mesh_(key, [this](Index a, Index b, Index midpoint) { return place_midpoint(a, b, midpoint); }) {
    figures_.leaves_before = figures_.leaves = key.leaf_count();
}

glm::vec3 BrushedKey::place_midpoint(Index a, Index b, Index midpoint) {
    for (Field& field : fields_) interpolate(field, a, b, midpoint);
    const glm::vec3& from = mesh_.positions()[a];
    const glm::vec3& to = mesh_.positions()[b];
    const glm::vec3 middle = (from + to) * 0.5F;
    return place_ ? place_(middle, glm::distance(from, to)) : middle;
}

std::optional<BrushTouch> BrushedKey::touch(const Ray& ray, float radius) {
    if (triangles_.empty()) {
        triangles_.resize(mesh_.leaf_bound());
        for (Index leaf = 0; leaf < mesh_.leaf_bound(); ++leaf)
            triangles_[leaf] = mesh_.is_leaf(leaf) ? mesh_.vertices(leaf) : Triangle{0, 0, 0};
    }
    const std::optional<Hit> hit = first_hit(triangles_, mesh_.positions(), ray);
    if (!hit) return std::nullopt;
    glm::vec3 center(0);
    for (int corner = 0; corner < 3; ++corner)
        center += hit->barycentric[corner] *
                  mesh_.positions()[triangles_[hit->triangle][static_cast<std::size_t>(corner)]];
    return BrushTouch{static_cast<Index>(hit->triangle), center, radius};
}

bool BrushedKey::meets(Index leaf, const BrushTouch& touch) const {
    const auto& [a, b, c] = mesh_.vertices(leaf);
    const auto positions = mesh_.positions();
    const double radius = touch.radius;
    return squared_distance_to_triangle(touch.center, {positions[a], positions[b], positions[c]}) <=
           radius * radius;
}

/// Marks \p leaf for the present touch.
/// \return whether it was not marked yet
bool BrushedKey::mark(Index leaf) {
    if (marks_.size() < mesh_.leaf_bound()) marks_.resize(mesh_.leaf_bound(), 0);
    return std::exchange(marks_[leaf], touch_) != touch_;
}

/// The leaves that meet the ball, from the leaf under the pointer on, and marks them.
std::vector<Index> BrushedKey::touched_leaves(const BrushTouch& touch) {
    ++touch_;
    mark(touch.leaf);
    std::vector<Index> found{touch.leaf};
    for (std::size_t n = 0; n < found.size(); ++n)
        for (const Index neighbor : mesh_.neighbors(found[n]))
            if (neighbor != no_index && meets(neighbor, touch) && mark(neighbor)) found.push_back(neighbor);
    return found;
}

void BrushedKey::refine(const BrushTouch& touch, unsigned level) {
    std::vector<Index> leaves = touched_leaves(touch);
    std::vector<Index> marked;
    std::vector<Index> changed;
    for (unsigned present = 0; present < level; ++present) {
        marked.clear();
        std::ranges::copy_if(leaves, std::back_inserter(marked),
                             [&](Index leaf) { return mesh_.level(leaf) == present && meets(leaf, touch); });
        if (marked.empty()) continue;
        if (mesh_.leaf_count() + 2 * marked.size() > max_brushed_leaves) {
            figures_.is_full = true;
            break;
        }
        const std::size_t before = mesh_.leaf_count();
        changed.clear();
        mesh_.refine(marked, &changed);
        figures_.by_closure += mesh_.leaf_count() - before - marked.size();
        // The first child has the place of its parent, and its mark.
        for (std::size_t n = 0; n + 1 < changed.size(); n += 2)
            if (is_marked(changed[n]) && mark(changed[n + 1])) leaves.push_back(changed[n + 1]);
    }
    follow_count();
}

void BrushedKey::coarsen(const BrushTouch& touch, unsigned level) {
    std::vector<Index> leaves = touched_leaves(touch);
    for (;;) {
        std::vector<Index> marked;
        std::ranges::copy_if(leaves, std::back_inserter(marked),
                             [&](Index leaf) { return mesh_.level(leaf) > level && meets(leaf, touch); });
        const std::size_t before = mesh_.leaf_count();
        mesh_.coarsen(marked);  // a parent has the place of its first child
        if (mesh_.leaf_count() == before) break;
        std::erase_if(leaves, [&](Index leaf) { return !mesh_.is_leaf(leaf); });
    }
    follow_count();
}

void BrushedKey::follow_count() {
    if (figures_.leaves == mesh_.leaf_count()) return;
    figures_.leaves = mesh_.leaf_count();
    triangles_.clear();
}

}  // namespace interleaf
