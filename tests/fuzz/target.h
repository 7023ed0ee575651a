// A reader under attack, with functions that split its files into parts and join them again, so that
// mutations reach the content behind checksums, counts and compression. Each target is one small file,
// target_NAME.cpp, and one word in CMakeLists.txt.
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

/// Describes what is unsound about a value that was read; empty if nothing is.
using Inspection = std::function<std::string()>;

struct Target {
    const char* name;  ///< of the target, and of the folder of its corpus

    /// Reads a file with the given bytes.
    /// \throw InputError if the reader rejects the file; any other exception is a fault
    Inspection (*read)(ByteSpan file);

    /// The parts of a file, without checksums and counts; none if the file is too damaged to have parts.
    std::vector<Bytes> (*parts)(ByteSpan file);

    /// The file with the given parts and right checksums. Its counts are right, too, unless \p keeps_counts.
    Bytes (*file)(std::vector<Bytes> parts, bool keeps_counts);

    /// The number of bytes that the file stands for. For a compressed file this is more than its size.
    std::uint64_t (*content_size)(ByteSpan file);
};

/// The target that is linked into this program.
extern const Target target;

/// For formats without checksums and counts: the whole file is the only part.
std::vector<Bytes> whole_as_part(ByteSpan file);
Bytes first_part(std::vector<Bytes> parts, bool keeps_counts);
std::uint64_t own_size(ByteSpan file);

struct Outcome {
    bool accepted;  ///< false if the reader rejected the file

    /// One of these, or empty: an exception other than InputError; over one second of processor time (ten
    /// under sanitizers); more memory than ten times the size of the content plus 64 MB; an unsound result.
    std::string fault;
};

/// The result of reading \p file with the target.
Outcome outcome_of(ByteSpan file);

}  // namespace interleaf::fuzz
