#include "io/vtk/legacy_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/text/json_place.h"
#include "io/text/words.h"
#include "io/vtk/number_array.h"
#include "io/vtk/vtk_piece.h"
#include "text/parsed_number.h"

namespace interleaf {
namespace {

std::string in_lower_case(std::string_view word) {
    std::string result(word);
    for (char& c : result)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
}

/// \p name with each %NN replaced by the character that it stands for.
std::string decoded_name(std::string_view name) {
    std::string result;
    while (!name.empty()) {
        unsigned code = 0;
        const bool is_code =
            name.size() >= 3 && name[0] == '%' &&
            std::from_chars(name.data() + 1, name.data() + 3, code, 16).ptr == name.data() + 3;
        result += is_code ? static_cast<char>(code) : name[0];
        name.remove_prefix(is_code ? 3 : 1);
    }
    return result;
}

/// Cells of one section of polygons; their corners go to the piece when all sections are known.
struct LegacyCells {
    std::string_view section;
    std::uint8_t type;
    VtkCells cells{};
};

class LegacyReader {
  public:
    LegacyReader(std::string_view bytes, const std::string& file) : rest_(bytes), file_(file) {
        piece_.content_size = bytes.size();
    }

    FieldMesh read() {
        read_head();
        while (true) {
            const std::string section = in_lower_case(next_word());
            if (section.empty()) break;
            read_section(section);
        }
        for (LegacyCells& kind : polygons_) append_cells(piece_.cells, kind.cells, file_);
        check_counts();
        FieldMesh mesh = mesh_of(std::move(piece_), file_);
        mesh.time = time_;
        return mesh;
    }

  private:
    enum class Association { none, points, cells };

    // The text: words and lines.

    std::string_view next_word() {
        Words words(rest_);
        const std::string_view word = words.next();
        rest_ = words.rest();
        return word;
    }

    std::string_view next_line() { return rest_.empty() ? std::string_view{} : take_line(rest_); }

    std::size_t next_count(std::string_view section) {
        const std::string_view word = next_word();
        const auto number = parsed_number<std::uint32_t>(word);
        if (!number || *number >= no_index)
            fail(fmt::format("{}: {}, expected a whole number in [0, 2^32 - 2]", section, in_quotes(word)));
        return *number;
    }

    DataType next_type(std::string_view section) {
        const std::string_view word = next_word();
        const auto type = legacy_data_type(in_lower_case(word));
        if (!type)
            fail(fmt::format("{}: type {}, expected one such as float or int", section, in_quotes(word)));
        return *type;
    }

    [[noreturn]] void fail(std::string_view what) const {
        throw InputError(fmt::format("{}: {}", file_, what));
    }

    // Sections.

    void read_head() {
        if (!next_line().starts_with("# vtk DataFile Version"))
            fail("expected a VTK file, with \"# vtk DataFile Version\" at its beginning");
        next_line();
        const std::string form = in_lower_case(next_word());
        if (form != "ascii" && form != "binary")
            fail(fmt::format("line 3: {}, expected ASCII or BINARY", in_quotes(form)));
        is_binary_ = form == "binary";
        const std::string keyword = in_lower_case(next_word());
        const std::string type = in_lower_case(next_word());
        if (keyword != "dataset" || (type != "unstructured_grid" && type != "polydata"))
            fail(fmt::format("{} {}, expected DATASET UNSTRUCTURED_GRID or DATASET POLYDATA",
                             in_quotes(keyword), in_quotes(type)));
    }

    void read_section(const std::string& section) {
        const auto polygons = std::ranges::find(polygons_, section, &LegacyCells::section);
        if (section == "points") {
            read_points();
        } else if (section == "cells") {
            piece_.cells = read_cells("CELLS");
        } else if (section == "cell_types") {
            read_cell_types();
        } else if (polygons != polygons_.end()) {
            polygons->cells = read_cells(section);
            polygons->cells.types.assign(polygons->cells.ends.size(), polygons->type);
        } else if (section == "point_data" || section == "cell_data") {
            association_ = section == "point_data" ? Association::points : Association::cells;
            tuples_ = next_count(section);
        } else if (section == "metadata") {
            read_metadata();
        } else {
            read_attributes(section);
        }
    }

    void read_points() {
        const std::size_t count = next_count("POINTS");
        const ArrayPlace place{file_, "POINTS", "point", count, 3};
        const std::vector<double> values = finite_numbers(numbers(next_type("POINTS"), place), place);
        piece_.points.clear();
        piece_.points.reserve(count);
        for (std::size_t n = 0; n < values.size(); n += 3)
            piece_.points.emplace_back(values[n], values[n + 1], values[n + 2]);
    }

