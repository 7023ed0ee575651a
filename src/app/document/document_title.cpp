#include "app/document/document_title.h"

#include <algorithm>

#include <fmt/core.h>

#include "text/characters.h"
#include "text/shown_text.h"

namespace interleaf {

namespace {

std::string without_spelling(std::string_view name) {
    std::string same = folded(name);
    std::ranges::replace_if(
        same, [](char c) { return c == '-' || c == '_'; }, ' ');
    return same;
}

}  // namespace

std::string title_of(const Document& document) {
    const std::string& name = document.family().name;
    std::string title = fmt::format("{}{}", document.is_changed() ? "\u2022 " : "", name);
    if (!document.folder()) return title;
    const std::string folder = document.folder()->filename().native();
    if (without_spelling(folder) != without_spelling(name)) title += fmt::format(" ({})", shown_name(folder));
    return title;
}

}  // namespace interleaf
