// A value of a JSON document that knows its place in it, so that every error says where it is: "FILE:
// keys[2].file: ...".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

namespace interleaf {

/// Every function that asks for something throws an InputError naming the place, what is there and what was
/// expected.
class JsonPlace {
  public:
    /// The whole of \p document, which must outlive this; \p file stands for it in messages.
    JsonPlace(const nlohmann::json& document, std::string file) : value_(&document), file_(std::move(file)) {}

    /// The member \p name of this object.
    JsonPlace member(std::string_view name) const;

    /// The same; none if there is no such member.
    std::optional<JsonPlace> optional_member(std::string_view name) const;

    /// Number of elements of this array.
    std::size_t size() const;

    /// Element \p index of this array.
    JsonPlace element(std::size_t index) const;

    std::string string() const;

    /// This number; every number in a document is finite.
    double number() const;

    /// This number, which must be whole and in [0, \p limit).
    std::uint32_t index_below(std::size_t limit) const;

    /// Throws an InputError "FILE: PLACE: WHAT".
    [[noreturn]] void fail(std::string_view what) const;

    /// Throws an InputError that says what this is and that \p what was expected.
    [[noreturn]] void fail_expecting(std::string_view what) const;

  private:
    JsonPlace(const nlohmann::json& value, std::string file, std::string path)
        : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

    const nlohmann::json* value_;
    std::string file_;
    std::string path_;
};

/// Most values, arrays and objects among them, of a document: an empty object of 3 bytes takes 120 bytes of
/// memory.
inline constexpr std::size_t max_json_values = 500'000;

/// The document in \p text.
/// \throw InputError naming \p file and the line, unless it is JSON of at most max_json_values values
nlohmann::json parse_json(std::string_view text, std::string_view file);

/// The beginning of \p text in quotation marks, in ASCII with everything else escaped: fit to be shown on a
/// terminal, whatever it holds.
std::string in_quotes(std::string_view text);

}  // namespace interleaf
