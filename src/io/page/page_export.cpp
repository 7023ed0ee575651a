#include "io/page/page_export.h"

#include <functional>
#include <map>
#include <string>
#include <string_view>

#include <fmt/core.h>

#include "hierarchy/error.h"
#include "io/page/embedded_page.h"
#include "io/page/page_payload.h"

namespace interleaf {

namespace {

/// The page's walk holds the active keys in the bits of a number.
constexpr std::size_t max_active_keys = 31;

/// \p text with each of \p characters replaced.
std::string escaped(std::string_view text, const std::map<char, std::string_view>& characters) {
    std::string result;
    for (const char c : text) {
        const auto found = characters.find(c);
        result += found == characters.end() ? std::string_view(&c, 1) : found->second;
    }
    return result;
}

/// Text between tags.
std::string escaped_text(std::string_view text) {
    return escaped(text, {{'&', "&amp;"}, {'<', "&lt;"}, {'>', "&gt;"}});
}

/// JSON within a script element: it contains no tag, and no comment that would hide the end of the script.
std::string escaped_json(std::string_view json) {
    return escaped(json, {{'<', "\\u003c"}, {'>', "\\u003e"}, {'&', "\\u0026"}});
}

void check_active_keys(const Family& family) {
    if (!family.timeline) return;
    for (const TimelineKey& key : family.timeline->keys())
        if (const std::size_t count = family.timeline->at(key.time).size(); count > max_active_keys)
            throw InputError(fmt::format("the timeline blends {} keys at once; a web page blends at most {}",
                                         count, max_active_keys));
}

/// The page with {{NAME}} replaced by the part of this name. Parts are not searched.
std::string filled(std::string_view page, const std::map<std::string, std::string_view, std::less<>>& parts) {
    std::string text;
    for (;;) {
        const std::size_t begin = page.find("{{");
        text += page.substr(0, begin);
        if (begin == std::string_view::npos) return text;
        const std::size_t end = page.find("}}", begin);
        text += parts.find(page.substr(begin + 2, end - begin - 2))->second;
        page.remove_prefix(end + 2);
    }
}

}  // namespace

void export_page(const Export& exported, const OutputTarget& target) {
    const Family& family = exported.family;
    check_active_keys(family);
    if (family.blend != BlendKind::straight && exported.remarks != nullptr)
        exported.remarks->emplace_back("a web page blends straight; parts of this family turn");
    const PagePayload payload = page_payload(family, exported.progress);
    const std::string title = escaped_text(family.name);
    const std::string description = escaped_json(
        payload.description.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
    std::map<std::string, std::string_view, std::less<>> parts;
    for (const EmbeddedPart& part : embedded_page()) parts.emplace(part.name, part.text);
    parts.emplace("title", title);
    parts.emplace("family", description);
    parts.emplace("data", payload.base64);
    report_progress(exported, "writing", 0.95);
    write_output(target, filled(parts.find("page.html")->second, parts));
}

}  // namespace interleaf
