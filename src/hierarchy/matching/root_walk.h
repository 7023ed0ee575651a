// A walk over one component of a root complex, and its image in another complex: the step by which an
// isomorphism spreads from the image of one side to a whole component.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/matching/root_gluing.h"

namespace interleaf {

/// The triangles of a component, breadth first from \p seed; each is reached across a side of one before.
struct RootWalk {
    struct Step {
        Index triangle;
        std::uint8_t leads_on;    ///< bit k: the triangle across side k is reached from here
        std::uint8_t is_visited;  ///< bit k: vertex k was visited before
    };
    std::vector<Step> steps;
    std::size_t vertex_count = 0;
};

/// A complex with one position a vertex.
struct PlacedRoots {
    const RootGluing* gluing;
    std::span<const glm::vec3> positions;
};

/// What an image must respect besides orientation, and where the walk may stop.
struct ImageRules {
    bool marked = true;                ///< refinement edges are mapped to refinement edges
    std::span<const Index> given{};    ///< the images of all triangles; empty where they are to be found
    glm::dvec3 shift{0};               ///< added to the positions of the image before distances are measured
    double greatest_distance = 1e300;  ///< sum of squares beyond which the image is of no use
};

/// How an image of a walk ended.
struct ImageEnd {
    enum class Kind {
        complete,
        too_far,          ///< beyond greatest_distance
        boundary,         ///< the side is on the boundary in one complex alone
        surroundings,     ///< the vertex has other triangles around it in the other complex
        refinement_edge,  ///< the triangle across the side has its refinement edge elsewhere
        neighbour,        ///< the triangle across the side has another image already
        given,            ///< the triangle across the side has another given image
    };
    Kind kind = Kind::complete;
    Index side = no_index;        ///< of the walk's complex, where it could not go on
    Index image_side = no_index;  ///< the image of that side
    std::size_t step_count = 0;
    double distance = 0;  ///< sum of the squared distances of the vertices and their images so far
};

/// The images of walks, by triangle: the side that is the image of the triangle's side 0.
class RootImages {
  public:
    explicit RootImages(std::size_t triangle_count) : sides_(triangle_count, no_index) {}

    /// Maps side 0 of the first triangle of \p walk to \p image, and spreads that over the walk. A complete
    /// image is an isomorphism onto a component, if that has no more triangles than the walk. Takes a step a
    /// triangle.
    ImageEnd spread(const RootWalk& walk, const PlacedRoots& from, const PlacedRoots& to, Index image,
                    const ImageRules& rules);

    Index operator[](Index triangle) const { return sides_[triangle]; }

  private:
    std::vector<Index> sides_;
};

/// The walks over components of one complex. Its scratch memory is of the size of the complex, and used
/// again.
class RootWalker {
  public:
    explicit RootWalker(const RootGluing& gluing)
        : gluing_(&gluing), reached_(gluing.triangles.size()), visited_(gluing.surroundings.size()) {}

    /// \pre  no walk over the component of \p seed was made before
    RootWalk walk_from(Index seed);

  private:
    const RootGluing* gluing_;
    std::vector<bool> reached_;
    std::vector<bool> visited_;
};

}  // namespace interleaf
