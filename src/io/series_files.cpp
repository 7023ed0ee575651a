#include "io/series_files.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "hierarchy/field.h"
#include "io/file/file_pattern.h"
#include "io/file/input_file.h"
#include "io/formats.h"
#include "io/read_files.h"
#include "io/text/json_place.h"
#include "io/text/words.h"
#include "io/vtk/legacy_file.h"
#include "io/vtk/vtk_piece.h"
#include "io/vtk/xml_document.h"
#include "io/vtk/xml_file.h"
#include "text/characters.h"
#include "text/natural_order.h"

namespace interleaf {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t max_collection_size = std::uint64_t{64} << 20U;
constexpr std::uint64_t max_legacy_size = std::uint64_t{4} << 30U;

struct TimedFile {
    fs::path file;
    double time = 0;
    std::size_t part = 0;
};

/// The file \p name of a list in \p folder; none if there is no such file.
std::optional<fs::path> listed_file(const fs::path& folder, const std::string& name) {
    fs::path file = folder / name;
    std::error_code ignored;
    if (name.empty() || !fs::exists(file, ignored)) return std::nullopt;
    return file;
}

/// The steps of \p files. The files of one time are the parts of one step.
/// \param expected  instead of two files with the same time and part
SeriesFiles in_order_of_time(std::vector<TimedFile> files, const std::string& series,
                             std::string_view expected) {
    const auto place = [](const TimedFile& file) { return std::pair(file.time, file.part); };
    std::ranges::stable_sort(files, {}, place);
    const auto same = std::ranges::adjacent_find(files, {}, place);
    if (same != files.end())
        throw InputError(fmt::format("{}: {} and {} are both at time {}, expected {}", series,
                                     same->file.string(), std::next(same)->file.string(), same->time,
                                     expected));
    SeriesFiles result;
    std::set<fs::path> parts;  // of the step
    for (TimedFile& file : files) {
        const bool begins_step = result.times.empty() || result.times.back() != file.time;
        if (begins_step) parts.clear();
        if (!parts.insert(file.file.lexically_normal()).second)
            throw InputError(
                fmt::format("{}: {} is there twice at time {}", series, file.file.string(), file.time));
        if (begins_step) {
            result.files.push_back(std::move(file.file));
            result.times.push_back(file.time);
            result.further_parts.emplace_back();
        } else {
            result.further_parts.back().push_back(std::move(file.file));
        }
    }
    return result;
}

SeriesFiles read_collection(const fs::path& collection) {
    const XmlDocument document(read_text(collection, max_collection_size), collection.string());
    if (document.type() != "Collection")
        document.fail(fmt::format("data of type {}, expected Collection", in_quotes(document.type())));
    std::vector<TimedFile> steps;
    std::set<double> times;
    for (const pugi::xml_node element : document.data_set().children("DataSet")) {
        const std::string name = element.attribute("file").value();
        const std::string_view word = without_blanks(element.attribute("timestep").value());
        const std::size_t part = document.count(element, "part", 0);
        const bool belongs_to_last = part > 0 && !steps.empty();
        const std::optional<double> time = !word.empty()     ? parse_double(word)
                                           : belongs_to_last ? steps.back().time
                                                             : static_cast<double>(times.size());
        if (!time)
            document.fail(fmt::format("DataSet {} (counted from 0): timestep {}, expected a number",
                                      steps.size(), in_quotes(word)));
        times.insert(*time);
        const std::optional<fs::path> file = listed_file(collection.parent_path(), name);
        if (!file)
            document.fail(fmt::format("DataSet {} (counted from 0): there is no file {}", steps.size(),
                                      in_quotes(name)));
        steps.push_back({*file, *time, part});
    }
    if (steps.empty()) document.fail("has no files, expected DataSet elements");
    return in_order_of_time(std::move(steps), collection.string(),
                            "one file per time, or parts with different numbers");
}

SeriesFiles read_json_series(const fs::path& series) {
    const nlohmann::json document = parse_json(read_text(series, max_collection_size), series.string());
    const JsonPlace root(document, series.string());
    const JsonPlace version = root.member("file-series-version");
    if (version.string() != "1.0") version.fail_expecting("\"1.0\"");
    const JsonPlace files = root.member("files");
    std::vector<TimedFile> steps;
    for (std::size_t n = 0; n < files.size(); ++n) {
        const JsonPlace name = files.element(n).member("name");
        const std::optional<fs::path> file = listed_file(series.parent_path(), name.string());
        if (!file) name.fail(fmt::format("there is no file {}", in_quotes(name.string())));
        steps.push_back({*file, files.element(n).member("time").number(), 0});
    }
    if (steps.empty()) files.fail("has no files, expected at least one");
    return in_order_of_time(std::move(steps), series.string(), "one file per time");
}

/// The numbers in \p name, with the dots and signs between them left out.
std::vector<std::string_view> digits_in(std::string_view name) {
    std::vector<std::string_view> numbers;
    while (true) {
        constexpr std::string_view digits = "0123456789";
        name.remove_prefix(std::min(name.find_first_of(digits), name.size()));
        if (name.empty()) return numbers;
        numbers.push_back(name.substr(0, name.find_first_not_of(digits)));
        name.remove_prefix(numbers.back().size());
    }
}

/// The one number in the name of each file that differs; none if there is no such number.
std::vector<double> numbers_of(std::span<const fs::path> files) {
    std::vector<std::string> names;
    for (const fs::path& file : files) names.push_back(file.filename().string());
    const auto same_but_numbers = [&](const std::string& name) {
        return without_numbers(name) == without_numbers(names.front());
    };
    if (files.size() < 2 || !std::ranges::all_of(names, same_but_numbers)) return {};
    const std::vector<std::string_view> first = digits_in(names.front());
    std::optional<std::size_t> place;
    for (const std::string& name : names)
        for (std::size_t n = 0; n < first.size(); ++n) {
            if (digits_in(name)[n] == first[n]) continue;
            if (place && *place != n) return {};
            place = n;
        }
    if (!place) return {};
    std::vector<double> numbers;
    for (const std::string& name : names) {
        numbers.push_back(parse_double(digits_in(name)[*place]).value_or(0));
        if (numbers.size() > 1 && numbers.back() <= numbers[numbers.size() - 2]) return {};
    }
    return numbers;
}

FieldMesh mesh_of_surface(SurfaceFile surface) {
    FieldMesh mesh;
    mesh.points = std::move(surface.positions);
    mesh.triangles = std::move(surface.triangles);
    for (Index cell = 0; cell < mesh.triangles.size(); ++cell) mesh.cell_of.push_back(cell);
    if (surface.colors.empty()) return mesh;
    MeshField colors{"color", 3, {}};
    for (const glm::vec3& color : surface.colors)
        colors.values.insert(colors.values.end(), {double{color.r}, double{color.g}, double{color.b}});
    mesh.point_fields.push_back(std::move(colors));
    return mesh;
}

FieldMesh read_any_mesh(const fs::path& file) {
    const std::string extension = lower_case_extension(file);
    if (extension == ".vtk") return parse_legacy_vtk(read_text(file, max_legacy_size), file.string());
    if (extension.starts_with(".vt") || extension.starts_with(".pvt")) return read_vtk_xml(file);
    return mesh_of_surface(read_surface(file));
}

FieldMesh read_parts(const fs::path& first, std::span<const fs::path> further) {
    FieldMesh mesh = read_any_mesh(first);
    for (const fs::path& part : further) append(mesh, read_any_mesh(part), part.string());
    if (mesh.triangles.empty())
        throw InputError(fmt::format("{}: has no triangles, expected at least one", first.string()));
    return mesh;
}

/// Moves the components of the point fields of \p mesh to \p surface, with remarks about those that a key cannot have.
void take_scalars(const FieldMesh& mesh, SurfaceFile& surface) {
    constexpr double most = std::numeric_limits<float>::max();
    for (const MeshField& field : mesh.point_fields)
        for (std::size_t component = 0; component < field.components; ++component) {
            MeshField scalar{component_name(field, component), 1, {}};
            for (std::size_t n = component; n < field.values.size(); n += field.components)
                scalar.values.push_back(field.values[n]);
            const bool is_new =
                std::ranges::find(surface.scalars, scalar.name, &MeshField::name) == surface.scalars.end();
            const bool is_finite =
                std::ranges::all_of(scalar.values, [](double value) { return std::abs(value) <= most; });
            if (is_new && is_finite && is_field_name(scalar.name) &&
                surface.scalars.size() < max_mesh_scalars)
                surface.scalars.push_back(std::move(scalar));
            else
                surface.remarks.push_back(
                    fmt::format("Field {} was left out: {}.", in_quotes(scalar.name),
                                is_finite ? "its name cannot be that of a field, or there are too many"
                                          : "not all finite"));
        }
}

}  // namespace

