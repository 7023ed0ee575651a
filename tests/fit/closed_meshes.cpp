#include "fit/closed_meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>

#include <glm/geometric.hpp>

namespace interleaf::testing {
namespace {

constexpr double pi = std::numbers::pi;

Index midpoint(SurfaceMesh& mesh, std::map<std::pair<Index, Index>, Index>& midpoints, Index a, Index b) {
    const auto [place, is_new] =
        midpoints.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<Index>(mesh.positions.size()));
    if (is_new) mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
    return place->second;
}

glm::dvec3 spiky(const glm::dvec3& p) {
    double radius = 0.4;
    for (const glm::dvec3& tip : {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
                                  glm::dvec3(-0.6, -0.8, 0), glm::dvec3(0, -0.6, -0.8)})
        radius += 3 * std::exp(40 * (glm::dot(p, tip) - 1));
    return radius * p;
}

glm::dvec3 bent_bone(const glm::dvec3& p) {
    const double bend = 1.5 * p.x;
    const double thickness = 0.1 + 0.15 * p.x * p.x;
    const double radius = 1 + thickness * p.y;
    return {radius * std::sin(bend), radius * std::cos(bend), thickness * p.z};
}

}  // namespace

SurfaceMesh cylinder(unsigned sides, double height, Cap cap) {
    SurfaceMesh mesh;
    for (const double z : {0.0, height})
        for (unsigned i = 0; i < sides; ++i) {
            const double angle = 2 * std::numbers::pi * i / sides;
            mesh.positions.emplace_back(std::cos(angle), std::sin(angle), z);
        }
    const auto add = [&](Index a, Index b, Index c) {  // of the top, and the same of the bottom
        mesh.triangles.push_back({sides + a, sides + b, sides + c});
        mesh.triangles.push_back({c, b, a});
    };
    for (Index i = 0; i < sides; ++i) {
        const Index after = i + 1 == sides ? 0 : i + 1;
        mesh.triangles.push_back({i, after, sides + after});
        mesh.triangles.push_back({i, sides + after, sides + i});
        if (cap == Cap::center_fan) {
            mesh.triangles.push_back({sides + i, sides + after, 2 * sides});
            mesh.triangles.push_back({after, i, 2 * sides + 1});
        }
    }
    if (cap == Cap::center_fan) {
        mesh.positions.emplace_back(0, 0, height);
        mesh.positions.emplace_back(0, 0, 0);
    }
    if (cap == Cap::corner_fan)
        for (Index i = 1; i + 1 < sides; ++i) add(0, i, i + 1);
    if (cap == Cap::zigzag)
        for (Index low = 0, high = sides - 1; low + 1 < high;) {
            if ((low + high) % 2 == (sides - 1) % 2) {
                add(low, low + 1, high);
                ++low;
            } else {
                add(low, high - 1, high);
                --high;
            }
        }
    if (cap == Cap::every_other) {
        std::vector<Index> ring(sides);
        std::iota(ring.begin(), ring.end(), Index{0});
        while (ring.size() > 2) {
            std::vector<Index> left;
            for (std::size_t i = 0; i < ring.size(); i += 2) {
                left.push_back(ring[i]);
                if (i + 1 < ring.size()) add(ring[i], ring[i + 1], ring[(i + 2) % ring.size()]);
            }
            ring = std::move(left);
        }
    }
    return mesh;
}

SurfaceMesh tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}, {}};
}

