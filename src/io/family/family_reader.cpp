#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "family/new_family.h"
#include "family/origin.h"
#include "family/synchronize_keys.h"
#include "hierarchy/error.h"
#include "hierarchy/progress.h"
#include "io/family/composition.h"
#include "io/family/family_file.h"
#include "io/family/family_format.h"
#include "io/family/family_scales.h"
#include "io/file/file_pattern.h"
#include "io/file/input_file.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/landmarks/landmark_file.h"
#include "io/text/joined_text.h"
#include "io/text/json_place.h"
#include "text/characters.h"
#include "text/shown_text.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

std::string name_at(const JsonPlace& place) {
    std::string name = place.string();
    if (!is_printable(name)) place.fail_expecting("a name without control characters");
    return name;
}

std::string key_name_at(const JsonPlace& place) {
    std::string name = name_at(place);
    if (name.empty()) place.fail_expecting("a name that is not empty");
    return name;
}

bool is_inside(const fs::path& folder, const fs::path& file) {
    return std::ranges::mismatch(folder, file).in1 == folder.end();
}

/// The key file that \p place names, inside \p folder, with all symbolic links resolved.
fs::path key_file_at(const JsonPlace& place, const fs::path& folder) {
    const std::string text = place.string();
    const fs::path relative = family_format::path_of(text);
    if (text.empty() || text.find('\0') != std::string::npos || relative.is_absolute() ||
        std::ranges::find(relative, "..") != relative.end())
        place.fail_expecting("a path relative to the family's folder, without \"..\"");

    std::error_code error;
    const fs::path file = fs::canonical(folder / relative, error);
    if (error) place.fail(fmt::format("is {}: {}", in_quotes(text), error.message()));
    if (!is_inside(fs::canonical(folder), file))
        place.fail(fmt::format("is {}, a link that leads out of the family's folder", in_quotes(text)));
    return file;
}

std::vector<Key> keys_at(const JsonPlace& place, const fs::path& folder, const Progress& progress) {
    std::vector<Key> keys;
    keys.reserve(place.size());
    std::map<std::string, std::size_t> names;
    std::map<fs::path, std::size_t> files;
    std::vector<std::string> faults;  // of all key files, so that the message names all
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace key = place.element(i);
        const JsonPlace name = key.member("name");
        const auto [same_name, name_is_new] = names.emplace(key_name_at(name), i);
        if (!name_is_new)
            name.fail(
                fmt::format("is {}, the same as keys[{}]", in_quotes(same_name->first), same_name->second));

        const JsonPlace file = key.member("file");
        const auto [same_file, file_is_new] = files.emplace(key_file_at(file, folder), i);
        if (!file_is_new) file.fail(fmt::format("is also the file of keys[{}]", same_file->second));
        const double part = static_cast<double>(i) / static_cast<double>(place.size());
        if (progress && !progress(fmt::format("reading {}", shown_name(same_name->first)), part))
            throw Cancelled();
        try {
            keys.push_back({same_name->first, read_hierarchy(same_file->first)});
        } catch (const InputError& error) {
            faults.emplace_back(error.what());
        }
    }
    if (!faults.empty()) throw InputError(joined(faults, "; "));
    return keys;
}

/// The permutations of the members "roots": one per key, empty for a key without that member.
std::vector<std::vector<Index>> given_roots(const JsonPlace& place, std::span<const Key> keys) {
    std::vector<std::vector<Index>> given(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const auto roots = place.element(i).optional_member("roots");
        if (!roots) continue;
        if (i == 0)
            roots->fail("is present, expected none: the first key defines the numbering of the roots");
        const Index count = keys[i].hierarchy->roots.triangle_count();
        if (roots->size() != count)
            roots->fail(
                fmt::format("has {} numbers, expected one for each of the {} roots", roots->size(), count));
        std::vector<Index> place_of(count, no_index);
        given[i].reserve(count);
        for (std::size_t r = 0; r < count; ++r) {
            const JsonPlace number = roots->element(r);
            const Index root = number.index_below(count);
            if (place_of[root] != no_index)
                number.fail(fmt::format("is {}, the same as roots[{}]; expected each root once", root,
                                        place_of[root]));
            place_of[root] = static_cast<Index>(r);
            given[i].push_back(root);
        }
    }
    return given;
}

