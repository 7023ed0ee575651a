#include "app/cli/info_command.h"

#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/cli/figures.h"
#include "app/cli/mesh_figures.h"
#include "app/document/opening.h"
#include "family/family_fields.h"
#include "family/family_time.h"
#include "hierarchy/error.h"
#include "io/family/family_file.h"
#include "io/formats.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/series_files.h"
#include "text/shown_text.h"
#include "text/value_text.h"
#include "ui/widgets/number_text.h"

namespace interleaf {
namespace {

using Json = nlohmann::ordered_json;

enum class Kind { hierarchy, family, mesh };

std::string_view name_of(Kind kind) {
    constexpr std::array<std::string_view, 3> names = {"hierarchy", "family", "mesh"};
    return names[static_cast<std::size_t>(kind)];
}

std::string_view form_of(const std::filesystem::path& file) {
    if (!is_called(file, &Format::holds_key_alone)) return {};
    return is_compressed_hierarchy(file) ? "compressed" : "plain";
}

/// The figures of each key.
/// \param files  the file of each key, or the only file of all keys, which counts for none of them
std::vector<Figures> figures_of(const Family& family, std::span<const std::filesystem::path> files) {
    std::vector<Figures> figures;
    figures.reserve(family.keys.size());
    for (std::size_t i = 0; i < family.keys.size(); ++i) {
        const bool has_file = files.size() == family.keys.size();
        figures.push_back(
            figures_of(*family.keys[i].hierarchy, has_file ? std::filesystem::file_size(files[i]) : 0));
        if (has_file) figures.back().form = form_of(files[i]);
    }
    return figures;
}

/// The figures of the key of each step of \p series. A step of several parts has the size of all their files.
std::vector<Figures> figures_of(const Family& family, const SeriesFiles& series) {
    std::vector<Figures> figures = figures_of(family, series.files);
    for (std::size_t step = 0; step < figures.size(); ++step)
        for (const std::filesystem::path& part : series.further_parts[step])
            figures[step].file += std::filesystem::file_size(part);
    return figures;
}

/// The figures of all keys together.
Figures figures_of_keys(std::span<const Figures> keys) {
    Figures whole = total(keys);
    whole.form = {};
    return whole;
}

/// The figures of all keys together, whose file size includes the family file.
Figures figures_of_family(const std::filesystem::path& file, std::span<const Figures> keys) {
    Figures whole = figures_of_keys(keys);
    const bool is_folder = std::filesystem::is_directory(file);
    whole.file += std::filesystem::file_size(is_folder ? file / "family.json" : file);
    return whole;
}

Json json_of(const glm::vec3& p) {
    return {p.x, p.y, p.z};
}

Json json_of(const glm::dvec3& p) {
    return {p.x, p.y, p.z};
}

/// Figures that do not exist are null: the volume of an open surface, the handles of a one-sided surface.
Json json_of(const SurfaceCensus& census) {
    Json json = {{"area", census.area},
                 {"parts", census.parts},
                 {"openings", census.openings},
                 {"crowded_edges", census.crowded_edges}};
    json["volume"] = census.volume ? Json(*census.volume) : Json();
    json["handles"] = census.handles ? Json(*census.handles) : Json();
    return json;
}

Json json_of(const Figures& figures) {
    Json json = {{"roots", figures.roots},
                 {"leaves", figures.leaves},
                 {"vertices", figures.vertices},
                 {"levels", {{"min", figures.min_level}, {"max", figures.max_level}}},
                 {"bytes", {{"memory", figures.memory}, {"file", figures.file}}},
                 {"angles", {{"min", figures.min_angle}}},
                 {"euler", figures.euler},
                 {"boundary_edges", figures.boundary},
                 {"box", {json_of(figures.box.min), json_of(figures.box.max)}}};
    if (!figures.form.empty()) json["form"] = figures.form;
    return json;
}

Json json_of(const FamilyField& field) {
    Json json = {{"name", field.label.name},
                 {"kind", name_of(field.label.kind)},
                 {"min", double{field.min} + field.offset},
                 {"max", double{field.max} + field.offset}};
    if (field.offset != 0) json["offset"] = field.offset;
    if (!field.unit.empty()) json["unit"] = field.unit;
    return json;
}

Json json_of(const std::vector<FamilyField>& fields) {
    Json json = Json::array();
    for (const FamilyField& field : fields) json.push_back(json_of(field));
    return json;
}

Json json_of(const Timeline& timeline, const Family& family) {
    Json keys = Json::array();
    for (const TimelineKey& key : timeline.keys()) {
        keys.push_back({{"time", key.time}, {"key", family.keys[key.key].name}});
    }
    const Interpolation& interpolation = timeline.interpolation();
    Json json = {{"begin", timeline.begin()},
                 {"end", timeline.end()},
                 {"interpolation", name_of(interpolation.basis)},
                 {"keys", keys}};
    if (interpolation.degree > 0) json["degree"] = interpolation.degree;
    return json;
}

/// "bernstein of degree 3".
std::string text_of(const Interpolation& interpolation) {
    const std::string name(name_of(interpolation.basis));
    return interpolation.degree > 0 ? fmt::format("{} of degree {}", name, interpolation.degree) : name;
}

Json json_of(const ParameterDomain& domain, const Family& family) {
    Json vertices = Json::array();
    for (const DomainVertex& vertex : domain.vertices()) {
        vertices.push_back({{"at", {vertex.at.x, vertex.at.y}}, {"key", family.keys[vertex.key].name}});
    }
    return {{"vertices", vertices}, {"triangles", domain.triangles()}};
}

Json path_json(const Family& family) {
    return {{"points", family.path->points().size()},
            {"begin", family.path->begin()},
            {"end", family.path->end()},
            {"drives", source_of_time(family) == TimeSource::path}};
}

void print(const Json& document) {
    fmt::print("{}\n", document.dump(2, ' ', false, Json::error_handler_t::replace));
}

void print_json(Kind kind, const Family& family, std::span<const Figures> keys, const Figures& whole) {
    Json document = {{"kind", name_of(kind)}, {"name", family.name}};
    document.update(json_of(whole));
    document["fields"] = json_of(fields_of(family));
    if (kind == Kind::family) {
        document["keys"] = Json::array();
        for (std::size_t i = 0; i < keys.size(); ++i) {
            Json key = {{"name", family.keys[i].name}};
            key.update(json_of(keys[i]));
            key.update(json_of(census_as_it_is(surface_of(*family.keys[i].hierarchy))));
            key["fields"] = json_of(fields_of(std::span(&family.keys[i], 1), family.field_scales));
            document["keys"].push_back(std::move(key));
        }
    }
    if (family.origin != glm::dvec3(0)) document["origin"] = json_of(family.origin);
    if (kind == Kind::hierarchy)
        document.update(json_of(census_as_it_is(surface_of(*family.keys.front().hierarchy))));
    if (family.blend != BlendKind::straight) document["blend"] = name_of(family.blend);
    if (family.timeline) document["timeline"] = json_of(*family.timeline, family);
    if (family.domain) document["domain"] = json_of(*family.domain, family);
    if (family.path) document["path"] = path_json(family);
    print(document);
}

std::string levels(const Figures& figures) {
    return fmt::format("{} to {}", figures.min_level, figures.max_level);
}

std::string text_of(const glm::dvec3& p) {
    const auto number = [](double x) {
        return std::abs(x) < 1e4 ? fmt::format("{:.4g}", x) : fmt::format("{:.3f}", x);
    };
    return fmt::format("({}, {}, {})", number(p.x), number(p.y), number(p.z));
}

/// The size of a file in words: "52,340 bytes, compressed, 1.31 bytes per leaf".
std::string file_text(const Figures& figures) {
    std::string bytes = grouped(figures.file) + " bytes";
    if (figures.form.empty()) return bytes;
    return fmt::format("{}, {}, {:.2f} bytes per leaf", bytes, figures.form,
                       static_cast<double>(figures.file) / static_cast<double>(figures.leaves));
}

void print_line(std::string_view label, std::string_view text) {
    fmt::print("{:<14}{}\n", label, text);
}

void print_census(const SurfaceCensus& census) {
    print_line("area", fmt::format("{:.6g}", census.area));
    print_line("volume", census.volume ? fmt::format("{:.6g}", *census.volume) : "none, not closed");
    print_line("parts", in_words(census));
    if (census.crowded_edges > 0)
        print_line("crowded", grouped(census.crowded_edges) + " edges of more than two triangles");
}

void print_whole(Kind kind, const Family& family, const Figures& whole) {
    print_line(name_of(kind), shown_text(family.name));
    print_line("roots", grouped(whole.roots));
    print_line("leaves", grouped(whole.leaves));
    print_line("vertices", grouped(whole.vertices));
    print_line("levels", levels(whole));
    print_line("memory", grouped(whole.memory) + " bytes");
    print_line("file", file_text(whole));
    print_line("least angle", fmt::format("{:.1f} degrees", whole.min_angle));
    print_line("Euler number", fmt::format("{}", whole.euler));
    print_line("boundary", whole.boundary == 0 ? "none" : grouped(whole.boundary) + " root edges");
    print_line("box", text_of(glm::dvec3(whole.box.min)) + " to " + text_of(glm::dvec3(whole.box.max)));
}

/// "0 to 1.5 m/s".
std::string range_text(const FamilyField& field) {
    if (field.offset != 0) {
        const double min = double{field.min} + field.offset;
        const double max = double{field.max} + field.offset;
        const std::string text =
            max > min ? fmt::format("{} to {}", value_text(min, max - min), value_text(max, max - min))
                      : fmt::format("{:.10g} to {:.10g}", min, max);
        return with_unit(text, field.unit);
    }
    return with_unit(fmt::format("{:.6g} to {:.6g}", field.min, field.max), field.unit);
}

/// Prints the fields. A scalar field is printed with its range over all keys that have the field.
void print_fields(const std::vector<FamilyField>& fields) {
    if (fields.empty()) return;
    fmt::print("\nfields\n");
    for (const FamilyField& field : fields) {
        const bool is_color = field.label.kind == FieldKind::color;
        print_line(name_of(field.label.kind),
                   is_color ? field.label.name : fmt::format("{}  {}", field.label.name, range_text(field)));
    }
}

void print_keys(const Family& family, std::span<const Figures> keys) {
    constexpr std::string_view row = "{:<20}{:>12}{:>12}{:>12}{:>14}{:>14}{:>14}  {}\n";
    fmt::print("\n");
    fmt::print(row, "key", "leaves", "vertices", "levels", "least angle", "memory", "file", "form");
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const Figures& key = keys[i];
        fmt::print(row, family.keys[i].name, grouped(key.leaves), grouped(key.vertices), levels(key),
                   fmt::format("{:.1f}", key.min_angle), grouped(key.memory), grouped(key.file), key.form);
    }
}

void print_blend(const Family& family) {
    if (family.blend != BlendKind::straight) fmt::print("\nblend {}\n", name_of(family.blend));
}

void print_timeline(const Timeline& timeline, const Family& family) {
    fmt::print("\ntimeline, {}, {}\n",
               family.time_unit.empty() ? name_of(timeline.unit()) : std::string_view(family.time_unit),
               text_of(timeline.interpolation()));
    for (const TimelineKey& key : timeline.keys())
        fmt::print("{:>12.4g}  {}\n", key.time, family.keys[key.key].name);
}

void print_domain(const ParameterDomain& domain, const Family& family) {
    fmt::print("\nparameter domain, {} triangles\n", domain.triangles().size());
    for (const DomainVertex& vertex : domain.vertices()) {
        fmt::print("{:>12}  {}\n", fmt::format("{:.4g},{:.4g}", vertex.at.x, vertex.at.y),
                   family.keys[vertex.key].name);
    }
}

void print_path(const Family& family) {
    const DomainPath& path = *family.path;
    const bool drives = source_of_time(family) == TimeSource::path;
    fmt::print("\npath through the domain, {} points, {:.4g} to {:.4g} seconds, {}\n",
               grouped(path.points().size()), path.begin(), path.end(),
               drives ? "drives the blend over time" : "the timeline drives");
}

void print_text(Kind kind, const Family& family, std::span<const Figures> keys, const Figures& whole) {
    print_whole(kind, family, whole);
    if (kind == Kind::hierarchy) print_census(census_as_it_is(surface_of(*family.keys.front().hierarchy)));
    if (family.origin != glm::dvec3(0)) print_line("origin", text_of(family.origin));
    print_fields(fields_of(family));
    if (kind == Kind::family) print_keys(family, keys);
    print_blend(family);
    if (family.timeline) print_timeline(*family.timeline, family);
    if (family.domain) print_domain(*family.domain, family);
    if (family.path) print_path(family);
}

/// The figures of a mesh as a key. A mesh is also a key if its faces can be roots; otherwise there are none.
std::optional<Figures> figures_as_key(const std::filesystem::path& file) {
    if (!is_called(file, &Format::holds_key)) return std::nullopt;
    const auto read = find_format(file)->read_keys(std::span(&file, 1), std::nullopt);
    const auto* const keys = std::get_if<FileKeys>(&read);
    if (keys == nullptr) return std::nullopt;
    return figures_of(keys->keys.front(), std::filesystem::file_size(file));
}

void print_mesh(const std::filesystem::path& file, bool as_json) {
    const MeshFigures mesh = figures_of_mesh(file);
    const std::optional<Figures> key = figures_as_key(file);
    if (as_json) {
        Json document = {{"kind", name_of(Kind::mesh)}, {"name", file.stem().string()}};
        if (key) document.update(json_of(*key));
        document.update({{"vertices", mesh.census.vertices},
                         {"triangles", mesh.census.triangles},
                         {"bytes", {{"file", mesh.file}}},
                         {"angles", {{"min", mesh.min_angle}}},
                         {"box", {json_of(mesh.box_min), json_of(mesh.box_max)}},
                         {"welded_vertices", mesh.census.welded_vertices},
                         {"removed_triangles", mesh.census.removed_triangles},
                         {"colors", mesh.has_colors},
                         {"remarks", mesh.remarks}});
        document.update(json_of(mesh.census));
        print(document);
        return;
    }
    print_line(name_of(Kind::mesh), shown_text(file.stem().string()));
    print_line("vertices", grouped(mesh.census.vertices));
    print_line("triangles", grouped(mesh.census.triangles));
    print_census(mesh.census);
    if (mesh.census.welded_vertices > 0)
        print_line("welded", grouped(mesh.census.welded_vertices) + " vertices");
    if (mesh.census.removed_triangles > 0)
        print_line("removed", grouped(mesh.census.removed_triangles) + " double or degenerate triangles");
    print_line("least angle", fmt::format("{:.1f} degrees", mesh.min_angle));
    print_line("box", text_of(mesh.box_min) + " to " + text_of(mesh.box_max));
    print_line("colors", mesh.has_colors ? "yes" : "none");
    print_line("file", grouped(mesh.file) + " bytes");
    print_line("as a key", key ? fmt::format("{} roots", grouped(key->roots)) : "by `interleaf fit`");
    for (const std::string& remark : mesh.remarks) print_line("read", shown_text(remark));
}

/// Whether a file that also holds a mesh to fit has a family of several keys.
bool holds_several_keys(const std::filesystem::path& file) {
    if (!is_called(file, &Format::holds_mesh) || !is_called(file, &Format::holds_family)) return false;
    try {
        return find_format(file)->read_family(file, nullptr).keys.size() > 1;
    } catch (const InputError&) {
        return false;  // a mesh that is no key
    }
}

}  // namespace

void run_info(const InfoOptions& options) {
    const std::vector<std::filesystem::path> files = files_of(std::span(&options.file, 1));
    const std::filesystem::path& first = files.front();
    const bool has_family = holds_several_keys(first);
    if (files.size() == 1 && is_called(first, &Format::holds_mesh) && !has_family)
        return print_mesh(first, options.json);

    Opening opened = open_files(files);
    const bool is_family = std::holds_alternative<OpenedFamily>(opened);
    const bool is_series = std::holds_alternative<SeriesToImport>(opened);
    const Family family = family_of(std::move(opened));
    const std::vector<Figures> keys = is_series ? figures_of(family, series_files(files))
                                                : figures_of(family, is_family ? key_files(first) : files);
    const auto print = options.json ? print_json : print_text;
    if (is_family || (has_family && files.size() == 1))
        print(Kind::family, family, keys, figures_of_family(first, keys));
    else if (files.size() == 1 && !is_series)
        print(Kind::hierarchy, family, keys, total(keys));
    else  // keys without a family file
        print(Kind::family, family, keys, figures_of_keys(keys));
}

}  // namespace interleaf
