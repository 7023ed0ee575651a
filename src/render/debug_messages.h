// KHR_debug messages. OpenGL keeps them in a log of the context, so the program does not store them.
#pragma once

namespace interleaf {

/// Makes the current context log its messages, except notifications. Does nothing if the driver lacks
/// KHR_debug.
void collect_debug_messages();

}  // namespace interleaf
