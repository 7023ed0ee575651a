#include "special_cases.h"

#include <algorithm>
#include <set>
#include <vector>

namespace interleaf::bench {
namespace {

/// How one key lies over a leaf: its Lie times four plus its line.
using Code = unsigned;
using Configuration = std::vector<Code>;

constexpr Code code(Lie lie, unsigned line) {
    return 4 * static_cast<unsigned>(lie) + line;
}

constexpr Lie lie_of(Code code) {
    return static_cast<Lie>(code / 4);
}

constexpr std::array<std::array<unsigned, 4>, 6> symmetries = {{{0, 1, 2, no_line},
                                                                {1, 2, 0, no_line},
                                                                {2, 0, 1, no_line},
                                                                {0, 2, 1, no_line},
                                                                {2, 1, 0, no_line},
                                                                {1, 0, 2, no_line}}};

/// The first of all configurations that differ from \p codes by a symmetry or by the order of keys.
Configuration canonical(const Configuration& codes) {
    Configuration first;
    for (const auto& symmetry : symmetries) {
        Configuration turned;
        for (const Code each : codes) turned.push_back(code(lie_of(each), symmetry[each % 4]));
        std::sort(turned.begin(), turned.end());
        if (first.empty() || turned < first) first = turned;
    }
    return first;
}

void add_possible(Configuration& chosen, std::size_t key_count, std::set<Configuration>& found) {
    if (chosen.size() == key_count) {
        if (std::any_of(chosen.begin(), chosen.end(), [](Code each) { return lie_of(each) == Lie::leaf; }))
            found.insert(canonical(chosen));
        return;
    }
    std::vector<Code> all = {code(Lie::whole, no_line), code(Lie::half, no_line)};
    for (unsigned line = 0; line <= no_line; ++line) all.push_back(code(Lie::leaf, line));
    for (unsigned line = 0; line < no_line; ++line) all.push_back(code(Lie::across, line));
    for (const Code each : all) {
        chosen.push_back(each);
        add_possible(chosen, key_count, found);
        chosen.pop_back();
    }
}

void count_green_pairs(bool is_split, std::span<const KeyOverNode> over, std::vector<GreenPairs>& pairs) {
    for (std::size_t key = 0; key < over.size(); ++key) {
        if (over[key].lie != Lie::leaf || !over[key].is_cut()) continue;
        const bool is_crossed = std::any_of(over.begin(), over.end(), [&](const KeyOverNode& other) {
            return other.is_cut() && other.line != over[key].line;
        });
        ++(is_split ? pairs[key].split_red : is_crossed ? pairs[key].crossed : pairs[key].kept);
    }
}

}  // namespace

SpecialCases special_cases(const Overlay& overlay, std::span<const RedGreenKey> keys) {
    SpecialCases cases;
    cases.green_pairs.resize(keys.size());
    for (const OverlayLeaf& leaf : overlay.leaves) ++cases.leaves[static_cast<std::size_t>(leaf.kind)];

    std::set<Configuration> occurring;
    visit_nodes(overlay.forest, keys, [&](Index node, std::span<const KeyOverNode> over) {
        const bool is_split = overlay.forest.is_split(node);
        count_green_pairs(is_split, over, cases.green_pairs);
        if (is_split) {
            // The line passes through the middle of one inner edge, whose ends lie on either side of it. That
            // middle is a vertex of the overlay: the edge's triangles are split there, or the line halves
            // them.
            cases.means_that_fail += static_cast<std::size_t>(
                std::count_if(over.begin(), over.end(), [](const KeyOverNode& key) { return key.is_cut(); }));
            return;
        }
        Configuration codes;
        for (const KeyOverNode& key : over) codes.push_back(code(key.lie, key.line));
        occurring.insert(canonical(codes));
    });
    cases.configurations = occurring.size();

    std::set<Configuration> possible;
    Configuration none;
    add_possible(none, keys.size(), possible);
    cases.possible_configurations = possible.size();
    return cases;
}

}  // namespace interleaf::bench
