#include "app/storage/settings.h"

#include <algorithm>
#include <system_error>

#include <fmt/core.h>
#include <nlohmann/json.hpp>

#include "app/storage/import_settings.h"
#include "app/storage/user_folders.h"
#include "hierarchy/error.h"
#include "io/family/family_format.h"
#include "io/file/input_file.h"
#include "io/file/safe_write.h"
#include "io/text/json_place.h"
#include "text/characters.h"

namespace interleaf {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;

constexpr std::uint64_t max_file_size = 1 << 20;
constexpr int max_window_size = 32'768;  // what GLFW and X11 can express, and more than any screen has

fs::path path_at(const JsonPlace& place) {
    const std::string text = place.string();
    const fs::path path = family_format::path_of(text);
    if (!path.is_absolute() || text.find('\0') != std::string::npos) place.fail_expecting("an absolute path");
    return path;
}

std::vector<fs::path> paths_at(const JsonPlace& place) {
    std::vector<fs::path> paths;
    for (std::size_t i = 0; i < place.size(); ++i) {
        fs::path path = path_at(place.element(i));
        if (paths.size() < max_recent_paths && std::ranges::find(paths, path) == paths.end())
            paths.push_back(std::move(path));
    }
    return paths;
}

/// The options of each series. Those that no import has are dropped: the series is then imported by the usual ones.
std::map<fs::path, ImportChoices> imports_at(const JsonPlace& place) {
    std::map<fs::path, ImportChoices> imports;
    for (const std::string& series : place.member_names()) {
        try {
            imports.emplace(family_format::path_of(series), import_choices_at(place.member(series)));
        } catch (const InputError&) {
            continue;
        }
    }
    return imports;
}

int length_at(const JsonPlace& place) {
    const std::uint32_t length = place.index_below(max_window_size);
    if (length == 0) place.fail_expecting("a size above 0");
    return static_cast<int>(length);
}

/// The number at \p place, within [\p low, \p high].
float number_at(const JsonPlace& place, float low, float high) {
    const double number = place.number();
    if (!(number >= low && number <= high))
        place.fail_expecting(fmt::format("a number from {:g} to {:g}", low, high));
    return static_cast<float>(number);
}

UpAxis up_at(const JsonPlace& place) {
    const auto up = up_axis_named(place.string());
    if (!up) place.fail_expecting("\"X\", \"Y\" or \"Z\"");
    return *up;
}

Appearance appearance_at(const JsonPlace& place) {
    Appearance appearance;
    if (const auto theme = place.optional_member("theme")) {
        const auto named = theme_named(theme->string());
        if (!named) theme->fail_expecting("\"dark\" or \"light\"");
        appearance.theme = *named;
    }
    if (const auto scale = place.optional_member("text size"))
        appearance.text_scale = number_at(*scale, min_text_scale, max_text_scale);
    if (const auto panels = place.optional_member("panels")) {
        const auto size_of = [&](const char* name) {
            const auto size = panels->optional_member(name);
            return size ? std::optional(number_at(*size, 0, max_window_size)) : std::nullopt;
        };
        appearance.panels = {
            .left = size_of("left"), .right = size_of("right"), .timeline = size_of("timeline")};
    }
    if (const auto closed = place.optional_member("closed"))
        for (std::size_t i = 0; i < closed->size(); ++i)
            appearance.closed_sections.push_back(closed->element(i).string());
    return appearance;
}

ordered_json appearance_json(const Appearance& appearance) {
    ordered_json panels = ordered_json::object();
    const auto put = [&](const char* name, const std::optional<float>& size) {
        if (size) panels[name] = *size;
    };
    put("left", appearance.panels.left);
    put("right", appearance.panels.right);
    put("timeline", appearance.panels.timeline);
    return {{"theme", name_of(appearance.theme)},
            {"text size", appearance.text_scale},
            {"panels", panels},
            {"closed", appearance.closed_sections}};
}

/// A JSON array of the \p paths that JSON can hold.
ordered_json array_of(const std::vector<fs::path>& paths) {
    ordered_json array = ordered_json::array();
    for (const fs::path& path : paths) {
        std::string text = family_format::utf8_of(path);
        if (is_utf8(text)) array.push_back(std::move(text));
    }
    return array;
}

std::string settings_text(const Settings& settings) {
    ordered_json document = ordered_json::object();
    document["recent files"] = array_of(settings.recent_files);
    document["recent folders"] = array_of(settings.recent_folders);
    for (const auto& [series, choices] : settings.imports) {
        const std::string text = family_format::utf8_of(series);
        if (is_utf8(text) && std::ranges::find(settings.recent_files, series) != settings.recent_files.end())
            document["imports"][text] = import_json(choices);
    }
    const std::string last = family_format::utf8_of(settings.last_folder);
    if (!last.empty() && is_utf8(last)) document["last folder"] = last;
    if (settings.window_size)
        document["window"] = {{"width", settings.window_size->x}, {"height", settings.window_size->y}};
    if (settings.appearance != Appearance{}) document["appearance"] = appearance_json(settings.appearance);
    document["camera"] = {
        {"trackball", settings.trackball}, {"axes", settings.axes}, {"up", name_of(settings.up)}};
    if (!settings.shortcuts.empty()) document["shortcuts"] = settings.shortcuts;
    return document.dump(2) + "\n";
}

/// A folder may be called so, too.
bool is_family_file(const fs::path& path) {
    std::error_code ignored;
    return path.filename() == "family.json" && !fs::is_directory(path, ignored);
}

/// The resolved location of the document that is remembered as \p path.
fs::path place_of(const fs::path& path) {
    std::error_code error;
    fs::path place = fs::weakly_canonical(path, error);
    if (error) place = path.lexically_normal();
    if (!place.has_filename()) place = place.parent_path();
    return is_family_file(place) ? place.parent_path() : place;
}

/// The message about \p fault in \p file, which is kept under another name.
std::string keep_damaged(const fs::path& file, std::string_view fault) {
    fs::path kept = file;
    kept += ".damaged";
    std::error_code error;
    fs::rename(file, kept, error);
    return error ? fmt::format("{}; settings are the defaults", fault)
                 : fmt::format("{}; settings are the defaults, the file is kept as {}", fault,
                               kept.filename().string());
}

}  // namespace

