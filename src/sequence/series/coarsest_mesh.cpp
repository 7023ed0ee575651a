#include "sequence/series/coarsest_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/geometric.hpp>

#include "sequence/series/place_lookup.h"
#include "sequence/series/step_key.h"

namespace interleaf {

namespace {

/// Vertices are at one place within this part of the shortest edge.
constexpr double place_tolerance = 0.1;

double squared_length(std::span<const glm::dvec3> points, Index a, Index b) {
    const glm::dvec3 edge = points[a] - points[b];
    return glm::dot(edge, edge);
}

double shortest_edge_of(std::span<const glm::dvec3> points, std::span<const Triangle> triangles) {
    double shortest = std::numeric_limits<double>::max();
    for (const auto& [a, b, c] : triangles)
        shortest = std::min({shortest, squared_length(points, a, b), squared_length(points, b, c),
                             squared_length(points, c, a)});
    return std::sqrt(shortest);
}

Triangle turned_to_front(const Triangle& triangle, unsigned front) {
    return {triangle[front], triangle[(front + 1) % 3], triangle[(front + 2) % 3]};
}

/// The corner opposite the longest edge; of about equal ones the first.
unsigned corner_opposite_longest(std::span<const glm::dvec3> points, const Triangle& triangle) {
    constexpr double clearly = 1 + 1e-6;
    unsigned best = 0;
    double longest = 0;
    for (unsigned k = 0; k < 3; ++k)
        if (const double square = squared_length(points, triangle[(k + 1) % 3], triangle[(k + 2) % 3]);
            square > clearly * longest) {
            longest = square;
            best = k;
        }
    return best;
}

std::vector<Triangle> oriented_triangles(const StepMesh& step) {
    std::vector<Triangle> triangles;
    triangles.reserve(step.triangles.size());
    for (Index t = 0; t < step.triangles.size(); ++t) triangles.push_back(step.oriented(t));
    return triangles;
}

/// Turns \p a and \p b, the two triangles of a quadrilateral, to their common edge.
void mark_diagonal(Triangle& a, Triangle& b) {
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned j = 0; j < 3; ++j)
            if (a[(i + 1) % 3] == b[(j + 2) % 3] && a[(i + 2) % 3] == b[(j + 1) % 3]) {
                a = turned_to_front(a, i);
                b = turned_to_front(b, j);
                return;
            }
}

/// The vertices at \p places; no_index where there is none.
std::vector<Index> vertices_at(const PlaceLookup& lookup, std::span<const glm::dvec3> places) {
    std::vector<Index> vertices;
    vertices.reserve(places.size());
    for (const glm::dvec3& place : places) vertices.push_back(lookup.vertex_at(place));
    return vertices;
}

Triangle mapped(const Triangle& triangle, std::span<const Index> vertices) {
    return {vertices[triangle[0]], vertices[triangle[1]], vertices[triangle[2]]};
}

bool is_complete(const Triangle& triangle) {
    return std::ranges::count(triangle, no_index) == 0 && triangle[0] != triangle[1] &&
           triangle[1] != triangle[2] && triangle[2] != triangle[0];
}

const std::vector<bool> no_marks;

}  // namespace

SeriesRoots given_roots_of(const Hierarchy& key) {
    SeriesRoots roots{key.roots, {}};
    for (Index v = 0; v < key.roots.vertex_count(); ++v) roots.points.emplace_back(key.positions[v]);
    return roots;
}

SeriesRoots roots_of_step(const StepMesh& step) {
    std::vector<Triangle> triangles = oriented_triangles(step);
    for (Triangle& triangle : triangles)
        triangle = turned_to_front(triangle, corner_opposite_longest(step.points, triangle));
    for (std::size_t t = 1; t < step.cell_of.size(); ++t)
        if (step.cell_of[t] == step.cell_of[t - 1]) mark_diagonal(triangles[t - 1], triangles[t]);
    return {RootComplex(static_cast<Index>(step.points.size()), std::move(triangles)), step.points};
}

/// What becomes of the mesh with the next step.
struct CoarsestMesh::Update {
    std::vector<Triangle> triangles;
    std::vector<bool> is_marked;
    std::vector<Triangle> lost;  ///< triangles that the step does not refine, with their marks
    std::vector<bool> is_lost_marked;
    std::vector<bool> is_covered;  ///< per triangle of the step
};

CoarsestMesh::CoarsestMesh(const StepMesh& first)
    : points_(first.points),
      triangles_(oriented_triangles(first)),
      is_marked_(first.triangles.size(), false),
      shortest_edge_(first.shortest_edge),
      is_fixed_(false) {}

CoarsestMesh::CoarsestMesh(const SeriesRoots& roots)
    : points_(roots.points),
      triangles_(roots.complex.triangles().begin(), roots.complex.triangles().end()),
      is_marked_(triangles_.size(), true),
      shortest_edge_(shortest_edge_of(points_, triangles_)),
      is_fixed_(true) {}

