// A closed surface of genus 0 together with a map of its vertices to the unit sphere.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "hierarchy/triangle.h"

namespace interleaf {

struct SphereMesh {
    std::vector<Triangle> triangles;
    std::vector<glm::dvec3> positions;  ///< in space, one per vertex
    std::vector<glm::dvec3> points;     ///< of the unit sphere, one per vertex
};

}  // namespace interleaf
