#include "hierarchy/greedy.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace interleaf {

namespace {

struct Candidate {
    double error;
    Index leaf;
    /// Of the leaf when its error was computed; if it differs, the leaf has been bisected since.
    unsigned level;

    bool operator<(const Candidate& other) const {
        return error != other.error ? error < other.error : leaf > other.leaf;
    }
};

double rounded_to_12_bits(double value) {
    int exponent = 0;
    const double mantissa = std::frexp(value, &exponent);
    return std::ldexp(std::round(std::ldexp(mantissa, 12)), exponent - 12);
}

}  // namespace

void refine_greedily(AdaptiveMesh& mesh, const LeafError& error, const GreedyOptions& options) {
    std::priority_queue<Candidate> candidates;
    const auto add = [&](Index leaf) {
        const double value = error(mesh, leaf);
        if (value > options.tolerance) candidates.push({rounded_to_12_bits(value), leaf, mesh.level(leaf)});
    };
    for (Index leaf = 0; leaf < mesh.leaf_bound(); ++leaf)
        if (mesh.is_leaf(leaf)) add(leaf);

    std::vector<Index> changed;
    while (!candidates.empty() && mesh.leaf_count() < options.leaves) {
        const Candidate next = candidates.top();
        candidates.pop();
        if (mesh.level(next.leaf) != next.level) continue;
        if (mesh.leaves_added_by(next.leaf) > options.leaves - mesh.leaf_count()) continue;
        changed.clear();
        mesh.refine(std::span(&next.leaf, 1), &changed);
        if (options.after_step) options.after_step(mesh, changed);
        std::sort(changed.begin(), changed.end());
        changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
        for (const Index leaf : changed) add(leaf);
    }
}

}  // namespace interleaf
