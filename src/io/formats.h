// The table of file formats. One row per format names the content that a file may hold, its readers, its
// writer, and the data that the format carries. The file browser's filters, the help, the messages and the
// table in docs/file-formats.md come from this table.
//
// A row has one reader per kind of content. An OBJ file has two kinds: its mesh may be a key as it is, or a
// mesh to fit a key to. PNG has no row, because a picture of a family carries none of its data.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "family/family.h"
#include "io/export/export.h"
#include "io/file/file_keys.h"
#include "io/mesh/surface_file.h"

namespace interleaf {

/// The data of a family that a format carries.
struct Carried {
    bool fields = false;     ///< named values per vertex
    bool colors = false;     ///< one color per vertex
    bool hierarchy = false;  ///< the bisections of a key
    bool origin = false;     ///< the point that positions are relative to (family/origin.h)
    bool time = false;       ///< a timeline
};

/// Reads a family.
/// \param changes  if given, receives one sentence per key that was changed
using FamilyReader = Family (*)(const std::filesystem::path& file, std::vector<std::string>* changes);

/// Reads files of one format as keys.
/// \param origin  the origin of all positions; if none, the reader chooses an origin
/// \return        the keys; or a misfit if the files can be read, but do not form keys together
using KeyReader = std::variant<FileKeys, Misfit> (*)(std::span<const std::filesystem::path> files,
                                                     std::optional<glm::dvec3> origin);

struct Format {
    std::string_view extension;        ///< ".obj", in lower case
    std::string_view title;            ///< "Wavefront OBJ"
    std::optional<Carried> read{};     ///< data that the readers take from a file; none without a reader
    std::optional<Carried> written{};  ///< data that the program writes; none if it does not write the format
    FamilyReader read_family = nullptr;     ///< null: a file holds no family
    KeyReader read_keys = nullptr;          ///< null: a file holds no key
    SurfaceParser parse_surface = nullptr;  ///< null: a file holds no mesh to fit a key to
    bool is_step = false;                   ///< whether a file is a step of a series, or lists the steps
    ExportWriter write = nullptr;           ///< null: `export` does not write the format

    bool holds_family() const { return read_family != nullptr; }
    bool holds_key() const { return read_keys != nullptr; }
    bool holds_mesh() const { return parse_surface != nullptr; }
    bool holds_series() const { return is_step; }
    bool holds_key_or_mesh() const { return holds_key() || holds_mesh(); }
    bool holds_mesh_as_key() const { return holds_key() && holds_mesh(); }
    bool holds_key_alone() const { return holds_key() && !holds_mesh(); }
    bool holds_mesh_alone() const { return holds_mesh() && !holds_key(); }
    bool holds_family_or_key() const { return holds_family() || holds_key(); }
    bool opens_unfitted() const { return holds_family() || holds_key_alone() || holds_series(); }
    bool is_openable() const { return holds_family() || holds_key_or_mesh() || holds_series(); }
    bool is_exported() const { return write != nullptr; }
    bool is_exported_key() const { return is_exported() && written->hierarchy; }
};

/// All formats, in the order in which filters, help and messages list them.
std::span<const Format> formats();

/// The format with the extension of \p file, in upper or lower case; null if there is none.
const Format* find_format(const std::filesystem::path& file);

/// The format with \p extension, such as ".obj", in lower case; null if there is none.
const Format* format_with_extension(std::string_view extension);

/// What positions and fields in a file of \p format are relative to, where the file itself has no place for it: the
/// origin and the offsets of fields, one sentence each.
/// \pre the format is exported
std::vector<std::string> lost_offsets(const Format& format, const Family& family);

/// A yes-or-no property of a format, such as &Format::holds_mesh.
using FormatTrait = bool (Format::*)() const;

/// Whether \p file has the extension of a format with \p trait.
bool is_called(const std::filesystem::path& file, FormatTrait trait);

/// The extensions of the formats with \p trait: ".ilh", ".obj".
std::vector<std::string> extensions_of(FormatTrait trait);

/// The same in words: ".ilh or .obj".
std::string extensions_in_words(FormatTrait trait);

}  // namespace interleaf
