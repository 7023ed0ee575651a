// Constants and names that the reader and the writer of family files share.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace interleaf::family_format {

inline constexpr std::string_view name = "interleaf-family";

/// Written for a family that needs no member of version 2.
inline constexpr std::uint32_t oldest_version = 1;
/// Written for a family with an origin, a path, landmarks, units or offsets, or whose interpolation is not linear,
/// or that does not blend straight.
inline constexpr std::uint32_t version = 2;

inline constexpr std::uint64_t max_file_size = 16 << 20;

/// The checks of ParameterDomain take about n^1.5 steps for n triangles of similar size, but n^2 at worst.
inline constexpr std::size_t max_domain_triangles = 4096;

inline constexpr std::size_t max_scales = 4096;

/// Converts paths: family.json holds them as UTF-8, whatever the operating system uses.
std::filesystem::path path_of(std::string_view utf8);
std::string utf8_of(const std::filesystem::path& path);

}  // namespace interleaf::family_format
