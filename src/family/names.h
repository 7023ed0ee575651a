// Names of keys and families: the one rule for names, and a new name that keeps it. Files, the window and the
// command line all give names, so all of them ask here.
#pragma once

#include <functional>
#include <string>
#include <string_view>

namespace interleaf {

/// The fault of \p name as the name of a key or a family, in a sentence; empty if there is none. A name is not
/// empty, and is_printable() (text/characters.h).
/// \param bearer  whose name it is, such as "a key"; part of the sentence
std::string fault_of_name(std::string_view name, std::string_view bearer);

/// A name without fault that is not taken: \p wanted as shown_text() escapes it, or "key" if \p wanted is
/// empty. If that is taken, it gets the first free number from 2 on.
std::string unused_name(std::string_view wanted,
                        const std::function<bool(const std::string& name)>& is_taken);

}  // namespace interleaf
