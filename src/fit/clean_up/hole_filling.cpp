#include "fit/clean_up/hole_filling.h"

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>

#include "fit/mesh/half_edge_mesh.h"

namespace interleaf {
namespace {

/// A position, a color and scalars, which are blended in the same way.
struct Sample {
    glm::dvec3 position{0};
    glm::vec3 color{0};
    std::vector<double> scalars{};
};

Sample blend(const Sample& a, const Sample& b, double part) {
    Sample blended{a.position + part * (b.position - a.position), a.color + float(part) * (b.color - a.color),
                   a.scalars};
    for (std::size_t s = 0; s < a.scalars.size(); ++s)
        blended.scalars[s] += part * (b.scalars[s] - a.scalars[s]);
    return blended;
}

class Filler {
  public:
    Filler(SurfaceMesh& mesh, ProgressMeter& meter) : mesh_(mesh), meter_(meter) {}

    /// \param rim  vertices, counter-clockwise as seen from outside and from the new triangles
    void fill(std::vector<Index> rim) {
        if (rim.size() == 3) {
            add(rim[0], rim[1], rim[2]);
            return;
        }
        constexpr std::size_t max_spokes = 8;
        std::vector<Sample> rim_samples;
        rim_samples.reserve(rim.size());
        for (const Index vertex : rim) rim_samples.push_back(sample(vertex));
        const Sample middle = middle_of(rim_samples);
        std::vector<Index> outer = std::move(rim);
        while (outer.size() > max_spokes) {
            std::vector<Index> inner = add_ring(rim_samples, middle, (outer.size() + 1) / 2);
            add_strip(outer, inner);
            outer = std::move(inner);
        }
        const Index center = add(middle);
        for (std::size_t i = 0; i < outer.size(); ++i) add(outer[i], outer[(i + 1) % outer.size()], center);
    }

  private:
    Sample sample(Index vertex) const {
        Sample sample{mesh_.positions[vertex], mesh_.colors.empty() ? glm::vec3(0) : mesh_.colors[vertex]};
        sample.scalars.reserve(mesh_.scalars.size());
        for (const MeshField& scalar : mesh_.scalars) sample.scalars.push_back(scalar.values[vertex]);
        return sample;
    }

    /// The mean along the rim, independent of the spacing of its vertices.
    static Sample middle_of(std::span<const Sample> rim) {
        Sample sum;
        sum.scalars.resize(rim.front().scalars.size(), 0);
        double whole = 0;
        for (std::size_t i = 0; i < rim.size(); ++i) {
            const Sample between = blend(rim[i], rim[(i + 1) % rim.size()], 0.5);
            const double length = glm::distance(rim[i].position, rim[(i + 1) % rim.size()].position);
            sum.position += length * between.position;
            sum.color += float(length) * between.color;
            for (std::size_t s = 0; s < sum.scalars.size(); ++s)
                sum.scalars[s] += length * between.scalars[s];
            whole += length;
        }
        if (!(whole > 0)) return rim.front();
        for (double& scalar : sum.scalars) scalar /= whole;
        return {sum.position / whole, sum.color / float(whole), std::move(sum.scalars)};
    }

    /// A ring of \p count vertices parallel to the rim. Rings nearer to the middle have fewer vertices.
    std::vector<Index> add_ring(std::span<const Sample> rim, const Sample& middle, std::size_t count) {
        std::vector<Index> ring;
        const double radius = double(count) / double(rim.size());
        for (std::size_t i = 0; i < count; ++i) {
            const double place = double(i) * double(rim.size()) / double(count);
            const auto before = std::size_t(place);
            const Sample on_rim =
                blend(rim[before], rim[(before + 1) % rim.size()], place - std::floor(place));
            ring.push_back(add(blend(middle, on_rim, radius)));
        }
        return ring;
    }

    void add_strip(std::span<const Index> outer, std::span<const Index> inner) {
        std::size_t i = 0;
        std::size_t j = 0;
        const auto at = [](std::span<const Index> ring, std::size_t place) {
            return ring[place % ring.size()];
        };
        while (i < outer.size() || j < inner.size()) {
            if ((i + 1) * inner.size() <= (j + 1) * outer.size()) {
                add(at(outer, i), at(outer, i + 1), at(inner, j));
                ++i;
            } else {
                add(at(outer, i), at(inner, j + 1), at(inner, j));
                ++j;
            }
        }
    }

    void add(Index a, Index b, Index c) {
        mesh_.triangles.push_back({a, b, c});
        meter_.step();
    }

    Index add(const Sample& vertex) {
        mesh_.positions.push_back(vertex.position);
        if (!mesh_.colors.empty()) mesh_.colors.push_back(vertex.color);
        for (std::size_t s = 0; s < mesh_.scalars.size(); ++s)
            mesh_.scalars[s].values.push_back(vertex.scalars[s]);
        return static_cast<Index>(mesh_.positions.size() - 1);
    }

    SurfaceMesh& mesh_;
    ProgressMeter& meter_;
};

/// The boundary half-edge that follows \p half_edge, which is a boundary half-edge, too.
Index next_on_boundary(std::span<const Index> twin, Index half_edge) {
    Index next = HalfEdgeMesh::next(half_edge);
    while (twin[next] != no_index) next = HalfEdgeMesh::next(twin[next]);
    return next;
}

}  // namespace

std::vector<FilledHole> fill_holes(SurfaceMesh& mesh, std::span<const Index> twin, ProgressMeter& meter) {
    std::vector<FilledHole> holes;
    Filler filler(mesh, meter);
    std::vector<char> is_done(twin.size());
    for (Index start = 0; start < twin.size(); ++start) {
        if (twin[start] != no_index || is_done[start]) continue;
        std::vector<Index> rim;
        for (Index edge = start; !is_done[edge]; edge = next_on_boundary(twin, edge)) {
            is_done[edge] = 1;
            rim.push_back(mesh.triangles[edge / 3][edge % 3]);
            meter.step();
        }
        // The surface runs along the rim with the hole on its right.
        const std::size_t triangles_before = mesh.triangles.size();
        filler.fill({rim.rbegin(), rim.rend()});
        holes.push_back({rim.size(), mesh.triangles.size() - triangles_before});
    }
    return holes;
}

}  // namespace interleaf
