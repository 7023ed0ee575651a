#include "io/vtk/vtk_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <span>
#include <string>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/mesh/polygon_mesh.h"

namespace interleaf {
namespace {

/// What becomes of a cell.
enum class Shape { skipped, triangle, quadrilateral, pixel, strip, polygon, refused };

struct CellType {
    std::uint8_t number;  ///< of vtkCellType.h
    Shape shape;
    const char* name;
};

constexpr auto cell_types = std::to_array<CellType>({
    {0, Shape::skipped, "empty cells"},
    {1, Shape::skipped, "vertices"},
    {2, Shape::skipped, "vertices"},
    {3, Shape::skipped, "lines"},
    {4, Shape::skipped, "lines"},
    {5, Shape::triangle, "triangles"},
    {6, Shape::strip, "triangle strips"},
    {7, Shape::polygon, "polygons"},
    {8, Shape::pixel, "pixels"},
    {9, Shape::quadrilateral, "quadrilaterals"},
    {10, Shape::refused, "tetrahedra"},
    {11, Shape::refused, "voxels"},
    {12, Shape::refused, "hexahedra"},
    {13, Shape::refused, "wedges"},
    {14, Shape::refused, "pyramids"},
    {21, Shape::skipped, "quadratic lines"},
    {22, Shape::refused, "quadratic triangles"},
    {23, Shape::refused, "quadratic quadrilaterals"},
    {24, Shape::refused, "quadratic tetrahedra"},
    {25, Shape::refused, "quadratic hexahedra"},
    {26, Shape::refused, "quadratic wedges"},
    {27, Shape::refused, "quadratic pyramids"},
    {28, Shape::refused, "biquadratic quadrilaterals"},
    {30, Shape::refused, "quadratic-linear quadrilaterals"},
    {34, Shape::refused, "biquadratic triangles"},
    {35, Shape::skipped, "cubic lines"},
    {36, Shape::refused, "quadratic polygons"},
    {42, Shape::refused, "polyhedra"},
    {68, Shape::skipped, "Lagrange curves"},
    {69, Shape::triangle, "Lagrange triangles"},
    {70, Shape::quadrilateral, "Lagrange quadrilaterals"},
    {71, Shape::refused, "Lagrange tetrahedra"},
    {72, Shape::refused, "Lagrange hexahedra"},
    {75, Shape::skipped, "Bezier curves"},
    {76, Shape::triangle, "Bezier triangles"},
    {77, Shape::quadrilateral, "Bezier quadrilaterals"},
});

CellType cell_type(std::uint8_t number) {
    const auto* const found = std::ranges::find(cell_types, number, &CellType::number);
    return found == cell_types.end() ? CellType{number, Shape::refused, nullptr} : *found;
}

/// Corners of the triangles of one cell, in the order of the cell.
class TriangleMaker {
  public:
    TriangleMaker(const VtkPiece& piece, std::string_view file) : piece_(piece), file_(file) {}

    void make(FieldMesh& mesh) {
        check_sizes();
        const std::size_t count = count_triangles();
        mesh.triangles.reserve(count);
        mesh.cell_of.reserve(count);
        for_each_cell([&](std::size_t cell, Shape shape, std::span<const Index> c) {
            if (shape == Shape::strip)
                for (std::size_t n = 0; n + 2 < c.size(); ++n)
                    mesh.triangles.push_back(n % 2 == 0 ? std::array{c[n], c[n + 1], c[n + 2]}
                                                        : std::array{c[n + 1], c[n], c[n + 2]});
            else
                mesh.triangles.push_back({c[0], c[1], shape == Shape::pixel ? c[3] : c[2]});
            if (c.size() == 4 && shape != Shape::strip)
                mesh.triangles.push_back(
                    {c[0], shape == Shape::pixel ? c[3] : c[2], shape == Shape::pixel ? c[2] : c[3]});
            mesh.cell_of.resize(mesh.triangles.size(), static_cast<Index>(cell));
        });
    }

  private:
    void check_sizes() const {
        Index end = 0;
        for (std::size_t cell = 0; cell < piece_.cells.ends.size(); ++cell) {
            if (piece_.cells.ends[cell] < end || piece_.cells.ends[cell] > piece_.cells.corners.size())
                fail(cell, fmt::format("ends at corner {}, expected one in [{}, {}]", piece_.cells.ends[cell],
                                       end, piece_.cells.corners.size()));
            end = piece_.cells.ends[cell];
        }
    }

    /// The number of triangles, after a check of each cell.
    std::size_t count_triangles() const {
        std::size_t count = 0;
        for_each_cell([&](std::size_t cell, Shape shape, std::span<const Index> corners) {
            check_corners(cell, shape, corners.size());
            count += corners.size() - 2;
        });
        if (count > max_triangles_of(piece_.content_size))
            throw InputError(fmt::format("{}: {}", file_, too_many_triangles));
        return count;
    }

    void check_corners(std::size_t cell, Shape shape, std::size_t corners) const {
        const CellType type = cell_type(piece_.cells.types[cell]);
        if (shape == Shape::refused && type.name == nullptr)
            fail(cell, fmt::format("cell type {}, expected triangles or quadrilaterals", type.number));
        if (shape == Shape::refused)
            fail(cell, fmt::format("{}, expected triangles or quadrilaterals", type.name));
        const bool is_right = shape == Shape::triangle  ? corners == 3
                              : shape == Shape::strip   ? corners >= 3
                              : shape == Shape::polygon ? corners == 3 || corners == 4
                                                        : corners == 4;
        if (!is_right)
            fail(cell,
                 fmt::format("{} of {} points, expected triangles or quadrilaterals", type.name, corners));
    }

