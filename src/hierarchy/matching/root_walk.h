// A walk over one component of a root complex, and its image in another complex. The image of one side
// determines the image of the whole walk: so an isomorphism spreads from one side to a whole component.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/matching/root_gluing.h"

namespace interleaf {

/// The triangles of a component, breadth first from a seed. Each is reached across a side of an earlier
/// triangle.
struct RootWalk {
    struct Step {
        Index triangle;
        std::uint8_t leads_on;    ///< bit k: the walk reaches the triangle across side k from here
        std::uint8_t is_visited;  ///< bit k: an earlier triangle has visited vertex k
    };
    std::vector<Step> steps;
    std::size_t vertex_count = 0;
};

/// A complex with one position per vertex.
struct PlacedRoots {
    const RootGluing* gluing;
    std::span<const glm::vec3> positions;
};

/// What an image must respect besides orientation, and when the walk may stop.
struct ImageRules {
    bool marked = true;              ///< refinement edges are mapped to refinement edges
    std::span<const Index> given{};  ///< the images of all triangles; empty if they are to be found
    glm::dvec3 shift{0};             ///< added to the positions of the image before distances are measured
    double max_distance = 1e300;     ///< the walk stops when the sum of squared distances exceeds this
};

/// How an image of a walk ended.
struct ImageEnd {
    enum class Kind {
        complete,
        too_far,          ///< the distance exceeds max_distance
        boundary,         ///< the side is on the boundary in exactly one of the complexes
        surroundings,     ///< the vertex has different surroundings in the other complex
        refinement_edge,  ///< the triangle across the side has a different refinement edge
        neighbor,         ///< the triangle across the side already has a different image
        given,            ///< the triangle across the side has a different given image
    };
    Kind kind = Kind::complete;
    Index side = no_index;        ///< the side in the walk's complex where the walk stopped
    Index image_side = no_index;  ///< the image of that side
    std::size_t step_count = 0;
    double distance = 0;  ///< sum of squared distances between the vertices so far and their images
};

/// The images of walks, by triangle: the side that is the image of the triangle's side 0.
class RootImages {
  public:
    explicit RootImages(std::size_t triangle_count) : sides_(triangle_count, no_index) {}

    /// Maps side 0 of the first triangle of \p walk to \p image, and extends that map over the walk. A
    /// complete image is an isomorphism onto a component, if that component has no more triangles than the
    /// walk. Takes one step per triangle.
    ImageEnd spread(const RootWalk& walk, const PlacedRoots& from, const PlacedRoots& to, Index image,
                    const ImageRules& rules);

    Index operator[](Index triangle) const { return sides_[triangle]; }

  private:
    std::vector<Index> sides_;
};

/// Makes walks over the components of one complex. Reuses its scratch memory, which is as large as the
/// complex.
class RootWalker {
  public:
    explicit RootWalker(const RootGluing& gluing)
        : gluing_(&gluing), reached_(gluing.triangles.size()), visited_(gluing.surroundings.size()) {}

    /// \pre  there was no walk over the component of \p seed before
    RootWalk walk_from(Index seed);

  private:
    const RootGluing* gluing_;
    std::vector<bool> reached_;
    std::vector<bool> visited_;
};

}  // namespace interleaf
