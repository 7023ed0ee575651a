#include "io/gltf/gltf_arrays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include <fmt/core.h>

#include "io/gltf/gltf_constants.h"

namespace interleaf {

namespace {

using gltf::Component;

constexpr std::array<std::string_view, 4> vector_types = {"SCALAR", "VEC2", "VEC3", "VEC4"};

std::size_t size_of(Component component) {
    switch (component) {
        case Component::int8:
        case Component::uint8:
            return 1;
        case Component::int16:
        case Component::uint16:
            return 2;
        case Component::uint32:
        case Component::float32:
            return 4;
    }
    return 0;
}

Component component_at(const JsonPlace& place) {
    const auto component = static_cast<Component>(place.index_below(0x10000));
    if (size_of(component) == 0) place.fail_expecting("a component type of glTF");
    return component;
}

template <typename T>
T stored(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
}

/// The number at \p bytes; a normalized integer divided by its largest value.
float number_at(const char* bytes, Component component, bool is_normalized) {
    const auto scaled = [is_normalized](float value, float largest) {
        return is_normalized ? std::max(value / largest, -1.0F) : value;
    };
    switch (component) {
        case Component::int8:
            return scaled(stored<std::int8_t>(bytes), 127);
        case Component::uint8:
            return scaled(stored<std::uint8_t>(bytes), 255);
        case Component::int16:
            return scaled(stored<std::int16_t>(bytes), 32767);
        case Component::uint16:
            return scaled(stored<std::uint16_t>(bytes), 65535);
        case Component::uint32:
            return static_cast<float>(stored<std::uint32_t>(bytes));
        case Component::float32:
            return stored<float>(bytes);
    }
    return 0;
}

Index index_at(const char* bytes, Component component) {
    switch (component) {
        case Component::uint8:
            return stored<std::uint8_t>(bytes);
        case Component::uint16:
            return stored<std::uint16_t>(bytes);
        default:
            return stored<std::uint32_t>(bytes);
    }
}

bool is_index(Component component) {
    return component == Component::uint8 || component == Component::uint16 || component == Component::uint32;
}

std::size_t optional_size(const JsonPlace& place, std::string_view member) {
    const auto found = place.optional_member(member);
    return found ? found->index_below(no_index) : 0;
}

/// Rows in a buffer view. All of them are inside the view.
struct Rows {
    const char* first = nullptr;
    std::size_t stride = 0;

    const char* row(std::size_t index) const { return first + index * stride; }
};

/// \p count rows of \p row_size bytes from the byte offset of \p place in its buffer view.
Rows rows_at(const GltfFile& file, const JsonPlace& place, std::size_t count, std::size_t row_size) {
    const JsonPlace view = file.element("bufferViews", place.member("bufferView").index_below(no_index));
    const JsonPlace number = view.member("buffer");
    const std::uint32_t buffer = number.index_below(no_index);
    if (buffer >= file.buffers.size()) number.fail_expecting("the number of a buffer");
    const std::string& bytes = file.buffers[buffer];
    const std::uint64_t begin = optional_size(view, "byteOffset");
    const std::uint64_t length = view.member("byteLength").index_below(no_index);
    if (begin + length > bytes.size())
        view.fail(fmt::format("ends at byte {} of a buffer of {} bytes", begin + length, bytes.size()));
    const std::uint64_t given_stride = optional_size(view, "byteStride");
    const std::uint64_t stride = given_stride == 0 ? row_size : given_stride;
    if (stride < row_size)
        view.fail(fmt::format("has rows of {} bytes, expected at least {}", stride, row_size));
    const std::uint64_t offset = optional_size(place, "byteOffset");
    const std::uint64_t needed = offset + (count == 0 ? 0 : (count - 1) * stride + row_size);
    if (needed > length)
        place.fail(fmt::format("needs {} bytes of a buffer view that has {}", needed, length));
    return {bytes.data() + begin + offset, stride};
}

void check_finite(const JsonPlace& accessor, const GltfArray& array) {
    const auto broken =
        std::ranges::find_if_not(array.values, [](float value) { return std::isfinite(value); });
    if (broken != array.values.end())
        accessor.fail(fmt::format("element {} is not finite",
                                  static_cast<std::size_t>(broken - array.values.begin()) / array.width));
}

}  // namespace

struct GltfArrays::Layout {
    Component component;
    bool is_normalized;
    std::size_t count;
    std::size_t width;

