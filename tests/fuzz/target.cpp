#include "fuzz/target.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <typeinfo>
#include <utility>

#include "fuzz/allocation_count.h"
#include "sanitized.h"
#include <fmt/core.h>

#include "hierarchy/error.h"

namespace interleaf::fuzz {

namespace {

/// Seconds of processor time that this program has used. A clock would measure too many on a busy machine.
double processor_time() {
    timespec time{};
    ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

/// The limits of target.h for a file.
struct Limits {
    std::uint64_t bytes;
    double seconds = is_sanitized ? 10 : 1;
};

std::string excess(ByteSpan file, std::size_t bytes, double seconds) {
    const Limits most{10 * std::max<std::uint64_t>(file.size(), target.content_size(file)) + 64'000'000};
    if (bytes > most.bytes) return fmt::format("{} bytes of memory for a file of {}", bytes, file.size());
    if (seconds > most.seconds) return fmt::format("{:.2f} s for a file of {} bytes", seconds, file.size());
    return {};
}

}  // namespace

std::vector<Bytes> whole_as_part(ByteSpan file) {
    return {Bytes(file.begin(), file.end())};
}

Bytes first_part(std::vector<Bytes> parts, bool) {
    return std::move(parts.front());
}

std::uint64_t own_size(ByteSpan file) {
    return file.size();
}

Outcome outcome_of(ByteSpan file) {
    Inspection inspect;
    const double started = processor_time();
    begin_count();
    try {
        inspect = target.read(file);
    } catch (const InputError&) {  // the reader rejected the file, as it may
    } catch (const std::exception& error) {
        return {false, fmt::format("{}: {}", typeid(error).name(), error.what())};
    }
    const std::size_t bytes = max_bytes();
    const std::string fault = excess(file, bytes, processor_time() - started);
    return {inspect != nullptr, fault.empty() && inspect ? inspect() : fault};
}

}  // namespace interleaf::fuzz
