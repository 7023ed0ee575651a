// Reads the log of KHR_debug.
#include "render/debug_messages.h"

#include <glad/gl.h>

#include "render/context.h"

namespace interleaf {

void collect_debug_messages() {
    if (GLAD_GL_KHR_debug == 0) return;
    glEnable(GL_DEBUG_OUTPUT);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DEBUG_SEVERITY_NOTIFICATION, 0, nullptr, GL_FALSE);
}

std::vector<std::string> take_debug_messages() {
    std::vector<std::string> messages;
    if (GLAD_GL_KHR_debug == 0) return messages;
    GLint longest = 0;
    glGetIntegerv(GL_MAX_DEBUG_MESSAGE_LENGTH, &longest);
    std::string text(static_cast<std::size_t>(longest), '\0');
    GLsizei length = 0;
    while (glGetDebugMessageLog(1, longest, nullptr, nullptr, nullptr, nullptr, &length, text.data()) == 1)
        messages.emplace_back(text.data());  // the text ends with a zero
    return messages;
}

}  // namespace interleaf