    /// Cells without types. From version 5 on, they are two arrays: offsets and points.
    VtkCells read_cells(const std::string& section) {
        const std::size_t count = next_count(section);
        const std::size_t size = next_count(section);
        const std::string_view after = rest_;
        if (is_word(next_word(), "offsets")) return read_offsets_and_points(section, count, size);
        rest_ = after;
        const ArrayPlace place{file_, section, "number", size};
        const std::vector<Index> list = indices_below(numbers(DataType::int32, place), no_index, place);
        VtkCells cells;
        cells.ends.reserve(std::min(count, size));
        cells.corners.reserve(size - std::min(count, size));
        std::size_t at = 0;
        for (std::size_t cell = 0; cell < count; ++cell) {
            if (at >= size || list[at] > size - at - 1)
                fail(fmt::format("{}: ends within cell {} (counted from 0)", section, cell));
            const auto begin = list.begin() + static_cast<std::ptrdiff_t>(at + 1);
            cells.corners.insert(cells.corners.end(), begin, begin + static_cast<std::ptrdiff_t>(list[at]));
            at += list[at] + 1;
            cells.ends.push_back(static_cast<Index>(cells.corners.size()));
        }
        return cells;
    }

    VtkCells read_offsets_and_points(const std::string& section, std::size_t offsets, std::size_t corners) {
        VtkCells cells;
        const ArrayPlace at_offsets{file_, section + " OFFSETS", "offset", offsets};
        cells.ends = indices_below(numbers(next_type(section), at_offsets), no_index, at_offsets);
        if (!cells.ends.empty()) cells.ends.erase(cells.ends.begin());
        if (const std::string_view word = next_word(); !is_word(word, "connectivity"))
            fail(fmt::format("{}: {}, expected CONNECTIVITY", section, in_quotes(word)));
        const ArrayPlace at_corners{file_, section + " CONNECTIVITY", "value", corners};
        cells.corners = indices_below(numbers(next_type(section), at_corners), no_index, at_corners);
        return cells;
    }

    void read_cell_types() {
        const ArrayPlace place{file_, "CELL_TYPES", "cell", next_count("CELL_TYPES")};
        piece_.cells.types = small_numbers(numbers(DataType::int32, place), place);
    }

    // Fields.

    void read_attributes(const std::string& kind) {
        if (kind == "field") return read_field_arrays();
        const std::string name = decoded_name(next_word());
        if (kind == "scalars") {
            const DataType type = next_type(name);
            const std::size_t width = next_components();
            skip_name_of_colors();
            read_field(name, type, width);
        } else if (kind == "vectors" || kind == "normals") {
            read_field(name, next_type(name), 3);
        } else if (kind == "tensors") {
            read_field(name, next_type(name), 9);
        } else if (kind == "tensors6") {
            read_field(name, next_type(name), 6);
        } else if (kind == "texture_coordinates") {
            const std::size_t width = next_count(name);
            read_field(name, next_type(name), width);
        } else if (kind == "color_scalars") {
            read_field(name, is_binary_ ? DataType::uint8 : DataType::float32, next_count(name));
        } else if (kind == "lookup_table") {
            const ArrayPlace place{file_, name, "color", next_count(name), 4};
            numbers(is_binary_ ? DataType::uint8 : DataType::float32, place);
        } else if (kind == "global_ids" || kind == "pedigree_ids") {
            const ArrayPlace place{file_, name, "value", tuples_};
            numbers(next_type(name), place);
        } else {
            fail(fmt::format("{}, expected a section such as POINTS, CELLS or POINT_DATA", in_quotes(kind)));
        }
    }

    /// The number of components, which may stand on the rest of the line.
    std::size_t next_components() {
        std::string_view line = rest_.substr(0, rest_.find('\n'));
        const std::string_view word = take_word(line);
        if (word.empty()) return 1;
        rest_.remove_prefix(static_cast<std::size_t>(line.data() - rest_.data()));
        return parsed_number<std::uint32_t>(word).value_or(0);
    }

    /// Some writers leave out the name of the table of colors.
    void skip_name_of_colors() {
        const std::string_view before = rest_;
        if (is_word(next_word(), "lookup_table"))
            next_word();
        else
            rest_ = before;
    }

    void read_field(const std::string& name, DataType type, std::size_t width) {
        if (association_ == Association::none)
            fail(fmt::format("{}: expected POINT_DATA or CELL_DATA before", name));
        const ArrayPlace place{file_, fmt::format("field {}", in_quotes(name)),
                               association_ == Association::points ? "point" : "cell", tuples_, width};
        if (width == 0) place.fail("no components, expected at least one");
        add_field(name, numbers(type, place), place);
    }

    /// FIELD: arrays of their own sizes, of the data set or of points or cells.
    void read_field_arrays() {
        const std::string field = decoded_name(next_word());
        const std::size_t arrays = next_count(field);
        for (std::size_t n = 0; n < arrays; ++n) {
            std::string_view word = next_word();
            while (is_word(word, "metadata")) {
                read_metadata();
                word = next_word();
            }
            if (word.empty()) fail(fmt::format("FIELD {}: ends after {} of {} arrays", field, n, arrays));
            const std::string name = decoded_name(word);
            ArrayPlace place{file_, fmt::format("field {}", in_quotes(name))};
            place.components = next_count(name);
            place.tuples = next_count(name);
            place.element = association_ == Association::points ? "point" : "cell";
            const NumberArray array = numbers(next_type(name), place);
            if (association_ == Association::none) {
                if (is_time_array(name) && !time_) time_ = time_in(array);
                continue;
            }
            if (place.tuples != tuples_)
                place.fail(fmt::format("{} values, expected one for each of {}", place.tuples, tuples_));
            if (place.components > 0) add_field(name, array, place);
        }
    }

