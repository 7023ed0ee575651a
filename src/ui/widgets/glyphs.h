// The typeface's characters. Latin, Greek and Cyrillic are always there. Characters of other scripts are taken from
// the fonts of the system when a text first needs them.
#pragma once

#include <string_view>

namespace interleaf {

/// Asks for the characters of \p text. Those that are missing are there when the window draws next.
/// Characters beyond U+FFFF are not supported.
void need_glyphs(std::string_view text);

/// Makes the fonts anew, with all characters that need_glyphs() has asked for.
/// \param scale  scale of the user interface
/// \param density  framebuffer pixels per screen coordinate
void make_fonts(float scale, float density);

/// Heights of the two fonts, at scale 1.
inline constexpr float text_height = 15;
inline constexpr float small_text_height = 13;

}  // namespace interleaf