    template <typename Action>
    void for_each_cell(Action action) const {
        const std::span<const Index> corners(piece_.cells.corners);
        Index begin = 0;
        for (std::size_t cell = 0; cell < piece_.cells.types.size(); ++cell) {
            const Index end = piece_.cells.ends[cell];
            const Shape shape = cell_type(piece_.cells.types[cell]).shape;
            const bool is_left_out = !piece_.is_left_out.empty() && piece_.is_left_out[cell];
            if (!is_left_out && shape != Shape::skipped)
                action(cell, shape, corners.subspan(begin, end - begin));
            begin = end;
        }
    }

    [[noreturn]] void fail(std::size_t cell, std::string_view what) const {
        throw InputError(fmt::format("{}: cell {} (counted from 0): {}", file_, cell, what));
    }

    const VtkPiece& piece_;
    std::string_view file_;
};

MeshField triangle_field(const MeshField& cells, std::span<const Index> cell_of) {
    MeshField field{cells.name, cells.components, {}};
    field.values.reserve(cell_of.size() * cells.components);
    for (const Index cell : cell_of) {
        const auto values = std::span(cells.values).subspan(cell * cells.components, cells.components);
        field.values.insert(field.values.end(), values.begin(), values.end());
    }
    return field;
}

template <typename Value>
void append_all(std::vector<Value>& values, const std::vector<Value>& more) {
    values.insert(values.end(), more.begin(), more.end());
}

void append_fields(std::vector<MeshField>& fields, const std::vector<MeshField>& more,
                   std::string_view file) {
    const auto same_field = [&more](const MeshField& field) {
        return std::ranges::find_if(more, [&field](const MeshField& other) {
            return other.name == field.name && other.components == field.components;
        });
    };
    const auto is_in_both = [&](const MeshField& field) { return same_field(field) != more.end(); };
    if (fields.size() != more.size() || !std::ranges::all_of(fields, is_in_both))
        throw InputError(
            fmt::format("{}: a piece has other fields, expected those of the first piece", file));
    for (MeshField& field : fields) append_all(field.values, same_field(field)->values);
}

}  // namespace

bool is_time_array(std::string_view name) {
    return name == "TimeValue" || name == "TIME";
}

std::optional<double> time_in(const NumberArray& array) {
    if (array.bytes.size() != size_of(array.type)) return std::nullopt;
    const double time = doubles_of(array).front();
    return std::isfinite(time) ? std::optional(time) : std::nullopt;
}

void append_cells(VtkCells& cells, const VtkCells& more, std::string_view file) {
    const std::size_t first_corner = cells.corners.size();
    if (more.corners.size() >= no_index - first_corner)
        throw InputError(fmt::format("{}: more than 2^32 - 2 corners of cells", file));
    append_all(cells.types, more.types);
    append_all(cells.corners, more.corners);
    for (const Index end : more.ends) cells.ends.push_back(static_cast<Index>(first_corner) + end);
}

std::vector<bool> left_out_cells(const std::vector<std::uint8_t>& marks, bool are_levels) {
    constexpr unsigned left_out = 1 + 8 + 32;  // a copy, refined, hidden: vtkDataSetAttributes.h
    std::vector<bool> result;
    result.reserve(marks.size());
    for (const std::uint8_t mark : marks) result.push_back(are_levels ? mark > 0 : (mark & left_out) != 0);
    return result;
}

FieldMesh mesh_of(VtkPiece piece, std::string_view file) {
    FieldMesh mesh;
    TriangleMaker(piece, file).make(mesh);
    std::size_t values = 0;
    for (const MeshField& field : piece.cell_fields) values += field.components * mesh.triangles.size();
    if (values > piece.content_size + 1'000'000)
        throw InputError(fmt::format("{}: more values of cells than a file of its size can have", file));
    for (const MeshField& field : piece.cell_fields)
        mesh.triangle_fields.push_back(triangle_field(field, mesh.cell_of));
    mesh.points = std::move(piece.points);
    mesh.point_fields = std::move(piece.point_fields);
    return mesh;
}

void append(FieldMesh& mesh, FieldMesh more, std::string_view file) {
    if (more.points.empty() && more.triangles.empty()) return;
    if (mesh.points.empty() && mesh.triangles.empty()) {
        mesh = std::move(more);
        return;
    }
    append_fields(mesh.point_fields, more.point_fields, file);
    // A piece without cells has no fields of cells, whatever the other pieces have.
    if (mesh.triangles.empty())
        mesh.triangle_fields = std::move(more.triangle_fields);
    else if (!more.triangles.empty())
        append_fields(mesh.triangle_fields, more.triangle_fields, file);
    const std::size_t first_point = mesh.points.size();
    const Index first_cell = mesh.cell_of.empty() ? 0 : mesh.cell_of.back() + 1;
    if (more.points.size() >= no_index - first_point)
        throw InputError(fmt::format("{}: more than 2^32 - 2 points", file));
    for (std::array<Index, 3>& triangle : more.triangles)
        for (Index& corner : triangle) corner += static_cast<Index>(first_point);
    for (Index& cell : more.cell_of) cell += first_cell;
    append_all(mesh.points, more.points);
    append_all(mesh.triangles, more.triangles);
    append_all(mesh.cell_of, more.cell_of);
}

}  // namespace interleaf
