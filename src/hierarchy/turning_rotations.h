// Rotations from one key of a union to another, one per vertex and smooth over the surface: the first half of the
// turning blend (turning.h).
//
// A leaf says how its edges and its normal turn. The keys of a blend may be different bodies, whose leaves turn in
// all directions, so a vertex takes the rotation that fits best what the leaves around it say (Kabsch 1976; Horn 1987
// with quaternions). "Around" is a diffusion over the surface by a fixed part of its size, measured as the mean of
// both keys, whatever the size of the leaves.
#pragma once

#include <cstddef>
#include <vector>

#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <glm/gtc/quaternion.hpp>

#include "hierarchy/union_mesh.h"

namespace interleaf {

using SurfaceMatrix = Eigen::SparseMatrix<double>;
using SurfaceFactors = Eigen::SimplicialLDLT<SurfaceMatrix>;

/// The stiffness matrix of the union's leaves as isosceles right triangles: each leg counts half per leaf.
SurfaceMatrix leaf_stiffness(const UnionMesh& mesh);

/// An edge of the union that has a stiffness.
struct StiffEdge {
    Index from;
    Index to;
    double stiffness;
};

std::vector<StiffEdge> stiff_edges(const SurfaceMatrix& stiffness);

/// The area that each vertex stands for, in parts of the whole, on leaves that halve their root with every level.
std::vector<double> vertex_shares(const UnionMesh& mesh);

class TurningRotations {
  public:
    /// \param mesh       must outlive this object, as must the others
    /// \param stiffness  of \p mesh
    /// \param shares     of \p mesh
    TurningRotations(const UnionMesh& mesh, const SurfaceMatrix& stiffness,
                     const std::vector<double>& shares);

    /// The rotation at each vertex from key \p from to key \p to. Signs are consistent: neighbors turn the same way,
    /// and most of the surface turns by less than 180 degrees.
    std::vector<glm::quat> between(std::size_t from, std::size_t to);

  private:
    Eigen::Matrix<double, Eigen::Dynamic, 9> agreements(std::size_t from, std::size_t to) const;
    std::vector<double> vertex_areas(std::size_t from, std::size_t to) const;
    void choose_signs(std::vector<glm::dquat>& rotations, const std::vector<double>& areas) const;

    const UnionMesh& mesh_;
    const SurfaceMatrix& stiffness_;
    const std::vector<double>& shares_;
    std::vector<double> key_areas_;
    SurfaceFactors diffusion_;
};

}  // namespace interleaf
