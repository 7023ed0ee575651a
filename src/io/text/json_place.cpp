#include "io/text/json_place.h"

#include <algorithm>

#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf {

namespace {

using nlohmann::json;

/// A short description of \p value.
std::string description(const json& value) {
    switch (value.type()) {
        case json::value_t::object:
            return "an object";
        case json::value_t::array:
            return "an array";
        case json::value_t::string:
            return in_quotes(value.get_ref<const std::string&>());
        default:
            return value.dump();
    }
}

/// "line 3: " if \p message says that a number in \p text is too large. Such a message ends in "'1e999'" and
/// names no place; all other messages name theirs.
std::string place_of_overflow(std::string_view message, std::string_view text) {
    if (!message.starts_with("number overflow")) return {};
    const std::string_view rest = message.substr(std::min(message.find('\'') + 1, message.size()));
    const std::size_t place = text.find(rest.substr(0, rest.find('\'')));
    return fmt::format("line {}: ", 1 + std::ranges::count(text.substr(0, place), '\n'));
}

/// An upper bound of the number of values in \p text. Every value but the first follows a comma or begins an
/// array or object.
std::size_t max_values_in(std::string_view text) {
    std::size_t count = 1;
    bool in_string = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (c == '"') in_string = !in_string;
        if (in_string && c == '\\') ++i;
        count += !in_string && (c == ',' || c == '[' || c == '{');
    }
    return count;
}

}  // namespace

JsonPlace JsonPlace::member(std::string_view name) const {
    if (std::optional<JsonPlace> found = optional_member(name)) return *found;
    fail(fmt::format("has no \"{}\"", name));
}

std::optional<JsonPlace> JsonPlace::optional_member(std::string_view name) const {
    if (!value_->is_object()) fail_expecting("an object");
    const auto found = value_->find(name);
    if (found == value_->end()) return std::nullopt;
    return JsonPlace(*found, file_, path_.empty() ? std::string(name) : fmt::format("{}.{}", path_, name));
}

std::vector<std::string> JsonPlace::member_names() const {
    if (!value_->is_object()) fail_expecting("an object");
    std::vector<std::string> names;
    for (const auto& [name, value] : value_->items()) names.push_back(name);
    return names;
}

std::size_t JsonPlace::size() const {
    if (!value_->is_array()) fail_expecting("an array");
    return value_->size();
}

JsonPlace JsonPlace::element(std::size_t index) const {
    return {value_->at(index), file_, fmt::format("{}[{}]", path_, index)};
}

std::string JsonPlace::string() const {
    if (!value_->is_string()) fail_expecting("a text");
    return value_->get<std::string>();
}

double JsonPlace::number() const {
    if (!value_->is_number()) fail_expecting("a number");
    return value_->get<double>();
}

bool JsonPlace::boolean() const {
    if (!value_->is_boolean()) fail_expecting("true or false");
    return value_->get<bool>();
}

std::uint32_t JsonPlace::index_below(std::size_t limit) const {
    if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() >= limit)
        fail_expecting(fmt::format("a whole number from 0, below {}", limit));
    return value_->get<std::uint32_t>();
}

void JsonPlace::fail(std::string_view what) const {
    throw InputError(fmt::format("{}: {}: {}", file_, path_.empty() ? "document" : path_, what));
}

void JsonPlace::fail_expecting(std::string_view what) const {
    fail(fmt::format("is {}, expected {}", description(*value_), what));
}

json parse_json(std::string_view text, std::string_view file) {
    if (max_values_in(text) > max_json_values)
        throw InputError(
            fmt::format("{}: document: has too many values, expected at most {}", file, max_json_values));
    try {
        return json::parse(text);
    } catch (const json::exception& error) {
        // "[json.exception.parse_error.101] parse error at line 1, column 2: ...": we drop the bracket, which
        // is for programmers. The message quotes the last text read, which may be long, so we cut it.
        const std::string_view what = error.what();
        constexpr std::size_t longest_shown = 200;
        const std::string_view shown = what.substr(what.find("] ") + 2);
        throw InputError(fmt::format("{}: {}{}{}", file, place_of_overflow(shown, text),
                                     shown.substr(0, longest_shown),
                                     shown.size() > longest_shown ? "..." : ""));
    }
}

std::string in_quotes(std::string_view text) {
    constexpr std::size_t longest_shown = 80;
    const std::string shown(text.substr(0, longest_shown));
    return json(shown + (text.size() > longest_shown ? "..." : ""))
        .dump(-1, ' ', true, json::error_handler_t::replace);
}

}  // namespace interleaf
