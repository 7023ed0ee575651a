// The keys of commands in the texts of widgets, as the user has chosen them.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>

namespace interleaf {

/// \p text with the keys of \p commands behind it: "Play (Space)". Only the text where they have none.
/// \param commands  names of commands, as in the menus, without dots at the end
std::string with_keys(std::string_view text, std::initializer_list<std::string_view> commands);

}  // namespace interleaf