/// Renumbers all keys so that their roots match the roots of the first key.
/// \param place_of  says where the key of an index was read from
template <typename PlaceOf>
void synchronize_all(std::span<Key> keys, std::span<const std::vector<Index>> given, const PlaceOf& place_of,
                     std::vector<std::string>* changes) {
    const Synchronization synchronization = synchronize(keys, given);
    std::vector<std::string> faults;
    faults.reserve(synchronization.mismatches.size());
    for (const KeyMismatch& mismatch : synchronization.mismatches)
        faults.push_back(fmt::format("{}: {}", place_of(mismatch.key), mismatch.text));
    if (!faults.empty()) throw MismatchError(joined(faults, "; "), keys, synchronization.mismatches.front());
    if (changes != nullptr)
        changes->insert(changes->end(), synchronization.changes.begin(), synchronization.changes.end());
}

/// Finds the index of a key by its name.
class KeyNames {
  public:
    explicit KeyNames(const std::vector<Key>& keys) {
        for (std::size_t i = 0; i < keys.size(); ++i) indices_.emplace(keys[i].name, i);
    }
    std::size_t index_at(const JsonPlace& place) const {
        const auto found = indices_.find(place.string());
        if (found == indices_.end()) place.fail_expecting("the name of a key");
        return found->second;
    }

  private:
    std::map<std::string, std::size_t> indices_;
};

/// Every name in quotation marks: "linear".
std::string names_of_bases() {
    std::vector<std::string> names;
    for (const Basis each : bases()) names.push_back(fmt::format("\"{}\"", name_of(each)));
    return joined(names, " or ");
}

/// The members `interpolation` and `degree` of the timeline at \p place.
Interpolation interpolation_at(const JsonPlace& place, double version) {
    const JsonPlace basis_place = place.member("interpolation");
    const auto basis = basis_named(basis_place.string());
    if (version < family_format::version && basis != Basis::linear)
        basis_place.fail_expecting(basis ? "\"linear\" in version 1" : "\"linear\"");
    if (!basis) basis_place.fail_expecting(names_of_bases());
    Interpolation interpolation{.basis = *basis};
    const auto degree = place.optional_member("degree");
    if (!degree || version < family_format::version) return interpolation;
    if (basis != Basis::bernstein)
        degree->fail_expecting("no degree: only the interpolation \"bernstein\" has one");
    interpolation.degree = degree->index_below(no_index);
    if (interpolation.degree == 0) degree->fail_expecting("a degree of at least 1");
    return interpolation;
}

Timeline timeline_at(const JsonPlace& place, const KeyNames& names, double version) {
    const Interpolation interpolation = interpolation_at(place, version);

    std::vector<TimelineKey> timeline_keys;
    const JsonPlace keys = place.member("keys");
    timeline_keys.reserve(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        const JsonPlace key = keys.element(i);
        timeline_keys.push_back({key.member("time").number(), names.index_at(key.member("key"))});
    }
    try {
        return Timeline(std::move(timeline_keys), interpolation, unit_at(place, version));
    } catch (const InputError& error) {
        place.fail(error.what());
    }
}

glm::dvec2 point_at(const JsonPlace& place) {
    if (place.size() != 2) place.fail_expecting("two numbers");
    return {place.element(0).number(), place.element(1).number()};
}

glm::dvec3 origin_at(const JsonPlace& place) {
    if (place.size() != 3) place.fail_expecting("three numbers");
    return {place.element(0).number(), place.element(1).number(), place.element(2).number()};
}

