// Surfaces to draw in tests.
#pragma once

#include <initializer_list>
#include <string_view>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"
#include "render/renderer.h"

namespace interleaf {

/// The weights of a single key.
inline constexpr float one[] = {1};

/// A union with its normals.
struct TestSurface {
    UnionMesh mesh;
    NormalForm form;
};

TestSurface surface_of(const std::vector<Hierarchy>& keys);

/// The union of the shapes called \p names, each of at most \p leaves leaves.
TestSurface surface_of_shapes(std::initializer_list<std::string_view> names, Index leaves);

/// The square from -1 to 1 in the plane z = 0, counter-clockwise seen from +z: two roots whose refinement
/// edge is the diagonal x = y. Both are bisected in the first key, the first root twice.
std::vector<Hierarchy> two_keys_of_a_square();

/// A camera with all of \p surface in view at \p azimuth and \p elevation, for pictures of \p target's size.
Camera camera_on(const TestSurface& surface, const OffscreenTarget& target, float azimuth = 30,
                 float elevation = 20);

}  // namespace interleaf
