#include "ui/widgets/glyphs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <system_error>

#include <imgui.h>

#include "text/characters.h"
#include "ui/widgets/gui_state.h"
#include "ui/widgets/typeface.h"

namespace interleaf {

namespace {

/// Pairs of the first and the last character, and a 0: Latin; Greek and Cyrillic; dashes and the ellipsis.
constexpr std::array<ImWchar, 7> usual_characters{0x20, 0x24f, 0x370, 0x4ff, 0x2010, 0x2044, 0};

/// More characters than a family, a folder or a text has; the texture of the typeface stays small.
constexpr std::size_t max_glyphs = 2000;

/// Fonts for the characters that Inter lacks, the first that has a character comes first. Those that are not
/// installed are left out.
constexpr std::array fallback_files{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/wqy/wqy-microhei.ttc",
    "/usr/share/fonts/truetype/droid/DroidSansFallbackFull.ttf",
    "/usr/share/fonts/truetype/freefont/FreeSans.ttf",
    "/usr/share/fonts/opentype/unifont/unifont.otf",
};

bool is_usual(char32_t code) {
    for (std::size_t range = 0; range + 1 < usual_characters.size(); range += 2)
        if (code >= usual_characters.at(range) && code <= usual_characters.at(range + 1)) return true;
    return false;
}

/// The ranges of single characters, as Dear ImGui reads them.
ImVector<ImWchar> ranges_of(const std::set<ImWchar>& characters) {
    ImVector<ImWchar> ranges;
    for (const ImWchar character : characters) {
        ranges.push_back(character);
        ranges.push_back(character);
    }
    ranges.push_back(0);
    return ranges;
}

void add_typeface(float pixels, const ImWchar* ranges, bool merges) {
    const auto bytes = typeface();
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.MergeMode = merges;
    // With FontDataOwnedByAtlas off, Dear ImGui does not write to the bytes; its parameter merely lacks the const.
    void* const data =
        const_cast<unsigned char*>(bytes.data());  // NOLINT(cppcoreguidelines-pro-type-const-cast)
    ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data, static_cast<int>(bytes.size()), pixels, &config, ranges);
}

/// Adds the characters of \p ranges that the font does not have yet.
void add_fallbacks(float pixels, const ImWchar* ranges) {
    for (const char* const file : fallback_files) {
        std::error_code ignored;
        if (!std::filesystem::is_regular_file(file, ignored)) continue;
        ImFontConfig config;
        config.MergeMode = true;
        ImGui::GetIO().Fonts->AddFontFromFileTTF(file, pixels, &config, ranges);
    }
}

}  // namespace

void need_glyphs(std::string_view text) {
    GuiState* const state = gui_state();
    if (state == nullptr) return;
    while (!text.empty()) {
        const auto character = first_character(text);
        text.remove_prefix(character ? character->size : 1);
        if (!character || character->code < 0x80 || character->code > 0xffff || is_usual(character->code))
            continue;
        if (is_control(character->code) || state->glyphs.size() >= max_glyphs) continue;
        if (state->glyphs.insert(static_cast<ImWchar>(character->code)).second) state->lacks_glyphs = true;
    }
}

void make_fonts(float scale, float density) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    GuiState* const state = gui_state();
    // The ranges must live until the atlas is built.
    const ImVector<ImWchar> others = ranges_of(state != nullptr ? state->glyphs : std::set<ImWchar>());
    for (const float height : {text_height, small_text_height}) {
        const float pixels = std::max(std::round(height * scale * density), 1.0F);
        add_typeface(pixels, usual_characters.data(), false);
        if (others.size() <= 1) continue;
        add_typeface(pixels, others.Data, true);
        add_fallbacks(pixels, others.Data);
    }
    io.Fonts->Build();
    io.FontGlobalScale = 1 / density;
    if (state != nullptr) state->lacks_glyphs = false;
}

}  // namespace interleaf