    void add_field(const std::string& name, const NumberArray& array, const ArrayPlace& place) {
        const bool is_of_cells = association_ == Association::cells;
        const bool is_mark = name == "vtkGhostType" || name == "vtkGhostLevels";
        if (is_mark && is_of_cells)
            piece_.is_left_out = left_out_cells(small_numbers(array, place), name == "vtkGhostLevels");
        if (name.starts_with("vtk")) return;
        std::vector<MeshField>& fields = is_of_cells ? piece_.cell_fields : piece_.point_fields;
        last_field_ = &fields.emplace_back(MeshField{name, place.components, doubles_of(array)});
    }

    /// Names and notes about the last array, up to an empty line. A name may be empty, too. Of the notes, the unit
    /// of a field is taken: NAME UNITS_LABEL LOCATION vtkDataArray, and DATA on the next line.
    void read_metadata() {
        next_line();
        bool is_unit = false;
        while (!rest_.empty()) {
            std::string_view line = next_line();
            const std::string_view word = take_word(line);
            if (word.empty()) return;
            if (is_word(word, "data") && is_unit && last_field_ != nullptr)
                last_field_->unit = decoded_name(take_word(line));
            is_unit = is_word(word, "name") && take_word(line) == "UNITS_LABEL" &&
                      is_word(take_word(line), "location") && take_word(line) == "vtkDataArray";
            if (!is_word(word, "component_names")) continue;
            for (std::size_t n = 0; n < last_components_ && !rest_.empty(); ++n) next_line();
        }
    }

    // Numbers.

    /// The numbers of \p place: as words, or binary and big endian from the next line on.
    NumberArray numbers(DataType type, const ArrayPlace& place) {
        last_components_ = place.components;
        last_field_ = nullptr;
        if (!is_binary_) {
            Words words(rest_);
            NumberArray array = read_words(words, type, place);
            rest_ = words.rest();
            return array;
        }
        next_line();
        const std::size_t size = place.values() * size_of(type);
        if (size > rest_.size())
            place.fail(fmt::format("the data is cut off after {} bytes, expected {}", rest_.size(), size));
        NumberArray array{type, std::vector<std::byte>(size)};
        std::ranges::copy(std::as_bytes(std::span(rest_.substr(0, size))), array.bytes.begin());
        rest_.remove_prefix(size);
        if constexpr (std::endian::native == std::endian::little) swap_byte_order(array);
        return array;
    }

    /// Sections may come in any order, so their sizes are compared at the end.
    void check_counts() const {
        const VtkCells& cells = piece_.cells;
        if (cells.types.size() != cells.ends.size())
            fail(fmt::format("CELL_TYPES: {} types, expected one for each of the {} cells",
                             cells.types.size(), cells.ends.size()));
        for (std::size_t n = 0; n < cells.corners.size(); ++n)
            if (cells.corners[n] >= piece_.points.size())
                fail(fmt::format("cells: point {}, expected one in [0, {})", cells.corners[n],
                                 piece_.points.size()));
        check_fields(piece_.point_fields, piece_.points.size(), "points");
        check_fields(piece_.cell_fields, cells.ends.size(), "cells");
        if (!piece_.is_left_out.empty() && piece_.is_left_out.size() != cells.ends.size())
            fail(fmt::format("vtkGhostType: {} marks, expected one for each of the {} cells",
                             piece_.is_left_out.size(), cells.ends.size()));
    }

    void check_fields(const std::vector<MeshField>& fields, std::size_t tuples, std::string_view of) const {
        for (const MeshField& field : fields)
            if (field.values.size() != field.components * tuples)
                fail(fmt::format("field {}: {} values, expected {} for each of the {} {}",
                                 in_quotes(field.name), field.values.size(), field.components, tuples, of));
    }

    std::string_view rest_;
    const std::string& file_;
    bool is_binary_ = false;
    Association association_ = Association::none;
    std::size_t tuples_ = 0;           ///< of the association
    std::size_t last_components_ = 0;  ///< of the last array
    MeshField* last_field_ = nullptr;  ///< if the last array is a field
    std::optional<double> time_;
    VtkPiece piece_;
    /// In the order in which VTK numbers the cells.
    std::array<LegacyCells, 4> polygons_ = {{{"vertices", vertex_cells},
                                             {"lines", line_cells},
                                             {"polygons", polygon_cells},
                                             {"triangle_strips", strip_cells}}};
};

}  // namespace

FieldMesh parse_legacy_vtk(std::string_view bytes, const std::string& name) {
    return LegacyReader(bytes, name).read();
}

}  // namespace interleaf
