// Names of keys: what a name may be, and a name where there is none yet. Files, the window and the command
// line give names, so all of them ask here.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace interleaf {

/// What is wrong with \p name as the name of a key or of a family, as a sentence that begins with \p bearer;
/// empty if nothing is. A name is not empty, and is_printable() (text/characters.h). \param bearer  "a key"
std::string fault_of_name(std::string_view name, std::string_view bearer);

/// A name like \p wanted that has no fault and is not taken: \p wanted as shown_text() escapes it, "key" for
/// an empty one, with the first free number from 2 on where it is taken.
std::string unused_name(std::string_view wanted,
                        const std::function<bool(const std::string& name)>& is_taken);

}  // namespace interleaf