SurfaceMesh icosphere(unsigned divisions) {
    const double g = std::numbers::phi;
    SurfaceMesh mesh;
    mesh.positions = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                      {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                      {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                      {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
    for (glm::dvec3& position : mesh.positions) position = glm::normalize(position);
    for (; divisions > 0; --divisions) {
        std::map<std::pair<Index, Index>, Index> midpoints;
        std::vector<Triangle> divided;
        for (const auto& [a, b, c] : mesh.triangles) {
            const Index ab = midpoint(mesh, midpoints, a, b);
            const Index bc = midpoint(mesh, midpoints, b, c);
            const Index ca = midpoint(mesh, midpoints, c, a);
            divided.insert(divided.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        mesh.triangles = std::move(divided);
    }
    return mesh;
}

SurfaceMesh globe(unsigned meridians, unsigned parallels) {
    SurfaceMesh mesh;
    mesh.positions = {{0, 0, 1}, {0, 0, -1}};
    for (unsigned row = 1; row <= parallels; ++row) {
        for (unsigned column = 0; column < meridians; ++column) {
            const double latitude = pi * row / (parallels + 1);
            const double longitude = 2 * pi * column / meridians;
            mesh.positions.emplace_back(std::sin(latitude) * std::cos(longitude),
                                        std::sin(latitude) * std::sin(longitude), std::cos(latitude));
        }
    }
    const auto at = [&](unsigned row, unsigned column) {
        return 2 + (row - 1) * meridians + column % meridians;
    };
    for (unsigned column = 0; column < meridians; ++column) {
        mesh.triangles.push_back({0, at(1, column), at(1, column + 1)});
        mesh.triangles.push_back({1, at(parallels, column + 1), at(parallels, column)});
        for (unsigned row = 1; row < parallels; ++row) {
            mesh.triangles.push_back({at(row, column), at(row + 1, column), at(row + 1, column + 1)});
            mesh.triangles.push_back({at(row, column), at(row + 1, column + 1), at(row, column + 1)});
        }
    }
    return mesh;
}

SurfaceMesh torus(unsigned around, unsigned across) {
    SurfaceMesh mesh;
    for (unsigned i = 0; i < around; ++i) {
        for (unsigned j = 0; j < across; ++j) {
            const double u = 2 * pi * i / around;
            const double v = 2 * pi * j / across;
            const double radius = 2 + std::cos(v);
            mesh.positions.emplace_back(radius * std::cos(u), radius * std::sin(u), std::sin(v));
        }
    }
    const auto at = [&](unsigned i, unsigned j) { return (i % around) * across + j % across; };
    for (unsigned i = 0; i < around; ++i) {
        for (unsigned j = 0; j < across; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    }
    return mesh;
}

SurfaceMesh sheet(unsigned squares) {
    SurfaceMesh mesh;
    for (unsigned y = 0; y <= squares; ++y)
        for (unsigned x = 0; x <= squares; ++x) mesh.positions.emplace_back(x, y, 0);
    const auto at = [&](unsigned x, unsigned y) { return y * (squares + 1) + x; };
    for (unsigned y = 0; y < squares; ++y) {
        for (unsigned x = 0; x < squares; ++x) {
            mesh.triangles.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1)});
            mesh.triangles.push_back({at(x, y), at(x + 1, y + 1), at(x, y + 1)});
        }
    }
    return mesh;
}

std::vector<glm::dvec3> on_sphere(const SurfaceMesh& mesh) {
    std::vector<glm::dvec3> points = mesh.positions;
    for (glm::dvec3& point : points) point = glm::normalize(point);
    return points;
}

SurfaceMesh moved(SurfaceMesh mesh, const std::function<glm::dvec3(const glm::dvec3&)>& map) {
    for (glm::dvec3& position : mesh.positions) position = map(position);
    return mesh;
}

SurfaceMesh joined(SurfaceMesh first, const SurfaceMesh& second) {
    const auto shift = static_cast<Index>(first.positions.size());
    first.positions.insert(first.positions.end(), second.positions.begin(), second.positions.end());
    for (const auto& [a, b, c] : second.triangles)
        first.triangles.push_back({a + shift, b + shift, c + shift});
    return first;
}

SurfaceMesh random_sphere(std::uint32_t seed, unsigned vertices) {
    std::mt19937 random(seed);
    const auto below = [&](std::size_t count) { return random() % count; };
    const auto coordinate = [&] { return double(random()) / 4294967296.0; };
    SurfaceMesh mesh = tetrahedron();
    while (mesh.positions.size() < vertices) {
        const auto added = static_cast<Index>(mesh.positions.size());
        mesh.positions.emplace_back();
        const Triangle first = mesh.triangles[below(mesh.triangles.size())];
        std::erase(mesh.triangles, first);
        std::vector<std::pair<Index, Index>> rim = {
            {first[0], first[1]}, {first[1], first[2]}, {first[2], first[0]}};
        if (below(3) > 0) {  // the edge of the first two as well
            const auto across =
                std::find_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) {
                    for (unsigned k = 0; k < 3; ++k)
                        if (t[k] == first[1] && t[(k + 1) % 3] == first[0]) return true;
                    return false;
                });
            Triangle second = *across;
            mesh.triangles.erase(across);
            while (second[0] != first[1]) std::rotate(second.begin(), second.begin() + 1, second.end());
            rim = {
                {first[1], first[2]}, {first[2], first[0]}, {second[1], second[2]}, {second[2], second[0]}};
        }
        for (const auto& [from, to] : rim) mesh.triangles.push_back({from, to, added});
    }
    for (glm::dvec3& position : mesh.positions) position = {coordinate(), coordinate(), coordinate()};
    return mesh;
}

SurfaceMesh double_pyramid(unsigned vertices) {
    return globe(vertices, 1);
}

std::vector<NamedMesh> closed_meshes() {
    const auto stretched = [](double x, double y, double z) {
        return [=](const glm::dvec3& p) { return p * glm::dvec3(x, y, z); };
    };
    return {
        {"tetrahedron", tetrahedron()},
        {"icosahedron", icosphere(0)},
        {"sphere", icosphere(4)},
        {"globe with needles", globe(200, 12)},
        {"double pyramid", double_pyramid(3000)},
        {"bumpy sphere", moved(icosphere(4),
                               [](const glm::dvec3& p) {
                                   return p * (1 + 0.2 * std::sin(9 * p.x) * std::cos(8 * p.y + p.z));
                               })},
        {"spiky sphere", moved(icosphere(5), spiky)},
        {"rod, 40 times as long as thick", moved(globe(16, 200), stretched(1, 1, 40))},
        {"disc, 50 times as wide as thick", moved(icosphere(4), stretched(50, 50, 1))},
        {"bent bone", moved(icosphere(4), bent_bone)},
        {"all at one height", moved(icosphere(3), stretched(1, 1, 0))},
        {"all on one line", moved(icosphere(3), stretched(1, 0, 0))},
        {"giant", moved(icosphere(3), stretched(1e38, 1e38, 1e38))},
        {"tiny", moved(icosphere(3), stretched(1e-300, 1e-300, 1e-300))},
    };
}

}  // namespace interleaf::testing
