// Blends the first two keys of a family half and half, and writes the result: blend FAMILY OUT.ilh
#include <cstdio>
#include <exception>

#include "family/family.h"
#include "hierarchy/morph.h"
#include "io/family/family_file.h"
#include "io/hierarchy/hierarchy_file.h"

int main(int argc, char** argv) try {
    if (argc != 3) {
        std::fputs("usage: blend FAMILY OUT.ilh\n", stderr);
        return 2;
    }
    const interleaf::Family family = interleaf::read_family(argv[1]);
    if (family.keys.size() < 2) {
        std::fputs("blend: the family has fewer than two keys\n", stderr);
        return 1;
    }
    // The union of two keys is a hierarchy over the same roots, so any weights give a key.
    const interleaf::UnionMesh mesh = interleaf::unite(family, {{0, 1.0}, {1, 1.0}});
    const float half[] = {0.5F, 0.5F};
    const interleaf::Hierarchy between = interleaf::morphed_hierarchy(mesh, half);
    interleaf::write_hierarchy(between, argv[2]);
    std::printf("%s: %u leaves\n", argv[2], between.leaf_count());
    return 0;
} catch (const std::exception& error) {
    std::fprintf(stderr, "blend: %s\n", error.what());
    return 1;
}
