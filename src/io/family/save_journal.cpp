#include "io/family/save_journal.h"

#include <array>
#include <cstring>
#include <fstream>
#include <sstream>
#include <utility>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "hierarchy/error.h"
#include "io/family/family_format.h"
#include "io/file/input_file.h"
#include "io/file/safe_write.h"
#include "io/text/json_place.h"
#include "text/characters.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view journal_name = ".interleaf-save";
constexpr std::uint64_t max_journal_size = 1 << 20;

/// Whether \p name names a key file directly in the family's folder, and fits on one line.
bool is_key_name(const fs::path& name) {
    return name == name.filename() && name.extension() == ".ilh" && is_printable(name.string());
}

/// The files that the journal in \p folder lists. Each line has a checksum, a size and a name.
std::vector<KeyFileMark> listed_files(const fs::path& folder) {
    std::istringstream lines(read_text(folder / journal_name, max_journal_size));
    std::vector<KeyFileMark> files;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        KeyFileMark mark;
        words >> std::hex >> mark.checksum >> std::dec >> mark.size >> std::ws;
        std::getline(words, mark.name);
        if (is_key_name(family_format::path_of(mark.name))) files.push_back(std::move(mark));
    }
    return files;
}

/// Removes the files that the journal of \p folder lists and \p needed does not contain, and the journal.
void remove_unneeded(const fs::path& folder, const std::set<std::string>& needed) {
    std::error_code ignored;
    for (const KeyFileMark& listed : listed_files(folder))
        if (!needed.contains(listed.name) && mark_of(listed.name, folder) == listed)
            fs::remove(folder / family_format::path_of(listed.name), ignored);
    fs::remove(folder / journal_name, ignored);
}

}  // namespace

KeyFileMark mark_of(std::string name, std::span<const std::byte> bytes) {
    KeyFileMark mark{std::move(name), bytes.size(), 0};
    if (bytes.size() >= sizeof(mark.checksum))
        std::memcpy(&mark.checksum, bytes.last(sizeof(mark.checksum)).data(), sizeof(mark.checksum));
    return mark;
}

std::optional<KeyFileMark> mark_of(std::string name, const fs::path& folder) {
    const fs::path file = folder / family_format::path_of(name);
    std::error_code error;
    if (!fs::is_regular_file(fs::symlink_status(file, error))) return std::nullopt;
    std::ifstream stream(file, std::ios::binary | std::ios::ate);
    KeyFileMark mark{std::move(name), static_cast<std::uint64_t>(stream.tellg()), 0};
    std::array<char, sizeof(mark.checksum)> checksum{};
    stream.seekg(-static_cast<std::streamoff>(checksum.size()), std::ios::end);
    if (!stream.read(checksum.data(), checksum.size())) return std::nullopt;
    std::memcpy(&mark.checksum, checksum.data(), checksum.size());
    return mark;
}

std::optional<std::set<std::string>> named_key_files(const fs::path& folder) {
    const fs::path file = folder / "family.json";
    std::set<std::string> names;
    if (!fs::exists(fs::symlink_status(file))) return names;
    try {
        const nlohmann::json document =
            parse_json(read_text(file, family_format::max_file_size), file.string());
        const JsonPlace keys = JsonPlace(document, file.string()).member("keys");
        for (std::size_t i = 0; i < keys.size(); ++i) {
            const fs::path name =
                family_format::path_of(keys.element(i).member("file").string()).lexically_normal();
            if (is_key_name(name)) names.insert(family_format::utf8_of(name));
        }
    } catch (const InputError&) {
        return std::nullopt;
    } catch (const MachineError&) {
        return std::nullopt;
    }
    return names;
}

void begin_save(const fs::path& folder, std::span<const KeyFileMark> files) {
    std::string text;
    for (const KeyFileMark& file : files)
        text += fmt::format("{:08x} {} {}\n", file.checksum, file.size, file.name);
    write_file(folder / journal_name, text);
}

void finish_save(const fs::path& folder) {
    try {
        if (!fs::exists(fs::symlink_status(folder / journal_name))) return;
        if (const auto needed = named_key_files(folder)) remove_unneeded(folder, *needed);
    } catch (const InputError&) {
        return;
    } catch (const MachineError&) {
        return;
    } catch (const fs::filesystem_error&) {
        return;
    }
}

}  // namespace interleaf
