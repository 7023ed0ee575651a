// A closed surface of genus 0 together with a map of its vertices to the unit sphere.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

/// A vertex that corresponds to a vertex of another body: the one with the same direction.
struct SphereLandmark {
    Index vertex = no_index;
    glm::dvec3 direction{0};  ///< on the sphere to which both bodies are mapped; a unit vector
};

struct SphereMesh {
    std::vector<Triangle> triangles;
    std::vector<glm::dvec3> positions;  ///< in space, one per vertex
    std::vector<glm::dvec3> points;     ///< of the unit sphere, one per vertex
    std::vector<SphereLandmark> landmarks{};
};

}  // namespace interleaf
