// What a document is called in the title of the window and in the menu bar.
#pragma once

#include <string>

#include "app/document/document.h"

namespace interleaf {

/// The family's name; the name of its folder behind it, where that says something else; and a bullet before
/// it, if it has changed: "• Five keys (copy)". A folder "five-keys" says the same as a name "Five keys".
std::string title_of(const Document& document);

}  // namespace interleaf
