// KHR_debug messages. OpenGL keeps them in a log of the context, so nothing of ours collects them.
#pragma once

namespace interleaf {

/// Lets the current context log its messages, notifications left out. Does nothing where the driver lacks
/// KHR_debug.
void collect_debug_messages();

}  // namespace interleaf
