// Surfaces of other programs. Every file is read as PLY, as STL and as OFF, and counts as rejected if all
// three readers reject it. The parts are the header and the body of a PLY; the first 80 bytes, the count and
// the triangles of a binary STL; the whole of any other file.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "fuzz/hierarchy_parts.h"
#include "fuzz/target.h"

#include "hierarchy/error.h"
#include "io/mesh/surface_file.h"

namespace interleaf::fuzz {

namespace {

constexpr std::size_t stl_count_place = 80;
constexpr std::size_t stl_triangle_size = 50;

std::string_view text_of(ByteSpan bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

std::string inspected(const SurfaceFile& surface) {
    const auto is_finite = [](const glm::dvec3& position) {
        return std::isfinite(position.x) && std::isfinite(position.y) && std::isfinite(position.z);
    };
    const auto exists = [&](const Triangle& triangle) {
        return std::ranges::all_of(triangle, [&](Index i) { return i < surface.positions.size(); });
    };
    const auto is_color = [](const glm::vec3& color) {
        return std::min({color.r, color.g, color.b}) >= 0 && std::max({color.r, color.g, color.b}) <= 1;
    };
    if (surface.triangles.empty()) return "unsound: no triangles";
    if (!std::ranges::all_of(surface.positions, is_finite)) return "unsound: a position is not finite";
    if (!std::ranges::all_of(surface.triangles, exists)) return "unsound: a vertex does not exist";
    if (!surface.colors.empty() && surface.colors.size() != surface.positions.size())
        return "unsound: number of colors";
    constexpr std::size_t longest = 600;  // 80 bytes are quoted, six characters each
    for (const std::string& remark : surface.remarks)
        if (remark.empty() || remark.size() > longest || remark.find('\n') != std::string::npos)
            return "a remark is no sentence";
    return std::ranges::all_of(surface.colors, is_color) ? "" : "unsound: a color is not from 0 to 1";
}

Inspection read(ByteSpan bytes) {
    std::vector<SurfaceFile> surfaces;
    std::optional<InputError> refused;
    for (const auto parse : {parse_ply, parse_stl, parse_off}) try {
            surfaces.push_back(parse(text_of(bytes), "surface"));
        } catch (const InputError& error) {
            refused = error;
        }
    if (surfaces.empty()) throw InputError(*refused);
    return [surfaces = std::move(surfaces)]() -> std::string {
        for (const SurfaceFile& surface : surfaces)
            if (std::string fault = inspected(surface); !fault.empty()) return fault;
        return {};
    };
}

std::vector<Bytes> parts_of(ByteSpan file) {
    constexpr std::string_view end_of_header = "end_header\n";
    const std::string_view text = text_of(file);
    ByteSpan rest = file;
    std::vector<Bytes> parts;
    if (const std::size_t end = text.find(end_of_header); end != std::string_view::npos) {
        parts.push_back(take(rest, end + end_of_header.size()));
    } else if (text.find('\0') != std::string_view::npos && text.size() > stl_count_place) {
        parts.push_back(take(rest, stl_count_place));
        parts.push_back(take(rest, sizeof(std::uint32_t)));
    }
    parts.push_back(take(rest, rest.size()));
    return parts;
}

void repair_stl(std::vector<Bytes>& parts) {
    const auto count = static_cast<std::uint32_t>(parts[2].size() / stl_triangle_size);
    parts[0].resize(stl_count_place, std::byte{' '});
    parts[1].resize(sizeof(count));
    parts[2].resize(count * stl_triangle_size);
    std::memcpy(parts[1].data(), &count, sizeof(count));
}

Bytes file_of(std::vector<Bytes> parts, bool keeps_counts) {
    if (parts.size() == 3 && !keeps_counts) repair_stl(parts);
    Bytes file;
    for (const Bytes& part : parts) append(file, part);
    return file;
}

}  // namespace

const Target target{"surface", read, parts_of, file_of, own_size};

}  // namespace interleaf::fuzz
