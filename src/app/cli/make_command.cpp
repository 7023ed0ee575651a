#include "app/cli/make_command.h"

#include <fmt/core.h>

#include "app/document/builtin_family.h"
#include "hierarchy/error.h"
#include "io/family/family_file.h"

namespace interleaf {
namespace {

constexpr std::string_view family_name = "five-keys";

void make_family(const MakeOptions& options) {
    if (options.budget.leaves || options.budget.tolerance) {
        throw UsageError(fmt::format("make {}: --leaves and --tolerance are for single shapes", family_name));
    }
    if (options.form.compressed)
        throw UsageError(fmt::format("make {}: --compress is for single shapes", family_name));
    if (options.output == "-") throw UsageError(fmt::format("make {}: -o must name a folder", family_name));
    write_family(make_five_keys(), options.output);
}

}  // namespace

void run_make(const MakeOptions& options) {
    if (options.name == family_name) return make_family(options);
    const Shape* shape = find_shape(options.name);
    if (shape == nullptr) {
        throw UsageError(fmt::format("make: there is no shape '{}'; `interleaf make --list` lists the shapes",
                                     options.name));
    }
    write_output(key_target_of(options.output),
                 serialize_hierarchy(make_key(*shape, options.budget), options.form));
}

void list_shapes() {
    for (const Shape& shape : shapes()) fmt::print("{:<14}{}\n", shape.name, shape.description);
    fmt::print("{:<14}a folder with the built-in family of the first five shapes\n", family_name);
}

}  // namespace interleaf
