// Hierarchy files: reading a plain key from the page cache and the parts of that, compared with a plain
// read() of the file; reading, writing and size of the compressed form. Rates are bytes of the plain file per
// second.
#include <cstddef>
#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "keys.h"
#include <benchmark/benchmark.h>
#include <libdeflate.h>
#include <unistd.h>

#include "hierarchy/checker.h"
#include "io/file/input_file.h"
#include "io/hierarchy/hierarchy_file.h"

namespace {

using namespace interleaf;

/// A key and its plain file, which is removed at the end.
class KeyFile {
  public:
    explicit KeyFile(Index leaves)
        : key(bench::random_key(leaves, 1)),
          file(std::filesystem::temp_directory_path() /
               ("interleaf-bench-" + std::to_string(::getpid()) + "-" + std::to_string(leaves) + ".ilh")) {
        write_hierarchy(key, file);
        size = std::filesystem::file_size(file);
    }
    KeyFile(const KeyFile&) = delete;
    KeyFile& operator=(const KeyFile&) = delete;
    ~KeyFile() {
        std::error_code ignored;
        std::filesystem::remove(file, ignored);
    }

    Hierarchy key;
    std::filesystem::path file;
    std::size_t size = 0;
};

/// The key with as many leaves as the first argument of \p state, made once.
const KeyFile& key_file(const benchmark::State& state) {
    static std::map<std::int64_t, std::unique_ptr<KeyFile>> files;
    std::unique_ptr<KeyFile>& file = files[state.range(0)];
    if (!file) file = std::make_unique<KeyFile>(static_cast<Index>(state.range(0)));
    return *file;
}

void count_bytes(benchmark::State& state, const KeyFile& file) {
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file.size));
    state.counters["leaves"] = static_cast<double>(file.key.leaf_count());
}

void file_read(benchmark::State& state) {
    const KeyFile& file = key_file(state);
    for (auto _ : state) benchmark::DoNotOptimize(read_hierarchy(file.file).positions.data());
    count_bytes(state, file);
}

/// The limit: reads the bytes of the file into memory that is already mapped.
void plain_read(benchmark::State& state) {
    const KeyFile& file = key_file(state);
    std::vector<std::byte> bytes(file.size);
    for (auto _ : state) {
        InputFile(file.file).read(bytes);
        benchmark::ClobberMemory();
    }
    count_bytes(state, file);
}

/// The same into memory that is new each time.
void plain_read_fresh(benchmark::State& state) {
    const KeyFile& file = key_file(state);
    for (auto _ : state) {
        Buffer<std::byte> bytes;
        bytes.resize(file.size);
        InputFile(file.file).read(bytes);
        benchmark::ClobberMemory();
    }
    count_bytes(state, file);
}

void checksum_alone(benchmark::State& state) {
    const KeyFile& file = key_file(state);
    const std::vector<std::byte> bytes = serialize_hierarchy(file.key);
    for (auto _ : state) benchmark::DoNotOptimize(libdeflate_crc32(0, bytes.data(), bytes.size()));
    count_bytes(state, file);
}

void check_alone(benchmark::State& state) {
    const KeyFile& file = key_file(state);
    for (auto _ : state) benchmark::DoNotOptimize(check(file.key).size());
    count_bytes(state, file);
}

void compress(benchmark::State& state, const HierarchyFileOptions& options) {
    const KeyFile& file = key_file(state);
    std::size_t size = 0;
    for (auto _ : state) size = serialize_hierarchy(file.key, options).size();
    count_bytes(state, file);
    state.counters["bytes_per_leaf"] = static_cast<double>(size) / static_cast<double>(file.key.leaf_count());
}

void decompress(benchmark::State& state, const HierarchyFileOptions& options) {
    const KeyFile& file = key_file(state);
    const std::vector<std::byte> bytes = serialize_hierarchy(file.key, options);
    for (auto _ : state) benchmark::DoNotOptimize(parse_hierarchy(bytes, "memory").positions.data());
    count_bytes(state, file);
}

constexpr HierarchyFileOptions lossless{.compressed = true, .rounding_bits = 0};
constexpr HierarchyFileOptions rounded{.compressed = true, .rounding_bits = 16};

void all_sizes(benchmark::internal::Benchmark* benchmark) {
    benchmark->Arg(40'000)->Arg(200'000)->Arg(5'000'000)->Unit(benchmark::kMillisecond);
}

BENCHMARK(file_read)->Apply(all_sizes);
BENCHMARK(plain_read)->Apply(all_sizes);
BENCHMARK(plain_read_fresh)->Apply(all_sizes);
BENCHMARK(checksum_alone)->Apply(all_sizes);
BENCHMARK(check_alone)->Apply(all_sizes);
BENCHMARK_CAPTURE(compress, lossless, lossless)->Arg(40'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(compress, rounded_16, rounded)->Arg(40'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decompress, lossless, lossless)->Arg(40'000)->Arg(200'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decompress, rounded_16, rounded)->Arg(40'000)->Arg(200'000)->Unit(benchmark::kMillisecond);

}  // namespace
