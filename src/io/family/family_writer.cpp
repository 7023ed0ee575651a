#include <algorithm>
#include <set>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "hierarchy/error.h"
#include "io/family/composition.h"
#include "io/family/family_file.h"
#include "io/family/family_format.h"
#include "io/family/save_journal.h"
#include "io/file/folder_lock.h"
#include "io/file/input_file.h"
#include "io/file/safe_write.h"
#include "io/hierarchy/hierarchy_file.h"
#include "io/text/joined_text.h"
#include "io/text/json_place.h"
#include "text/characters.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void check_writable(const Family& family, const fs::path& folder) {
    const std::vector<std::string> violations = check(family);
    if (violations.empty()) return;
    throw InputError(fmt::format("{}: {}", folder.string(), joined(violations, "; ")));
}

/// \p name as the stem of a file name. ASCII letters and digits, '_' and all non-ASCII characters are kept;
/// '-' replaces every other character.
std::string file_stem(std::string_view name) {
    constexpr std::size_t longest = 100;
    std::string stem;
    for (const char c : name.substr(0, longest)) {
        const bool is_kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                             c == '_' || static_cast<unsigned char>(c) >= 0x80;
        stem += is_kept ? c : '-';
    }
    // Where the name was cut within a character of several bytes, the rest of the character goes, too.
    if (name.size() > longest && continues_character(name[longest])) {
        while (continues_character(stem.back())) stem.pop_back();
        stem.pop_back();
    }
    return stem;
}

bool holds(const fs::path& file, const std::vector<std::byte>& bytes) {
    if (!fs::is_regular_file(fs::symlink_status(file)) || fs::file_size(file) != bytes.size()) return false;
    const std::string content = read_text(file, bytes.size());
    return std::ranges::equal(std::as_bytes(std::span(content)), bytes);
}

/// A key file that the family needs in its folder.
struct KeyFile {
    KeyFileMark mark;
    bool is_present;  ///< whether the folder already has the file, with exactly this content
};

/// Chooses the file for \p key in \p folder: a file that already holds exactly this key, or a new file, so
/// that the files of an earlier family.json stay unchanged.
/// \param taken  names that are not available; gets the chosen name
KeyFile choose_file(const Key& key, const fs::path& folder, const HierarchyFileOptions& form,
                    std::set<std::string>& taken) {
    const std::vector<std::byte> bytes = serialize_hierarchy(*key.hierarchy, form);
    const std::string stem = file_stem(key.name);
    for (unsigned number = 1;; ++number) {
        const std::string name = number == 1 ? stem + ".ilh" : fmt::format("{}-{}.ilh", stem, number);
        const fs::path file = folder / family_format::path_of(name);
        if (taken.contains(name)) continue;
        const bool is_present = fs::exists(fs::symlink_status(file));
        if (is_present && !holds(file, bytes)) continue;
        taken.insert(name);
        return {mark_of(name, bytes), is_present};
    }
}

std::vector<KeyFile> choose_files(const Family& family, const fs::path& folder,
                                  const HierarchyFileOptions& form) {
    std::set<std::string> taken;
    std::vector<KeyFile> files;
    files.reserve(family.keys.size());
    for (const Key& key : family.keys) files.push_back(choose_file(key, folder, form, taken));
    return files;
}

/// The files for the journal: the new key files, and the key files that the current family.json names.
std::vector<KeyFileMark> unsettled_files(const std::vector<KeyFile>& files, const fs::path& folder) {
    std::vector<KeyFileMark> unsettled;
    for (const KeyFile& file : files)
        if (!file.is_present) unsettled.push_back(file.mark);
    for (const std::string& name : named_key_files(folder).value_or(std::set<std::string>()))
        if (const auto mark = mark_of(name, folder)) unsettled.push_back(*mark);
    return unsettled;
}

/// The text of a member that is an array, with one element per line.
std::string array_text(std::string_view indent, std::string_view name,
                       const std::vector<ordered_json>& elements) {
    std::vector<std::string> lines;
    lines.reserve(elements.size());
    for (const ordered_json& element : elements)
        lines.push_back(fmt::format("{}  {}", indent, element.dump()));
    return fmt::format("{0}\"{1}\": [\n{2}\n{0}]", indent, name, joined(lines, ",\n"));
}

std::string interpolation_text(const Interpolation& interpolation) {
    std::string text = fmt::format("    \"interpolation\": \"{}\"", name_of(interpolation.basis));
    if (interpolation.degree > 0) text += fmt::format(",\n    \"degree\": {}", interpolation.degree);
    return text;
}

/// Whether readers of version 1 would not understand \p family, or would lose a part of it.
bool needs_version_2(const Family& family) {
    return family.origin != glm::dvec3(0) || family.path || !family.landmarks.empty() ||
           (family.timeline && (family.timeline->interpolation().basis != Basis::linear ||
                                family.timeline->unit() != TimeUnit::seconds || !family.time_unit.empty())) ||
           !family.field_scales.empty() || family.blend != BlendKind::straight;
}

std::string timeline_text(const Timeline& timeline, const Family& family) {
    std::vector<ordered_json> keys;
    keys.reserve(timeline.keys().size());
    for (const TimelineKey& key : timeline.keys())
        keys.push_back({{"time", key.time}, {"key", family.keys[key.key].name}});
    std::vector<std::string> members{interpolation_text(timeline.interpolation())};
    if (timeline.unit() != TimeUnit::seconds)
        members.push_back(fmt::format("    \"unit\": \"{}\"", name_of(timeline.unit())));
    if (!family.time_unit.empty())
        members.push_back(fmt::format("    \"unit_name\": {}", ordered_json(family.time_unit).dump()));
    members.push_back(array_text("    ", "keys", keys));
    return fmt::format("  \"timeline\": {{\n{}\n  }}", joined(members, ",\n"));
}

