// The entry points of libFuzzer: one reads a file, the other mutates a part of a file.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <utility>

#include "fuzz/target.h"

using interleaf::fuzz::Bytes;
using interleaf::fuzz::ByteSpan;
using interleaf::fuzz::target;

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);

namespace {

ByteSpan as_file(const std::uint8_t* data, std::size_t size) {
    return std::as_bytes(std::span(data, size));
}

void change(Bytes& part, std::size_t most) {
    const std::size_t size = part.size();
    part.resize(std::max<std::size_t>(most, size + 1));
    part.resize(LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(part.data()), size, part.size()));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string fault = interleaf::fuzz::outcome_of(as_file(data, size)).fault;
    if (fault.empty()) return 0;
    std::fprintf(stderr, "FAULT: %s\n", fault.c_str());
    std::abort();
}

extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                               unsigned seed) {
    std::mt19937 random(seed);
    std::vector<Bytes> parts = target.parts(as_file(data, size));
    if (!parts.empty() && random() % 8 != 0) {
        Bytes& part = parts[random() % parts.size()];
        change(part, part.size() + std::min<std::size_t>(most - size, 256));
        const Bytes file = target.file(std::move(parts), random() % 4 == 0);
        if (file.size() <= most) {
            std::memcpy(data, file.data(), file.size());
            return file.size();
        }
    }
    return LLVMFuzzerMutate(data, size, most);
}
