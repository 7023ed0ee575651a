// A reader under attack, and how a file for it is taken apart and put together again, so that mutations reach
// what lies behind checksums, counts and compression. Each target is one small file, target_NAME.cpp, and a
// word in CMakeLists.txt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace interleaf::fuzz {

using Bytes = std::vector<std::byte>;
using ByteSpan = std::span<const std::byte>;

/// What is unsound about something that was read; empty if nothing is.
using Inspection = std::function<std::string()>;

struct Target {
    /// Reads a file with the given bytes. \throw InputError as the reader does; any other exception is a
    /// fault
    Inspection (*read)(ByteSpan file);

    /// The parts of a file, without what guards them; none if it is too damaged to have any.
    std::vector<Bytes> (*parts)(ByteSpan file);

    /// The file with the given parts: checksums are right, and counts too unless \p keeps_counts.
    Bytes (*file)(std::vector<Bytes> parts, bool keeps_counts);

    /// Bytes that the file stands for: more than its own where it is compressed.
    std::uint64_t (*content_size)(ByteSpan file);
};

/// The target that is linked into this program.
extern const Target target;

/// For formats without guards: the file is its only part.
std::vector<Bytes> whole_as_part(ByteSpan file);
Bytes first_part(std::vector<Bytes> parts, bool keeps_counts);
std::uint64_t own_size(ByteSpan file);

struct Outcome {
    bool accepted;      ///< rather than refused
    std::string fault;  ///< an exception that is no InputError, more than a second (ten under sanitizers) of
                        ///< the processor's time, more than ten times the size of the content and 64 MB of
                        ///< memory, something unsound; empty if nothing
};

/// How the target takes \p file.
Outcome outcome_of(ByteSpan file);

}  // namespace interleaf::fuzz
