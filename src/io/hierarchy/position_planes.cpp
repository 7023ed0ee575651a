#include "io/hierarchy/position_planes.h"

#include <bit>
#include <cassert>
#include <cstdint>

#include "io/hierarchy/byte_planes.h"
#include "io/hierarchy/position_prediction.h"

namespace interleaf {

namespace {

/// Gives each float its rank among all floats: a larger float, of either sign, has a larger number.
struct FloatPlaces {
    static std::int32_t number(double coordinate) {
        const auto image = std::bit_cast<std::int32_t>(static_cast<float>(coordinate));
        return image ^ (image < 0 ? 0x7fffffff : 0);
    }
    static float coordinate(std::int32_t number) {
        return std::bit_cast<float>(number ^ (number < 0 ? 0x7fffffff : 0));
    }
};

/// Calls \p visit(row, vertex, expected position) for all vertices in their order. Each call must set the
/// position of its vertex, because later expectations depend on it.
template <typename Visit>
void for_expected_positions(const Connectivity& connectivity, std::span<const glm::vec3> positions,
                            Visit visit) {
    const Buffer<Index> order = prediction_order(connectivity.levels);
    glm::dvec3 expected(0);
    for (std::size_t row = 0; row < order.size(); ++row) {
        const Index vertex = order[row];
        if (connectivity.levels[vertex] > 0)
            expected = predicted_position(vertex, connectivity, positions);
        else if (row > 0)
            expected = positions[order[row - 1]];
        visit(row, vertex, expected);
    }
}

template <typename Numbers>
void write_planes(const BytePlanes& planes, const Connectivity& connectivity,
                  std::span<const glm::vec3> positions, const Numbers& numbers) {
    for_expected_positions(
        connectivity, positions, [&](std::size_t row, Index vertex, const glm::dvec3& expected) {
            for (int axis = 0; axis < 3; ++axis) {
                const std::int32_t number = numbers.number(positions[vertex][axis]);
                assert(std::bit_cast<std::uint32_t>(numbers.coordinate(number)) ==
                       std::bit_cast<std::uint32_t>(positions[vertex][axis]));
                planes.set_difference(row, static_cast<std::size_t>(axis),
                                      static_cast<std::uint32_t>(number) -
                                          static_cast<std::uint32_t>(numbers.number(expected[axis])));
            }
        });
}

template <typename Numbers>
void read_planes(const BytePlanes& planes, const Connectivity& connectivity, std::span<glm::vec3> positions,
                 const Numbers& numbers) {
    for_expected_positions(
        connectivity, positions, [&](std::size_t row, Index vertex, const glm::dvec3& expected) {
            for (int axis = 0; axis < 3; ++axis)
                positions[vertex][axis] = numbers.coordinate(
                    static_cast<std::int32_t>(static_cast<std::uint32_t>(numbers.number(expected[axis])) +
                                              planes.difference(row, static_cast<std::size_t>(axis))));
        });
}

}  // namespace

Buffer<std::byte> position_planes(std::span<const glm::vec3> positions, const Connectivity& connectivity,
                                  const std::optional<CoordinateGrid>& grid) {
    Buffer<std::byte> bytes;
    bytes.resize(positions.size() * BytePlanes::bytes_a_row);
    const BytePlanes planes(bytes);
    if (grid)
        write_planes(planes, connectivity, positions, *grid);
    else
        write_planes(planes, connectivity, positions, FloatPlaces());
    return bytes;
}

Buffer<glm::vec3> positions_of(std::span<std::byte> bytes, const Connectivity& connectivity,
                               const std::optional<CoordinateGrid>& grid) {
    const BytePlanes planes(bytes);
    assert(planes.rows() == connectivity.levels.size());
    Buffer<glm::vec3> positions;
    positions.resize(planes.rows());
    if (grid)
        read_planes(planes, connectivity, positions, *grid);
    else
        read_planes(planes, connectivity, positions, FloatPlaces());
    return positions;
}

}  // namespace interleaf
