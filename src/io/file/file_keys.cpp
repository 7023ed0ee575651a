#include "io/file/file_keys.h"

#include <algorithm>
#include <iterator>
#include <string_view>
#include <utility>

#include "family/field_units.h"
#include "hierarchy/field.h"

namespace interleaf {
namespace {

bool hold_scalar(const std::vector<Hierarchy>& keys, std::string_view name) {
    return std::ranges::any_of(keys, [&](const Hierarchy& key) {
        return find_field(key.fields, {std::string(name), FieldKind::scalar}) != nullptr;
    });
}

/// Brings \p one to the scales of \p all, as adopt_scales() (family/field_units.h) does it for keys of a family.
/// \pre \p one has a source per key
void unite_scales(FileKeys& all, FileKeys& one) {
    std::vector<std::string> names;
    for (const Hierarchy& key : one.keys)
        for (const Field& field : key.fields)
            if (field.kind == FieldKind::scalar && std::ranges::find(names, field.name) == names.end())
                names.push_back(field.name);
    for (const std::string& name : names) {
        const FieldScale theirs = scale_of(one.scales, name);
        FieldScale ours = scale_of(all.scales, name);
        if (!hold_scalar(all.keys, name)) ours.offset = theirs.offset;
        if (ours.unit.empty()) ours.unit = theirs.unit;
        for (std::size_t k = 0; k < one.keys.size(); ++k)
            shift_scalar(one.keys[k], one.sources[k].name, name, theirs.offset - ours.offset);
        set_scale(all.scales, std::move(ours));
    }
}

}  // namespace

void append_keys(FileKeys& all, FileKeys one, KeySource file) {
    if (one.sources.empty()) one.sources.push_back({std::move(file.name), 0});
    unite_scales(all, one);
    if (one.origin) all.origin = one.origin;
    for (KeySource& source : one.sources) all.sources.push_back({std::move(source.name), file.file});
    std::ranges::move(one.keys, std::back_inserter(all.keys));
    std::ranges::move(one.remarks, std::back_inserter(all.remarks));
}

}  // namespace interleaf
