// The core: union, normals and morph of three keys, compared with a copy of the same bytes, which is the
// limit set by memory. Also the memory of frozen keys, compared with the plain indexed mesh of the same
// leaves.
#include <cstring>
#include <vector>

#include "keys.h"
#include <Eigen/Core>
#include <benchmark/benchmark.h>

#include "hierarchy/checker.h"
#include "hierarchy/morph.h"
#include "hierarchy/union_mesh.h"
#include "hierarchy/vertex_normals.h"

namespace {

using namespace interleaf;

constexpr Index leaves_a_key = 200000;

struct ThreeKeys {
    std::vector<Hierarchy> keys;
    std::vector<const Hierarchy*> pointers;
};

template <typename MakeKey>
ThreeKeys three(MakeKey make_key) {
    ThreeKeys result;
    for (const unsigned n : {0U, 5U, 8U}) result.keys.push_back(make_key(leaves_a_key, n));
    for (const Hierarchy& key : result.keys) result.pointers.push_back(&key);
    return result;
}

/// Keys refined at random all over; the union has about twice the leaves of one key.
const ThreeKeys& random_keys() {
    static const ThreeKeys keys = three(bench::random_key);
    return keys;
}

/// Keys refined at different places; the union has nearly the leaves of all three.
const ThreeKeys& local_keys() {
    static const ThreeKeys keys = three(bench::local_key);
    return keys;
}

/// Keys of which each is a part of the next; the union is the last key.
const ThreeKeys& nested_keys() {
    static const ThreeKeys keys = [] {
        ThreeKeys result;
        for (const Index leaves : {50000U, 100000U, 200000U})
            result.keys.push_back(bench::random_key(leaves, 1));
        for (const Hierarchy& key : result.keys) result.pointers.push_back(&key);
        return result;
    }();
    return keys;
}

void count_leaves(benchmark::State& state, std::size_t leaves) {
    state.counters["leaves"] = static_cast<double>(leaves);
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(leaves));
}

/// Bytes that a union writes: leaves with tag and origin, vertices with one position per key.
std::size_t union_bytes(const UnionMesh& mesh) {
    return mesh.leaf_count() * (sizeof(Triangle) + sizeof(LeafTag) + sizeof(KeySet)) +
           mesh.vertex_count() * (sizeof(VertexOrigin) + mesh.key_count() * sizeof(glm::vec3));
}

void union_reused(benchmark::State& state, const ThreeKeys& keys) {
    UnionMesh mesh;
    for (auto _ : state) {
        unite(keys.pointers, mesh);
        benchmark::DoNotOptimize(mesh.triangles.data());
    }
    count_leaves(state, mesh.leaf_count());
}

void union_fresh(benchmark::State& state, const ThreeKeys& keys) {
    std::size_t leaves = 0;
    for (auto _ : state) {
        const UnionMesh mesh = unite(keys.pointers);
        leaves = mesh.leaf_count();
    }
    count_leaves(state, leaves);
}

void copy_of_union(benchmark::State& state) {
    const UnionMesh mesh = unite(local_keys().pointers);
    const std::vector<char> from(union_bytes(mesh), 1);
    std::vector<char> to(from.size());
    for (auto _ : state) {
        std::memcpy(to.data(), from.data(), from.size());
        benchmark::DoNotOptimize(to.data());
        benchmark::ClobberMemory();
    }
    count_leaves(state, mesh.leaf_count());
}

void normals_reused(benchmark::State& state, const ThreeKeys& keys) {
    const UnionMesh mesh = unite(keys.pointers);
    NormalForm form;
    for (auto _ : state) {
        normal_form(mesh, form);
        benchmark::DoNotOptimize(form.products.data());
    }
    count_leaves(state, mesh.leaf_count());
}

/// Three filled streams with as many vertices as the first argument of \p state.
std::vector<Buffer<glm::vec3>> three_streams(const benchmark::State& state) {
    std::vector<Buffer<glm::vec3>> streams(3);
    for (std::size_t s = 0; s < 3; ++s)
        streams[s].assign(static_cast<std::size_t>(state.range(0)), glm::vec3(static_cast<float>(s), 1, 2));
    return streams;
}

