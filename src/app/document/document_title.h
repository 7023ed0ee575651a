// The title of a document in the window's title and in the menu bar.
#pragma once

#include <string>

#include "app/document/document.h"

namespace interleaf {

/// The family's name, followed by the name of its folder if that differs, and preceded by a bullet if the
/// document has changed: "• Five keys (copy)". A folder "five-keys" does not differ from a name "Five keys".
std::string title_of(const Document& document);

}  // namespace interleaf
