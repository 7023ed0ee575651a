#include "io/page/page_payload.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <libdeflate.h>

#include "family/family_fields.h"
#include "hierarchy/error.h"
#include "hierarchy/union_mesh.h"
#include "io/family/composition.h"
#include "io/text/base64.h"

namespace interleaf {

namespace {

using nlohmann::ordered_json;
using Numbers = std::vector<std::int32_t>;

struct Bounds {
    glm::dvec3 low{std::numeric_limits<double>::infinity()};
    glm::dvec3 high{-std::numeric_limits<double>::infinity()};
};

Bounds bounds_of_keys(const Family& family) {
    Bounds box;
    for (const Key& key : family.keys)
        for (const glm::vec3& position : key.hierarchy->positions) {
            box.low = glm::min(box.low, glm::dvec3(position));
            box.high = glm::max(box.high, glm::dvec3(position));
        }
    return box;
}

/// Appends the numbers as three planes of bytes, lowest bytes first, each number with its sign in the lowest
/// bit.
void append_planes(std::string& bytes, const Numbers& numbers) {
    for (const unsigned shift : {0U, 8U, 16U})
        for (const std::int32_t number : numbers) {
            const auto folded =
                static_cast<std::uint32_t>(number) << 1 ^ static_cast<std::uint32_t>(number >> 31);
            bytes += static_cast<char>(folded >> shift & 0xff);
        }
}

/// The differences of each index from the one before.
Numbers differences(std::span<const Index> indices) {
    Numbers result;
    result.reserve(indices.size());
    Index before = 0;
    for (const Index index : indices) {
        result.push_back(static_cast<std::int32_t>(index - before));
        before = index;
    }
    return result;
}

/// What each number of a vertex differs by from the mean, rounded down, of the ends of the edge that the
/// vertex bisects.
/// \param vertices  of the union of the key alone, whose numbering is the key's
Numbers residuals(const Numbers& numbers, std::span<const VertexOrigin> vertices) {
    Numbers result = numbers;
    for (std::size_t v = 0; v < vertices.size(); ++v) {
        const auto [a, b] = vertices[v].edge;
        if (a != no_index) result[v] -= (numbers[a] + numbers[b]) >> 1;
    }
    return result;
}

/// Appends the residuals of numbers per vertex.
/// \param parts  all x, all y, all z; or all values of a scalar
void append_values(std::string& bytes, std::span<const VertexOrigin> vertices,
                   const std::vector<Numbers>& parts) {
    Numbers all;
    all.reserve(vertices.size() * parts.size());
    for (const Numbers& part : parts) {
        const Numbers residual = residuals(part, vertices);
        all.insert(all.end(), residual.begin(), residual.end());
    }
    append_planes(bytes, all);
}

std::vector<Numbers> whole_positions(const Hierarchy& key, const glm::dvec3& low, double unit) {
    std::vector<Numbers> parts(3);
    for (glm::length_t c = 0; c < 3; ++c)
        for (const glm::vec3& position : key.positions)
            parts[static_cast<std::size_t>(c)].push_back(
                static_cast<std::int32_t>(std::lround((double{position[c]} - low[c]) / unit)));
    return parts;
}

std::vector<Numbers> whole_values(const Field& field, const FamilyField& range) {
    const std::size_t width = component_count(field.kind);
    const bool is_color = field.kind == FieldKind::color;
    const double least = is_color ? 0 : double{range.min};
    const double extent = is_color ? 1 : double{range.max} - least;
    const double steps = is_color ? 255 : page_steps;
    std::vector<Numbers> parts(width);
    for (std::size_t n = 0; n < field.values.size(); ++n) {
        const double part = extent > 0 ? (double{field.values[n]} - least) / extent : 0;
        parts[n % width].push_back(static_cast<std::int32_t>(std::lround(part * steps)));
    }
    return parts;
}

/// The fields that all keys have.
std::vector<FamilyField> common_fields_of(const Family& family) {
    std::vector<FamilyField> common = fields_of(family);
    std::erase_if(common, [&family](const FamilyField& field) {
        return std::ranges::any_of(family.keys, [&](const Key& key) {
            return find_field(key.hierarchy->fields, field.label) == nullptr;
        });
    });
    return common;
}

std::string compressed(std::string_view bytes) {
    constexpr int thorough = 12;
    const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
        libdeflate_alloc_compressor(thorough), &libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    std::string result(libdeflate_zlib_compress_bound(compressor.get(), bytes.size()), '\0');
    result.resize(
        libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), result.data(), result.size()));
    return result;
}

void append_key(std::string& bytes, const Hierarchy& key, std::span<const FamilyField> fields,
                const Bounds& box, double unit) {
    const Hierarchy* const only = &key;
    const UnionMesh alone = unite(std::span(&only, 1));
    for (std::size_t node = 0; node < key.node_count(); node += 8)
        bytes += static_cast<char>(key.bits[node / 64] >> node % 64 & 0xff);
    append_planes(bytes, differences(key.midpoints));
    append_values(bytes, alone.vertices, whole_positions(key, box.low, unit));
    for (const FamilyField& field : fields)
        append_values(bytes, alone.vertices, whole_values(*find_field(key.fields, field.label), field));
}

ordered_json fields_json(std::span<const FamilyField> fields) {
    ordered_json array = ordered_json::array();
    for (const FamilyField& field : fields) {
        ordered_json json = {{"name", field.label.name}, {"kind", name_of(field.label.kind)}};
        if (field.label.kind == FieldKind::scalar) json.update({{"min", field.min}, {"max", field.max}});
        if (field.offset != 0) json["offset"] = field.offset;
        if (!field.unit.empty()) json["unit"] = field.unit;
        array.push_back(std::move(json));
    }
    return array;
}

}  // namespace

PagePayload page_payload(const Family& family, const Progress& progress) {
    const Bounds box = bounds_of_keys(family);
    const glm::dvec3 size = box.high - box.low;
    const double longest = std::max({size.x, size.y, size.z});
    const double unit = longest > 0 ? longest / page_steps : 1;
    const std::vector<FamilyField> fields = common_fields_of(family);
    const RootComplex& roots = family.keys.front().hierarchy->roots;

    PagePayload payload{ordered_json::parse(composition_text(family)), {}};
    ordered_json& description = payload.description;
    description["unit"] = unit;
    description["box"] = {{box.low.x, box.low.y, box.low.z}, {box.high.x, box.high.y, box.high.z}};
    description["roots"] = roots.triangle_count();
    description["rootVertices"] = roots.vertex_count();
    description["fields"] = fields_json(fields);

    std::string bytes;
    append_planes(bytes,
                  differences(std::span(roots.triangles().front().data(), 3 * roots.triangles().size())));
    const auto report = [&progress](std::string_view stage, double part) {
        if (progress && !progress(stage, part)) throw Cancelled();
    };
    for (std::size_t i = 0; i < family.keys.size(); ++i) {
        report("keys", 0.5 * static_cast<double>(i) / static_cast<double>(family.keys.size()));
        const Hierarchy& key = *family.keys[i].hierarchy;
        if (key.vertex_count() > max_page_vertices)
            throw InputError(
                fmt::format("a key has {} vertices; a web page holds keys of at most {}, which "
                            "`interleaf lod` makes",
                            key.vertex_count(), max_page_vertices));
        description["keys"][i]["vertices"] = key.vertex_count();
        description["keys"][i]["bisections"] = key.midpoints.size();
        append_key(bytes, key, fields, box, unit);
    }
    report("compressing", 0.5);
    payload.base64 = to_base64(compressed(bytes));
    return payload;
}

}  // namespace interleaf