constexpr float blend[] = {0.2F, 0.3F, 0.5F};

/// Counts the bytes that a weighted sum of three streams reads and writes, as STREAM does.
void count_blended(benchmark::State& state) {
    state.SetBytesProcessed(state.iterations() * state.range(0) * std::int64_t{4 * sizeof(glm::vec3)});
}

void morph_streams(benchmark::State& state) {
    const auto streams = three_streams(state);
    Buffer<glm::vec3> sum;
    weighted_sum(streams, blend, sum);  // touches the pages of the sum, as the other benchmarks do
    for (auto _ : state) {
        weighted_sum(streams, blend, sum);
        benchmark::DoNotOptimize(sum.data());
        benchmark::ClobberMemory();
    }
    count_blended(state);
}

void morph_eigen(benchmark::State& state) {
    const auto streams = three_streams(state);
    using Array = Eigen::Map<const Eigen::ArrayXf>;
    const auto length = 3 * static_cast<Eigen::Index>(state.range(0));
    const Array first(&streams[0][0].x, length), second(&streams[1][0].x, length),
        third(&streams[2][0].x, length);
    Buffer<float> memory(static_cast<std::size_t>(length), 0.0F);
    Eigen::Map<Eigen::ArrayXf> sum(memory.data(), length);
    for (auto _ : state) {
        sum = blend[0] * first + blend[1] * second + blend[2] * third;
        benchmark::DoNotOptimize(sum.data());
        benchmark::ClobberMemory();
    }
    count_blended(state);
}

/// a = b + factor * c, as in STREAM, over the same number of bytes in total.
void triad(benchmark::State& state) {
    const auto length = static_cast<std::size_t>(state.range(0)) * 4;
    Buffer<float> a(length, 0.0F), b(length, 1.0F), c(length, 2.0F);
    for (auto _ : state) {
        for (std::size_t n = 0; n < length; ++n) a[n] = b[n] + 3.0F * c[n];
        benchmark::DoNotOptimize(a.data());
        benchmark::ClobberMemory();
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(3 * sizeof(float) * length));
}

void check_key(benchmark::State& state, const ThreeKeys& keys) {
    for (auto _ : state) benchmark::DoNotOptimize(check(keys.keys[0]));
    count_leaves(state, keys.keys[0].leaf_count());
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(keys.keys[0].byte_count()));
}

void key_memory(benchmark::State& state) {
    const Hierarchy key = bench::random_key(static_cast<Index>(state.range(0)), 1);
    for (auto _ : state) benchmark::DoNotOptimize(key.byte_count());
    const auto leaves = static_cast<double>(key.leaf_count());
    const auto indexed =
        static_cast<double>(key.vertex_count() * sizeof(glm::vec3) + key.leaf_count() * sizeof(Triangle));
    state.counters["leaves"] = leaves;
    state.counters["bytes_per_leaf"] = static_cast<double>(key.byte_count()) / leaves;
    state.counters["indexed_mesh_bytes_per_leaf"] = indexed / leaves;
}

BENCHMARK_CAPTURE(union_reused, local, local_keys())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(union_reused, random, random_keys())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(union_reused, nested, nested_keys())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(union_fresh, local, local_keys())->Unit(benchmark::kMillisecond);
BENCHMARK(copy_of_union)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(normals_reused, local, local_keys())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(normals_reused, random, random_keys())->Unit(benchmark::kMillisecond);
BENCHMARK(morph_streams)->Arg(300'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(morph_eigen)->Arg(300'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK(triad)->Arg(300'000)->Arg(10'000'000)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(check_key, random, random_keys())->Unit(benchmark::kMillisecond);
BENCHMARK(key_memory)->Arg(5000)->Arg(20000)->Arg(200000)->Iterations(1);

}  // namespace