SeriesFiles series_files(std::span<const fs::path> paths) {
    if (paths.size() == 1) {
        const std::string extension = lower_case_extension(paths.front());
        if (extension == ".pvd") return read_collection(paths.front());
        if (extension == ".series") return read_json_series(paths.front());
    }
    SeriesFiles series{.files = {}, .times = {}, .further_parts = {}, .are_steps = true};
    for (const fs::path& path : paths)
        std::ranges::move(matching_files(path), std::back_inserter(series.files));
    series.times = numbers_of(series.files);
    for (std::size_t n = series.times.size(); n < series.files.size(); ++n)
        series.times.push_back(static_cast<double>(n));
    series.further_parts.resize(series.files.size());
    return series;
}

std::string series_name(const fs::path& path) {
    const fs::path name = path.stem();
    const bool is_list_of_files =
        lower_case_extension(path) == ".series" && is_called(name, &Format::holds_series);
    return (is_list_of_files ? name.stem() : name).string();
}

FieldMesh read_field_mesh(const fs::path& file) {
    return read_parts(file, {});
}

FieldMesh read_step_mesh(const SeriesFiles& series, std::size_t step) {
    return read_parts(series.files[step], series.further_parts[step]);
}

SurfaceFile read_mesh_to_fit(const fs::path& file) {
    if (!is_called(file, &Format::holds_series)) return read_surface(file);
    FieldMesh mesh = read_field_mesh(file);
    SurfaceFile surface;
    take_scalars(mesh, surface);
    surface.positions = std::move(mesh.points);
    surface.triangles = std::move(mesh.triangles);
    return surface;
}

}  // namespace interleaf