void CoarsestMesh::keep_what_step_refines(const StepMesh& step, double tolerance, Update& update) const {
    const PlaceLookup lookup(step.points, step.triangles, no_marks, tolerance);
    const std::vector<Index> vertices = vertices_at(lookup, points_);
    Expansion below;
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
        const Triangle root = mapped(triangles_[k], vertices);
        std::optional<unsigned> front;
        if (is_complete(root)) {
            if (!is_marked_[k])
                front = lookup.expand_any(root, below);
            else if (lookup.expand(root, below))
                front = 0;
        }
        if (!front) {
            update.lost.push_back(triangles_[k]);
            update.is_lost_marked.push_back(is_marked_[k]);
            continue;
        }
        for (const Index triangle : below.triangles) update.is_covered[triangle] = true;
        update.triangles.push_back(turned_to_front(triangles_[k], *front));
        update.is_marked.push_back(is_marked_[k] || below.leaves.size() > 1);
    }
}

Index CoarsestMesh::replace_what_step_coarsens(const StepMesh& step, double tolerance, Update& update) const {
    const PlaceLookup lookup(points_, update.lost, update.is_lost_marked, tolerance);
    std::vector<bool> is_replaced(update.lost.size(), false);
    Expansion below;
    for (Index t = 0; t < step.triangles.size(); ++t) {
        if (update.is_covered[t]) continue;
        const Triangle corners = step.oriented(t);
        const Triangle root = {lookup.vertex_at(step.points[corners[0]]),
                               lookup.vertex_at(step.points[corners[1]]),
                               lookup.vertex_at(step.points[corners[2]])};
        const std::optional<unsigned> front =
            is_complete(root) ? lookup.expand_any(root, below) : std::nullopt;
        if (!front) return t;
        for (const Index triangle : below.triangles) is_replaced[triangle] = true;
        update.triangles.push_back(turned_to_front(root, *front));
        update.is_marked.push_back(below.leaves.size() > 1);
    }
    // A part of the mesh outside the step is as wrong as a part of the step outside the mesh.
    return std::ranges::count(is_replaced, false) == 0 ? no_index : 0;
}

Index CoarsestMesh::add(const StepMesh& step) {
    const double tolerance = place_tolerance * std::min(shortest_edge_, step.shortest_edge);
    Update update;
    update.is_covered.assign(step.triangles.size(), false);
    keep_what_step_refines(step, tolerance, update);
    if (is_fixed_ && !update.lost.empty()) {
        const auto uncovered = std::ranges::find(update.is_covered, false);
        return static_cast<Index>(uncovered - update.is_covered.begin()) %
               static_cast<Index>(step.triangles.size());
    }
    if (const Index misfit = replace_what_step_coarsens(step, tolerance, update); misfit != no_index)
        return misfit;
    triangles_ = std::move(update.triangles);
    is_marked_ = std::move(update.is_marked);
    shortest_edge_ = shortest_edge_of(points_, triangles_);
    return no_index;
}

std::size_t CoarsestMesh::common_vertices(const StepMesh& step) const {
    const PlaceLookup lookup(points_, triangles_, no_marks,
                             place_tolerance * std::min(shortest_edge_, step.shortest_edge));
    return static_cast<std::size_t>(std::ranges::count_if(
        step.points, [&](const glm::dvec3& point) { return lookup.vertex_at(point) != no_index; }));
}

SeriesRoots CoarsestMesh::roots() const {
    std::vector<Index> number(points_.size(), no_index);
    std::vector<Triangle> triangles;
    SeriesRoots roots;
    for (std::size_t k = 0; k < triangles_.size(); ++k) {
        const unsigned front = is_marked_[k] ? 0 : corner_opposite_longest(points_, triangles_[k]);
        Triangle triangle = turned_to_front(triangles_[k], front);
        for (Index& vertex : triangle) {
            if (number[vertex] == no_index) {
                number[vertex] = static_cast<Index>(roots.points.size());
                roots.points.push_back(points_[vertex]);
            }
            vertex = number[vertex];
        }
        triangles.push_back(triangle);
    }
    roots.complex = RootComplex(static_cast<Index>(roots.points.size()), std::move(triangles));
    return roots;
}

std::optional<Hierarchy> key_by_place(const StepMesh& step, const SeriesRoots& roots,
                                      const SeriesFields& fields) {
    const double shortest_root = shortest_edge_of(roots.points, roots.complex.triangles());
    const PlaceLookup lookup(step.points, step.triangles, no_marks,
                             place_tolerance * std::min(step.shortest_edge, shortest_root));
    const std::vector<Index> vertices = vertices_at(lookup, roots.points);
    std::vector<Leaf> leaves;
    leaves.reserve(step.triangles.size());
    std::vector<bool> is_covered(step.triangles.size(), false);
    Expansion below;
    for (const Triangle& triangle : roots.complex.triangles()) {
        const Triangle root = mapped(triangle, vertices);
        if (!is_complete(root) || !lookup.expand(root, below)) return std::nullopt;
        leaves.insert(leaves.end(), below.leaves.begin(), below.leaves.end());
        for (const Index leaf : below.triangles) is_covered[leaf] = true;
    }
    const bool all_once =
        leaves.size() == step.triangles.size() && std::ranges::count(is_covered, false) == 0;
    if (!all_once) return std::nullopt;
    return key_of_step(step, roots.complex, vertices, std::move(leaves), fields);
}

}  // namespace interleaf
