// The settings file.
#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

#include "fuzz/scratch_file.h"
#include "fuzz/target.h"

#include "app/storage/settings.h"
#include "hierarchy/error.h"

namespace interleaf::fuzz {

namespace {

bool are_sound(const std::vector<std::filesystem::path>& recent) {
    if (recent.size() > max_recent_paths) return false;
    return std::ranges::all_of(recent, [&](const std::filesystem::path& path) {
        return path.is_absolute() && std::ranges::count(recent, path) == 1;
    });
}

std::string inspected(const Settings& settings, ByteSpan bytes) {
    if (!are_sound(settings.recent_files)) return "unsound: recent files";
    if (!are_sound(settings.recent_folders)) return "unsound: recent folders";
    if (!settings.last_folder.empty() && !settings.last_folder.is_absolute()) return "unsound: last folder";
    if (const auto window = settings.window_size; window && (window->x <= 0 || window->y <= 0))
        return "unsound: window size";
    static const ScratchFile file("settings.json");
    file.set_content(bytes);
    change_settings(file.path(), [](Settings&) {});
    const LoadedSettings again = load_settings(file.path());
    return again.settings == settings && again.message.empty() ? "" : "changed by writing and reading them";
}

/// A damaged file gives the defaults and a message, and is kept.
void require_kept(ByteSpan bytes) {
    static const ScratchFile file("damaged.json");
    file.set_content(bytes);
    const std::filesystem::path kept = file.path().string() + ".damaged";
    std::filesystem::remove(kept);
    const LoadedSettings loaded = load_settings(file.path());
    if (loaded.settings != Settings() || loaded.message.empty() || !std::filesystem::exists(kept))
        throw std::logic_error("a damaged file is not kept");
}

Inspection read(ByteSpan bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    try {
        return
            [settings = parse_settings(text, "settings.json"), bytes] { return inspected(settings, bytes); };
    } catch (const InputError&) {
        require_kept(bytes);
        throw;
    }
}

}  // namespace

const Target target{"settings", read, whole_as_part, first_part, own_size};

}  // namespace interleaf::fuzz