Triangle triangle_at(const JsonPlace& place, std::size_t vertex_count) {
    if (place.size() != 3) place.fail_expecting("three vertices");
    return {place.element(0).index_below(vertex_count), place.element(1).index_below(vertex_count),
            place.element(2).index_below(vertex_count)};
}

ParameterDomain domain_at(const JsonPlace& place, const KeyNames& names) {
    std::vector<DomainVertex> domain_vertices;
    const JsonPlace vertices = place.member("vertices");
    domain_vertices.reserve(vertices.size());
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        const JsonPlace vertex = vertices.element(i);
        domain_vertices.push_back({point_at(vertex.member("at")), names.index_at(vertex.member("key"))});
    }
    std::vector<Triangle> domain_triangles;
    const JsonPlace triangles = place.member("triangles");
    if (triangles.size() == 0 || triangles.size() > family_format::max_domain_triangles)
        triangles.fail(fmt::format("{} triangles, expected 1 to {}", triangles.size(),
                                   family_format::max_domain_triangles));
    domain_triangles.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); ++i)
        domain_triangles.push_back(triangle_at(triangles.element(i), domain_vertices.size()));
    try {
        return {std::move(domain_vertices), std::move(domain_triangles)};
    } catch (const InputError& error) {
        place.fail(error.what());
    }
}

DomainPath path_at(const JsonPlace& place) {
    std::vector<PathPoint> points;
    points.reserve(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace point = place.element(i);
        points.push_back({point.member("time").number(), point_at(point.member("at"))});
    }
    try {
        return DomainPath(std::move(points));
    } catch (const InputError& error) {
        place.fail(error.what());
    }
}

std::vector<LandmarkDirection> family_landmarks_at(const JsonPlace& place) {
    if (place.size() > max_landmarks)
        place.fail(fmt::format("has {} landmarks, expected at most {}", place.size(), max_landmarks));
    std::vector<LandmarkDirection> landmarks;
    landmarks.reserve(place.size());
    for (std::size_t i = 0; i < place.size(); ++i) {
        const JsonPlace name = place.element(i).member("name");
        LandmarkDirection landmark{key_name_at(name), direction_at(place.element(i).member("direction"))};
        if (std::ranges::find(landmarks, landmark.name, &LandmarkDirection::name) != landmarks.end())
            name.fail_expecting("a name that no other landmark has");
        landmarks.push_back(std::move(landmark));
    }
    return landmarks;
}

/// Reads the members `path` and `path_drives` of the domain at \p place into \p family.
void read_path(const JsonPlace& place, Family& family) {
    if (const auto path = place.optional_member("path")) family.path = path_at(*path);
    const auto drives = place.optional_member("path_drives");
    if (!drives || !drives->boolean()) return;
    if (!family.path) drives->fail_expecting("false: the domain has no path");
    family.time_source = TimeSource::path;
}

void check_version(const JsonPlace& version) {
    if (version.number() != family_format::oldest_version && version.number() != family_format::version)
        version.fail_expecting(
            fmt::format("{} or {}", family_format::oldest_version, family_format::version));
}

nlohmann::json parse_family_json(const fs::path& file) {
    return parse_json(read_text(file, family_format::max_file_size), file.string());
}

fs::path folder_of(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : ".";
}

Family read_family_json(const fs::path& file, std::vector<std::string>* changes, const Progress& progress) {
    const nlohmann::json document = parse_family_json(file);
    const JsonPlace root(document, file.string());
    const JsonPlace format = root.member("format");
    if (format.string() != family_format::name)
        format.fail_expecting(fmt::format("\"{}\"", family_format::name));
    check_version(root.member("version"));
    Family family;
    family.name = name_at(root.member("name"));
    const JsonPlace keys = root.member("keys");
    family.keys = keys_at(keys, folder_of(file), progress);
    if (!family.keys.empty()) {
        const auto place_of = [&](std::size_t key) {
            return fmt::format("{}: keys[{}]", file.string(), key);
        };
        synchronize_all(family.keys, given_roots(keys, family.keys), place_of, changes);
    }
    if (const auto violations = check(family); !violations.empty()) keys.fail(joined(violations, "; "));

    read_composition(root, family);
    if (const auto landmarks = root.optional_member("landmarks");
        landmarks && root.member("version").number() > 1)
        family.landmarks = family_landmarks_at(*landmarks);
    return family;
}

}  // namespace

