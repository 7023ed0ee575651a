// What the reader and the writer of family files must agree on.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace interleaf::family_format {

inline constexpr std::string_view name = "interleaf-family";

/// Written where version 1 has a place for all of a family; read, too.
inline constexpr std::uint32_t oldest_version = 1;
/// Has an origin.
inline constexpr std::uint32_t version = 2;

inline constexpr std::uint64_t largest_file = 16 << 20;

/// Finding overlaps compares every two triangles.
inline constexpr std::size_t most_domain_triangles = 4096;

/// Paths are UTF-8 in the file, whatever the operating system has.
std::filesystem::path path_of(std::string_view utf8);
std::string utf8_of(const std::filesystem::path& path);

}  // namespace interleaf::family_format
