// How often matching (fit/correspondence) finds the correspondence of generated bodies: star shapes with bumps, each on
// two unrelated meshes, one of them scaled, turned by up to 20 degrees and noisy.
//
// Usage: bench_generated_pairs [COUNT]. Prints one line of JSON: of the pairs of each of three sizes of meshes, the
// part within 2 % of the box diagonal, the mean errors without and with matching in %, and how many maps flip.
#include "fit/generated_pairs.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "json_line.h"

int main(int argc, char** argv) {
    using namespace interleaf;
    constexpr double enough = 0.02;
    const auto count = static_cast<std::uint64_t>(argc > 1 ? std::strtoul(argv[1], nullptr, 10) : 200);
    nlohmann::ordered_json line = {{"pairs", count}};
    std::uint64_t exact = 0;
    std::uint64_t unmatched = 0;
    std::uint64_t flipped = 0;
    double before = 0;
    double after = 0;
    double worst = 0;
    for (std::uint64_t seed = 1; seed <= count; ++seed) {
        const testing::PairFigures figures =
            testing::figures_of(testing::generated_pair(seed, 3 + static_cast<unsigned>(seed % 3)));
        exact += figures.mean_error <= enough ? 1U : 0U;
        unmatched += figures.is_matched ? 0U : 1U;
        flipped += figures.is_one_to_one ? 0U : 1U;
        before += figures.unmatched;
        after += figures.mean_error;
        worst = worst < figures.mean_error ? figures.mean_error : worst;
        if (figures.mean_error > enough)
            std::fprintf(stderr, "pair %llu: %.2f %%\n", static_cast<unsigned long long>(seed),
                         100 * figures.mean_error);
    }
    line.update({{"within_2_percent", double(exact) / double(count)},
                 {"unmatched", unmatched},
                 {"not_one_to_one", flipped},
                 {"mean_error_before", 100 * before / double(count)},
                 {"mean_error", 100 * after / double(count)},
                 {"worst_error", 100 * worst}});
    bench::print_line(line);
    return exact * 100 >= 95 * count && flipped == 0 ? 0 : 1;
}
