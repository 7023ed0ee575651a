// Reads the corpus of a target, and randomly damaged files. Nothing may crash, hang, take memory out of
// proportion or give an unsound result.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "fuzz/allocation_count.h"
#include "fuzz/mutation.h"
#include "fuzz/target.h"
#include <doctest/doctest.h>

#include "hierarchy/buffer.h"

namespace interleaf::fuzz {

namespace {

namespace fs = std::filesystem;

Bytes bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    REQUIRE(stream.good());
    const std::string text{std::istreambuf_iterator<char>(stream), {}};
    const ByteSpan bytes = std::as_bytes(std::span(text));
    return {bytes.begin(), bytes.end()};
}

std::vector<fs::path> corpus() {
    std::vector<fs::path> files{fs::directory_iterator(fs::path(INTERLEAF_CORPORA) / target.name), {}};
    std::ranges::sort(files);
    return files;
}

/// The number of mutated files to read. The environment may ask for more than an everyday test needs.
unsigned mutation_count() {
    const char* const text = std::getenv("INTERLEAF_MUTATIONS");
    return text == nullptr ? 4000 : static_cast<unsigned>(std::strtoul(text, nullptr, 10));
}

}  // namespace

TEST_CASE("memory is counted, of any size") {
    for (const std::size_t size : {std::size_t{1000}, std::size_t{50'000'000}}) {
        begin_count();
        { const Buffer<char> large(size); }
        { const std::vector<char> ordinary(size); }
        CHECK(max_bytes() >= size);
        CHECK(max_bytes() < size + size / 2);
    }
}

TEST_CASE("every file of the corpus is read, or rejected with an error") {
    std::size_t accepted = 0;
    for (const fs::path& file : corpus()) {
        CAPTURE(file.filename());
        const Outcome outcome = outcome_of(bytes_of(file));
        CHECK(outcome.fault == "");
        accepted += outcome.accepted;
    }
    CHECK(accepted >= 4);
}

TEST_CASE("a file that is split into parts and joined again is read as before") {
    for (const fs::path& path : corpus()) {
        CAPTURE(path.filename());
        const Bytes file = bytes_of(path);
        if (!outcome_of(file).accepted) continue;
        CHECK(outcome_of(target.file(target.parts(file), true)).accepted);
        CHECK(outcome_of(target.file(target.parts(file), false)).accepted);
    }
}

TEST_CASE("mutated files do no harm") {
    const std::vector<fs::path> files = corpus();
    std::vector<Bytes> originals;
    std::ranges::transform(files, std::back_inserter(originals), bytes_of);
    const unsigned count = mutation_count();
    std::size_t accepted = 0;
    for (unsigned seed = 0; seed < count; ++seed) {
        std::mt19937 random(seed);
        const std::size_t which = seed % originals.size();
        const Outcome outcome = outcome_of(mutated(originals[which], random));
        accepted += outcome.accepted;
        if (outcome.fault.empty()) continue;
        CAPTURE(seed);
        CAPTURE(files[which].filename());
        CHECK(outcome.fault == "");
    }
    MESSAGE(count, " mutated files, seeds from 0: ", accepted, " read, the others refused");
    CHECK(accepted > count / 50);
    CHECK(accepted < count);
}

}  // namespace interleaf::fuzz
