#include <algorithm>
#include <set>
#include <string>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "hierarchy/error.h"
#include "io/family_file.h"
#include "io/family_format.h"
#include "io/hierarchy_file.h"
#include "io/input_file.h"
#include "io/joined_text.h"
#include "io/json_place.h"
#include "io/safe_write.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

void check_writable(const Family& family, const fs::path& folder) {
    std::vector<std::string> violations = check(family);
    if (!family_format::is_name(family.name))
        violations.emplace_back("the family's name is not UTF-8 without control characters");
    for (std::size_t i = 0; i < family.keys.size(); ++i)
        if (!family_format::is_name(family.keys[i].name))
            violations.push_back(
                fmt::format("the name of key {} is not UTF-8 without control characters", i));
    if (violations.empty()) return;
    throw InputError(fmt::format("{}: {}", folder.string(), joined(violations, "; ")));
}

/// \p name as the stem of a file name: ASCII letters, digits, '-', '_' and all other scripts kept, the rest
/// replaced by '-'.
std::string file_stem(std::string_view name) {
    constexpr std::size_t longest = 100;
    std::string stem;
    for (const char c : name.substr(0, longest)) {
        const bool is_kept = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                             c == '_' || static_cast<unsigned char>(c) >= 0x80;
        stem += is_kept ? c : '-';
    }
    // Where the name was cut within a character of several bytes, the rest of the character goes, too.
    if (name.size() > longest && (static_cast<unsigned char>(name[longest]) & 0xc0) == 0x80) {
        while ((static_cast<unsigned char>(stem.back()) & 0xc0) == 0x80) stem.pop_back();
        stem.pop_back();
    }
    return stem;
}

bool holds(const fs::path& file, const std::vector<std::byte>& bytes) {
    if (!fs::is_regular_file(fs::symlink_status(file)) || fs::file_size(file) != bytes.size()) return false;
    const std::string content = read_text(file, bytes.size());
    return std::ranges::equal(std::as_bytes(std::span(content)), bytes);
}

/// Writes a key into \p folder under a name that no other file has, so that what an earlier family.json names
/// stays as it is. A file that holds just this key is used again, unless it is in \p taken. \return its name,
/// added to \p taken
std::string write_key(const Key& key, const fs::path& folder, std::set<std::string>& taken) {
    const std::vector<std::byte> bytes = serialize_hierarchy(*key.hierarchy);
    const std::string stem = file_stem(key.name);
    for (unsigned number = 1;; ++number) {
        const std::string name = number == 1 ? stem + ".ilh" : fmt::format("{}-{}.ilh", stem, number);
        const fs::path file = folder / family_format::path_of(name);
        if (taken.contains(name)) continue;
        const bool is_present = fs::exists(fs::symlink_status(file));
        if (is_present && !holds(file, bytes)) continue;
        if (!is_present) write_file(file, bytes);
        taken.insert(name);
        return name;
    }
}

/// The key files beside \p file that it names; none if it is missing or no family.
std::set<std::string> named_key_files(const fs::path& file) {
    std::set<std::string> names;
    try {
        const nlohmann::json document =
            parse_json(read_text(file, family_format::largest_file), file.string());
        const JsonPlace keys = JsonPlace(document, file.string()).member("keys");
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const fs::path name = family_format::path_of(keys.element(i).member("file").string());
            if (name == name.filename() && name.extension() == ".ilh")
                names.insert(family_format::utf8_of(name));
        }
    } catch (const InputError&) {
        return {};
    } catch (const MachineError&) {
        return {};
    }
    return names;
}

/// A member that is an array, one element a line.
std::string array_text(std::string_view indent, std::string_view name,
                       const std::vector<ordered_json>& elements) {
    std::vector<std::string> lines;
    lines.reserve(elements.size());
    for (const ordered_json& element : elements)
        lines.push_back(fmt::format("{}  {}", indent, element.dump()));
    return fmt::format("{0}\"{1}\": [\n{2}\n{0}]", indent, name, joined(lines, ",\n"));
}

std::string timeline_text(const Timeline& timeline, const Family& family) {
    std::vector<ordered_json> keys;
    keys.reserve(timeline.keys().size());
    for (const TimelineKey& key : timeline.keys())
        keys.push_back({{"time", key.time}, {"key", family.keys[key.key].name}});
    return fmt::format("  \"timeline\": {{\n    \"interpolation\": \"linear\",\n{}\n  }}",
                       array_text("    ", "keys", keys));
}

std::string domain_text(const ParameterDomain& domain, const Family& family) {
    std::vector<ordered_json> vertices;
    vertices.reserve(domain.vertices().size());
    for (const DomainVertex& vertex : domain.vertices())
        vertices.push_back({{"at", {vertex.at.x, vertex.at.y}}, {"key", family.keys[vertex.key].name}});
    std::vector<ordered_json> triangles;
    triangles.reserve(domain.triangles().size());
    for (const Triangle& triangle : domain.triangles()) triangles.emplace_back(triangle);
    return fmt::format("  \"domain\": {{\n{},\n{}\n  }}", array_text("    ", "vertices", vertices),
                       array_text("    ", "triangles", triangles));
}

/// The text of family.json. \p files has one file name a key.
std::string family_text(const Family& family, const std::vector<std::string>& files) {
    std::vector<ordered_json> keys;
    keys.reserve(family.keys.size());
    for (std::size_t i = 0; i < family.keys.size(); ++i)
        keys.push_back({{"name", family.keys[i].name}, {"file", files[i]}});
    std::vector<std::string> members{
        fmt::format("  \"format\": \"{}\"", family_format::name),
        fmt::format("  \"version\": {}", family_format::version),
        fmt::format("  \"name\": {}", ordered_json(family.name).dump()),
        array_text("  ", "keys", keys),
    };
    if (family.timeline) members.push_back(timeline_text(*family.timeline, family));
    if (family.domain) members.push_back(domain_text(*family.domain, family));
    return fmt::format("{{\n{}\n}}\n", joined(members, ",\n"));
}

}  // namespace

void write_family(const Family& family, const fs::path& folder) {
    check_writable(family, folder);
    try {
        fs::create_directories(folder);
        const fs::path family_file = folder / "family.json";
        std::set<std::string> obsolete = named_key_files(family_file);

        std::set<std::string> taken;
        std::vector<std::string> files;
        files.reserve(family.keys.size());
        for (const Key& key : family.keys) files.push_back(write_key(key, folder, taken));
        write_file(family_file, family_text(family, files));

        // The family is safe by now: an old key that cannot be removed does no harm.
        std::error_code ignored;
        for (const std::string& name : taken) obsolete.erase(name);
        for (const std::string& name : obsolete) fs::remove(folder / family_format::path_of(name), ignored);
    } catch (const fs::filesystem_error& error) {
        throw MachineError(fmt::format("{}: cannot write: {}", folder.string(), error.code().message()));
    }
}

}  // namespace interleaf
