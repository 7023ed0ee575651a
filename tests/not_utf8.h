// Texts that no reader and no check may take for UTF-8.
#pragma once

#include <string>

namespace interleaf {

/// Each begins with no character: cut off, longer than necessary, a surrogate or beyond Unicode.
inline const std::string not_utf8[] = {"\x80",
                                       "\xbf",
                                       "\xff",
                                       "\xfe",
                                       "\xc3",
                                       "\xe4\xb8",
                                       "\xf0\x9f\x8c",
                                       "\xc0\x80",
                                       "\xc1\xbf",
                                       "\xe0\x9f\xbf",
                                       "\xed\xa0\x80",
                                       "\xed\xbf\xbf",
                                       "\xf0\x8f\xbf\xbf",
                                       "\xf4\x90\x80\x80",
                                       "\xf5\x80\x80\x80",
                                       "\xf8\x88\x80\x80\x80",
                                       "\xc3(",
                                       "\xe4(\xad"};

}  // namespace interleaf
