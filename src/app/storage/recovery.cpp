#include "app/storage/recovery.h"

#include <algorithm>
#include <cerrno>
#include <system_error>

#include <fmt/core.h>
#include <nlohmann/json.hpp>
#include <sys/stat.h>

#include "app/storage/running_process.h"
#include "hierarchy/error.h"
#include "io/family/family_format.h"
#include "io/file/input_file.h"
#include "io/text/json_place.h"
#include "text/characters.h"
#include "text/parsed_number.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t max_note_size = 1 << 16;
constexpr double latest_time = 253'402'300'800;  // the year 10000

[[noreturn]] void fail(const fs::path& path, std::string_view action, const std::error_code& error) {
    throw MachineError(fmt::format("{}: cannot {}: {}", path.string(), action, error.message()));
}

/// The process that a folder called \p name belongs to: "PID-START", possibly with more after another '-'.
std::optional<ProcessIdentity> owner_of(std::string_view name) {
    const std::size_t dash = name.find('-');
    if (dash == std::string_view::npos) return std::nullopt;
    const std::string_view rest = name.substr(dash + 1);
    const auto number = parsed_number<decltype(ProcessIdentity::number)>(name.substr(0, dash));
    const auto start = parsed_number<decltype(ProcessIdentity::start_time)>(rest.substr(0, rest.find('-')));
    if (!number || *number <= 0 || !start) return std::nullopt;
    return ProcessIdentity{.number = *number, .start_time = *start};
}

/// The names for a folder of this process, in the order of attempts. An existing name may be left from before
/// a reboot of the machine.
fs::path own_name(std::string_view kind, unsigned attempt) {
    const ProcessIdentity self = this_process();
    return fmt::format("{}-{}-{}{}", self.number, self.start_time, kind, attempt);
}

constexpr unsigned max_attempts = 1000;

bool has_family(const Recovery& recovery) {
    std::error_code ignored;
    return fs::is_regular_file(recovery.family() / "family.json", ignored);
}

RecoveryNote note_in(const fs::path& file) {
    try {
        return parse_recovery_note(read_text(file, max_note_size), file.string());
    } catch (const std::runtime_error&) {
        return {.name = "Unnamed", .document_folder = {}, .time = 0};
    }
}

}  // namespace

RecoveryNote parse_recovery_note(std::string_view json, std::string_view name) {
    const nlohmann::json document = parse_json(json, name);
    const JsonPlace root(document, std::string(name));
    RecoveryNote note;
    const JsonPlace title = root.member("name");
    note.name = title.string();
    if (!is_printable(note.name)) title.fail_expecting("a name without control characters");
    if (const auto folder = root.optional_member("folder")) {
        const std::string text = folder->string();
        note.document_folder = family_format::path_of(text);
        if (!note.document_folder.is_absolute() || text.find('\0') != std::string::npos)
            folder->fail_expecting("an absolute path");
    }
    const JsonPlace time = root.member("time");
    if (!(time.number() >= 0 && time.number() < latest_time))
        time.fail_expecting("seconds since 1970, before the year 10000");
    note.time = static_cast<std::int64_t>(time.number());
    return note;
}

std::string recovery_note_text(const RecoveryNote& note) {
    nlohmann::ordered_json document{{"name", is_printable(note.name) ? note.name : "Unnamed"}};
    const std::string folder = family_format::utf8_of(note.document_folder);
    if (!folder.empty() && is_utf8(folder)) document["folder"] = folder;
    document["time"] = note.time;
    return document.dump(2) + "\n";
}

Recovery make_recovery(const fs::path& state_folder) {
    const fs::path all = state_folder / "recovery";
    std::error_code error;
    fs::create_directories(all, error);
    if (error) fail(all, "make the folder", error);
    for (unsigned attempt = 1; attempt <= max_attempts; ++attempt) {
        Recovery recovery{.folder = all / own_name("", attempt), .note = {}};
        // A document may be private: only the owner may access the folder.
        if (::mkdir(recovery.folder.c_str(), 0700) == 0) return recovery;
        error.assign(errno, std::generic_category());
        if (error != std::errc::file_exists) break;
    }
    fail(all, "make a folder", error);
}

std::vector<Recovery> abandoned_recoveries(const fs::path& state_folder) {
    std::vector<Recovery> found;
    std::error_code error;
    for (fs::directory_iterator entry(state_folder / "recovery", error), end; !error && entry != end;
         entry.increment(error)) {
        std::error_code ignored;
        const auto owner = owner_of(entry->path().filename().string());
        if (!owner || !fs::is_directory(entry->symlink_status(ignored))) continue;
        if (running_process(owner->number) == owner) continue;
        Recovery recovery{.folder = entry->path(), .note = {}};
        if (has_family(recovery)) {
            recovery.note = note_in(recovery.note_file());
            found.push_back(std::move(recovery));
        } else {
            fs::remove_all(recovery.folder, ignored);
        }
    }
    std::ranges::stable_sort(found, std::ranges::greater(), [](const Recovery& r) { return r.note.time; });
    return found;
}

std::optional<Recovery> claim_recovery(const Recovery& recovery) {
    const fs::path all = recovery.folder.parent_path();
    for (unsigned attempt = 1; attempt <= max_attempts; ++attempt) {
        Recovery claimed{.folder = all / own_name("claimed-", attempt), .note = recovery.note};
        std::error_code error;
        if (fs::exists(fs::symlink_status(claimed.folder, error))) continue;
        fs::rename(recovery.folder, claimed.folder, error);
        if (!error) return claimed;
        return std::nullopt;
    }
    return std::nullopt;
}

void discard_recovery(const Recovery& recovery) {
    std::error_code error;
    // Removes family.json first, so that a recovery whose removal was interrupted is never offered.
    fs::remove(recovery.family() / "family.json", error);
    if (!error) fs::remove_all(recovery.folder, error);
    if (error && error != std::errc::no_such_file_or_directory && error != std::errc::not_a_directory)
        fail(recovery.folder, "remove", error);
}

}  // namespace interleaf