void remember(std::vector<fs::path>& recent, const fs::path& path) {
    std::error_code error;
    fs::path whole = fs::absolute(path, error).lexically_normal();
    if (error) return;                                       // relative to a deleted folder
    if (!whole.has_filename()) whole = whole.parent_path();  // it ends with a '/'
    std::erase(recent, whole);
    recent.insert(recent.begin(), whole);
    if (recent.size() > max_recent_paths) recent.resize(max_recent_paths);
}

void remember_document(std::vector<fs::path>& recent, const fs::path& path) {
    std::error_code error;
    const fs::path whole = fs::absolute(path, error).lexically_normal();
    if (error) return;
    const fs::path document = is_family_file(whole) ? whole.parent_path() : whole;
    const fs::path place = place_of(document);
    std::erase_if(recent, [&](const fs::path& other) { return place_of(other) == place; });
    remember(recent, document);
}

void remember_series(Settings& settings, const fs::path& path, ImportChoices choices) {
    remember_document(settings.recent_files, path);
    if (settings.recent_files.empty()) return;
    const fs::path& series = settings.recent_files.front();
    if (choices == ImportChoices{})
        settings.imports.erase(series);
    else
        settings.imports.insert_or_assign(series, std::move(choices));
}

Settings parse_settings(std::string_view json, std::string_view name) {
    if (json.size() > max_file_size)
        throw InputError(
            fmt::format("{}: size: {} bytes, expected at most {}", name, json.size(), max_file_size));
    const nlohmann::json document = parse_json(json, name);
    const JsonPlace root(document, std::string(name));
    Settings settings;
    if (const auto files = root.optional_member("recent files")) settings.recent_files = paths_at(*files);
    if (const auto folders = root.optional_member("recent folders"))
        settings.recent_folders = paths_at(*folders);
    if (const auto imports = root.optional_member("imports")) settings.imports = imports_at(*imports);
    if (const auto folder = root.optional_member("last folder")) settings.last_folder = path_at(*folder);
    if (const auto window = root.optional_member("window"))
        settings.window_size = {length_at(window->member("width")), length_at(window->member("height"))};
    if (const auto appearance = root.optional_member("appearance"))
        settings.appearance = appearance_at(*appearance);
    if (const auto camera = root.optional_member("camera")) {
        if (const auto trackball = camera->optional_member("trackball"))
            settings.trackball = trackball->boolean();
        if (const auto axes = camera->optional_member("axes")) settings.axes = axes->boolean();
        if (const auto up = camera->optional_member("up")) settings.up = up_at(*up);
    }
    if (const auto shortcuts = root.optional_member("shortcuts"))
        for (std::string& command : shortcuts->member_names()) {
            std::string text = shortcuts->member(command).string();
            settings.shortcuts.emplace(std::move(command), std::move(text));
        }
    return settings;
}

std::optional<fs::path> settings_file() {
    const auto folder = config_folder();
    if (!folder) return std::nullopt;
    return *folder / "settings.json";
}

LoadedSettings load_settings(const fs::path& file) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(file, ignored))) return {};
    try {
        return {.settings = parse_settings(read_text(file, max_file_size), file.string()), .message = ""};
    } catch (const InputError& error) {
        return {.settings = {}, .message = keep_damaged(file, error.what())};
    } catch (const MachineError& error) {
        return {.settings = {}, .message = keep_damaged(file, error.what())};
    }
}

void change_settings(const fs::path& file, const std::function<void(Settings&)>& change) {
    Settings settings = load_settings(file).settings;
    change(settings);
    std::error_code error;
    fs::create_directories(file.parent_path(), error);
    if (error) throw MachineError(fmt::format("{}: cannot write: {}", file.string(), error.message()));
    write_file(file, settings_text(settings));
}

}  // namespace interleaf
