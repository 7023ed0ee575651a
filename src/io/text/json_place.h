// A value of a JSON document that knows its place in the document, so that every error names that place:
// "FILE: keys[2].file: ...".
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace interleaf {

/// Every function but is_object() throws an InputError if the value is not what the function expects. The error names
/// the place, what is there and what was expected.
class JsonPlace {
  public:
    /// The whole \p document, which must outlive this object. Messages call it \p file.
    JsonPlace(const nlohmann::json& document, std::string file) : value_(&document), file_(std::move(file)) {}

    /// The member \p name of this object.
    JsonPlace member(std::string_view name) const;

    /// The member \p name of this object; none if there is no such member.
    std::optional<JsonPlace> optional_member(std::string_view name) const;

    bool is_object() const { return value_->is_object(); }

    /// The names of the members of this object, in the order of their bytes.
    std::vector<std::string> member_names() const;

    /// The number of elements of this array.
    std::size_t size() const;

    /// Element \p index of this array.
    JsonPlace element(std::size_t index) const;

    std::string string() const;

    /// This number. Every number in a document is finite.
    double number() const;

    /// This value, true or false.
    bool boolean() const;

    /// This number, which must be whole and in [0, \p limit).
    std::uint32_t index_below(std::size_t limit) const;

    /// Throws an InputError "FILE: PLACE: WHAT".
    [[noreturn]] void fail(std::string_view what) const;

    /// Throws an InputError that describes this value and says that \p what was expected.
    [[noreturn]] void fail_expecting(std::string_view what) const;

  private:
    JsonPlace(const nlohmann::json& value, std::string file, std::string path)
        : value_(&value), file_(std::move(file)), path_(std::move(path)) {}

    const nlohmann::json* value_;
    std::string file_;
    std::string path_;
};

/// The largest number of values in a document, counting arrays and objects. The limit is needed because an
/// empty object of 3 bytes takes 120 bytes of memory.
inline constexpr std::size_t max_json_values = 500'000;

/// Parses the document in \p text. Messages call it \p file.
/// \throw InputError naming \p file and the line, unless \p text is JSON with at most max_json_values values
nlohmann::json parse_json(std::string_view text, std::string_view file);

/// The beginning of \p text in quotation marks, as ASCII with all other characters escaped. So it is safe to
/// print on a terminal.
std::string in_quotes(std::string_view text);

}  // namespace interleaf