    std::size_t row_size() const { return width * size_of(component); }
};

GltfArrays::Layout GltfArrays::layout_of(const JsonPlace& accessor) {
    const JsonPlace type = accessor.member("type");
    const auto* const found = std::ranges::find(vector_types, type.string());
    if (found == vector_types.end()) type.fail_expecting("SCALAR, VEC2, VEC3 or VEC4");
    const auto normalized = accessor.optional_member("normalized");
    return {component_at(accessor.member("componentType")), normalized && normalized->boolean(),
            accessor.member("count").index_below(no_index),
            static_cast<std::size_t>(found - vector_types.begin()) + 1};
}

void GltfArrays::charge(const JsonPlace& place, std::uint64_t numbers) {
    if (numbers > numbers_left_) place.fail("takes more numbers than a file of this size can have");
    numbers_left_ -= numbers;
}

void GltfArrays::read_sparse(const JsonPlace& accessor, const Layout& layout, GltfArray& array) const {
    const auto sparse = accessor.optional_member("sparse");
    if (!sparse) return;
    const std::size_t count = sparse->member("count").index_below(layout.count + 1);
    const JsonPlace indices = sparse->member("indices");
    const JsonPlace kind = indices.member("componentType");
    const Component component = component_at(kind);
    if (!is_index(component)) kind.fail_expecting("an unsigned type");
    const Rows places = rows_at(file_, indices, count, size_of(component));
    const Rows values = rows_at(file_, sparse->member("values"), count, layout.row_size());
    for (std::size_t n = 0; n < count; ++n) {
        const Index place = index_at(places.row(n), component);
        if (place >= layout.count)
            indices.fail(fmt::format("element {} is {}, expected a number below {}", n, place, layout.count));
        for (std::size_t c = 0; c < layout.width; ++c)
            array.values[place * layout.width + c] = number_at(values.row(n) + c * size_of(layout.component),
                                                               layout.component, layout.is_normalized);
    }
}

GltfArray GltfArrays::numbers(const JsonPlace& place) {
    const JsonPlace accessor = file_.element("accessors", place.index_below(no_index));
    const Layout layout = layout_of(accessor);
    charge(accessor, std::uint64_t{layout.count} * layout.width);
    GltfArray array{layout.width, {}};
    if (accessor.optional_member("bufferView")) {
        const Rows rows = rows_at(file_, accessor, layout.count, layout.row_size());
        array.values.reserve(layout.count * layout.width);
        for (std::size_t n = 0; n < layout.count; ++n)
            for (std::size_t c = 0; c < layout.width; ++c)
                array.values.push_back(number_at(rows.row(n) + c * size_of(layout.component),
                                                 layout.component, layout.is_normalized));
    } else {
        array.values.assign(layout.count * layout.width, 0.0F);
    }
    read_sparse(accessor, layout, array);
    check_finite(accessor, array);
    return array;
}

std::vector<Index> GltfArrays::indices(const JsonPlace& place, std::size_t limit) {
    const JsonPlace accessor = file_.element("accessors", place.index_below(no_index));
    const Layout layout = layout_of(accessor);
    if (layout.width != 1 || !is_index(layout.component))
        accessor.fail("is not a list of unsigned numbers, expected one for the indices of triangles");
    if (accessor.optional_member("sparse")) accessor.fail("is sparse, which is not read for indices");
    charge(accessor, layout.count);
    const Rows rows = rows_at(file_, accessor, layout.count, layout.row_size());
    std::vector<Index> indices;
    indices.reserve(layout.count);
    for (std::size_t n = 0; n < layout.count; ++n) {
        indices.push_back(index_at(rows.row(n), layout.component));
        if (indices.back() >= limit)
            accessor.fail(
                fmt::format("element {} is {}, expected a vertex below {}", n, indices.back(), limit));
    }
    return indices;
}

}  // namespace interleaf