void read_composition(const JsonPlace& place, Family& family) {
    const JsonPlace version = place.member("version");
    check_version(version);
    const KeyNames names(family.keys);
    if (const auto timeline = place.optional_member("timeline"))
        family.timeline = timeline_at(*timeline, names, version.number());
    if (const auto domain = place.optional_member("domain")) {
        family.domain = domain_at(*domain, names);
        if (version.number() > 1) read_path(*domain, family);
    }
    if (version.number() == 1) return;
    if (const auto blend = place.optional_member("blend")) {
        const std::optional<BlendKind> kind = blend_kind_named(blend->string());
        if (!kind) blend->fail_expecting("\"straight\" or \"turning\"");
        family.blend = *kind;
    }
    if (const auto origin = place.optional_member("origin")) family.origin = origin_at(*origin);
    if (const auto scales = place.optional_member("scales")) family.field_scales = scales_at(*scales);
    if (const auto timeline = place.optional_member("timeline"))
        if (const auto unit = timeline->optional_member("unit_name"))
            family.time_unit = written_unit_at(*unit);
}

std::vector<fs::path> key_files(const fs::path& path) {
    std::error_code ignored;
    const bool is_folder = fs::is_directory(path, ignored);
    if (!is_folder && lower_case_extension(path) != ".json") return {path};
    const fs::path file = is_folder ? path / "family.json" : path;
    const nlohmann::json document = parse_family_json(file);
    const JsonPlace keys = JsonPlace(document, file.string()).member("keys");
    std::vector<fs::path> files;
    files.reserve(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i)
        files.push_back(key_file_at(keys.element(i).member("file"), folder_of(file)));
    return files;
}

Family read_family(const fs::path& path, std::vector<std::string>* changes) {
    return read_family(path, changes, {});
}

Family read_family(const fs::path& path, std::vector<std::string>* changes, const Progress& progress) {
    std::error_code ignored;
    if (fs::is_directory(path, ignored)) {
        const fs::path file = path / "family.json";
        if (fs::status(file, ignored).type() == fs::file_type::not_found)
            throw InputError(
                fmt::format("{}: is a folder without family.json, expected a family", path.string()));
        return read_family_json(file, changes, progress);
    }
    return read_family_json(path, changes, progress);
}

Family family_of_files(std::span<const fs::path> files, FileKeys read, std::vector<std::string>* changes) {
    const auto name_of = [](const fs::path& file) { return family_format::utf8_of(file.stem()); };
    const bool is_key_per_file = read.sources.empty();
    std::vector<Key> keys;
    keys.reserve(read.keys.size());
    const glm::dvec3 origin = read.origin.value_or(glm::dvec3(0));
    if (origin != glm::dvec3(0)) read.remarks.push_back(origin_sentence(origin));
    if (changes != nullptr) changes->insert(changes->end(), read.remarks.begin(), read.remarks.end());
    for (Hierarchy& hierarchy : read.keys) {
        const std::size_t key = keys.size();
        keys.push_back(
            {is_key_per_file ? name_of(files[key]) : read.sources[key].name, std::move(hierarchy)});
    }
    const auto place_of = [&](std::size_t key) {
        return files[is_key_per_file ? key : read.sources[key].file].string();
    };
    synchronize_all(keys, {}, place_of, changes);
    const std::string name = files.size() == 1
                                 ? name_of(files.front())
                                 : fmt::format("{} to {}", name_of(files.front()), name_of(files.back()));
    Family family = family_of_keys(name, std::move(keys));
    family.origin = origin;
    family.field_scales = std::move(read.scales);
    return family;
}

}  // namespace interleaf