std::vector<ordered_json> points_json(const DomainPath& path) {
    std::vector<ordered_json> points;
    points.reserve(path.points().size());
    for (const PathPoint& point : path.points())
        points.push_back({{"time", point.time}, {"at", {point.at.x, point.at.y}}});
    return points;
}

std::string domain_text(const ParameterDomain& domain, const Family& family) {
    std::vector<ordered_json> vertices;
    vertices.reserve(domain.vertices().size());
    for (const DomainVertex& vertex : domain.vertices())
        vertices.push_back({{"at", {vertex.at.x, vertex.at.y}}, {"key", family.keys[vertex.key].name}});
    std::vector<ordered_json> triangles;
    triangles.reserve(domain.triangles().size());
    for (const Triangle& triangle : domain.triangles()) triangles.emplace_back(triangle);
    std::vector<std::string> members{array_text("    ", "vertices", vertices),
                                     array_text("    ", "triangles", triangles)};
    if (family.path) members.push_back(array_text("    ", "path", points_json(*family.path)));
    if (family.time_source == TimeSource::path) members.emplace_back("    \"path_drives\": true");
    return fmt::format("  \"domain\": {{\n{}\n  }}", joined(members, ",\n"));
}

std::vector<ordered_json> directions_json(const Family& family) {
    std::vector<ordered_json> landmarks;
    landmarks.reserve(family.landmarks.size());
    for (const auto& [name, direction] : family.landmarks)
        landmarks.push_back({{"name", name}, {"direction", {direction.x, direction.y, direction.z}}});
    return landmarks;
}

std::vector<ordered_json> scales_json(std::span<const FieldScale> scales) {
    std::vector<ordered_json> elements;
    elements.reserve(scales.size());
    for (const FieldScale& scale : scales) {
        ordered_json& element = elements.emplace_back(ordered_json{{"field", scale.field}});
        if (scale.offset != 0) element["offset"] = scale.offset;
        if (!scale.unit.empty()) element["unit"] = scale.unit;
    }
    return elements;
}

/// The members of family.json from `version` on that do not concern files.
/// \param keys  the member `keys`
std::vector<std::string> composition_members(const Family& family, std::string_view keys) {
    std::vector<std::string> members{
        fmt::format("  \"version\": {}",
                    needs_version_2(family) ? family_format::version : family_format::oldest_version),
        fmt::format("  \"name\": {}", ordered_json(family.name).dump()),
        std::string(keys),
    };
    if (family.blend != BlendKind::straight)
        members.push_back(fmt::format("  \"blend\": \"{}\"", name_of(family.blend)));
    if (family.timeline) members.push_back(timeline_text(*family.timeline, family));
    if (family.domain) members.push_back(domain_text(*family.domain, family));
    if (family.origin != glm::dvec3(0))
        members.push_back(fmt::format(
            "  \"origin\": {}", ordered_json{family.origin.x, family.origin.y, family.origin.z}.dump()));
    if (!family.field_scales.empty())
        members.push_back(array_text("  ", "scales", scales_json(family.field_scales)));
    return members;
}

/// The text of family.json.
/// \param files  one per key
std::string family_text(const Family& family, const std::vector<KeyFile>& files) {
    std::vector<ordered_json> keys;
    keys.reserve(family.keys.size());
    for (std::size_t i = 0; i < family.keys.size(); ++i)
        keys.push_back({{"name", family.keys[i].name}, {"file", files[i].mark.name}});
    std::vector<std::string> members = composition_members(family, array_text("  ", "keys", keys));
    if (!family.landmarks.empty()) members.push_back(array_text("  ", "landmarks", directions_json(family)));
    return fmt::format("{{\n  \"format\": \"{}\",\n{}\n}}\n", family_format::name, joined(members, ",\n"));
}

/// \pre no other process saves into \p folder
void save(const Family& family, const fs::path& folder, const HierarchyFileOptions& form) {
    const std::vector<KeyFile> files = choose_files(family, folder, form);
    begin_save(folder, unsettled_files(files, folder));
    for (std::size_t i = 0; i < files.size(); ++i)
        if (!files[i].is_present)
            write_hierarchy(*family.keys[i].hierarchy, folder / family_format::path_of(files[i].mark.name),
                            form);
    write_file(folder / "family.json", family_text(family, files));
}

}  // namespace

std::string composition_text(const Family& family) {
    std::vector<ordered_json> keys;
    keys.reserve(family.keys.size());
    for (const Key& key : family.keys) keys.push_back({{"name", key.name}});
    return fmt::format("{{\n{}\n}}\n",
                       joined(composition_members(family, array_text("  ", "keys", keys)), ",\n"));
}

void write_family(const Family& family, const fs::path& folder, const HierarchyFileOptions& form) {
    check_writable(family, folder);
    try {
        fs::create_directories(folder);
        const FolderLock lock(folder);
        finish_save(folder);  // a previous save that was killed
        try {
            save(family, folder, form);
        } catch (...) {
            finish_save(folder);
            throw;
        }
        finish_save(folder);
    } catch (const fs::filesystem_error& error) {
        throw MachineError(fmt::format("{}: cannot write: {}", folder.string(), error.code().message()));
    }
}

}  // namespace interleaf
