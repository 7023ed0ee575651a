// The table of file formats: one row per format says what a file may hold, who reads and writes it, and what
// it carries. Filters of the file browser, help, messages and the table of docs/file-formats.md come from it.
//
// A file may hold what its row has a reader for. An OBJ file has two: its mesh may be a key as it is, or a
// mesh to fit a key to. PNG is no row: a picture is drawn from a family, but carries nothing of it.
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

/// What a format carries of a family.
struct Carried {
    bool fields = false;     ///< named values per vertex
    bool colors = false;     ///< one color per vertex
    bool hierarchy = false;  ///< the bisections of a key
    bool origin = false;     ///< where positions count from (family/origin.h)
    bool time = false;       ///< a timeline
};

/// Reads a family. \p changes gets a sentence for each key that was changed.
using FamilyReader = Family (*)(const std::filesystem::path& file, std::vector<std::string>* changes);

/// Reads files of one format as keys.
/// \param origin  that positions must be relative to; the reader chooses one where it is none
/// \return        a misfit where the files can be read, but are not keys together
using KeyReader = std::variant<FileKeys, Misfit> (*)(std::span<const std::filesystem::path> files,
                                                     std::optional<glm::dvec3> origin);

struct Format {
    std::string_view extension;             ///< ".obj", in small letters
    std::string_view title;                 ///< "Wavefront OBJ"
    std::optional<Carried> read{};          ///< what the readers take from a file; none without a reader
    std::optional<Carried> written{};       ///< what the program puts into a file; none if it writes none
    FamilyReader read_family = nullptr;     ///< null: a file holds no family
    KeyReader read_keys = nullptr;          ///< null: a file holds no key
    SurfaceParser parse_surface = nullptr;  ///< null: a file holds no mesh to fit a key to
    ExportWriter write = nullptr;           ///< null: `export` does not write the format

    bool holds_family() const { return read_family != nullptr; }
    bool holds_key() const { return read_keys != nullptr; }
    bool holds_mesh() const { return parse_surface != nullptr; }
    bool holds_key_or_mesh() const { return holds_key() || holds_mesh(); }
    bool holds_mesh_as_key() const { return holds_key() && holds_mesh(); }
    bool holds_key_alone() const { return holds_key() && !holds_mesh(); }
    bool holds_mesh_alone() const { return holds_mesh() && !holds_key(); }
    bool holds_family_or_key() const { return holds_family() || holds_key(); }
    bool opens_unfitted() const { return holds_family() || holds_key_alone(); }
    bool is_openable() const { return holds_family() || holds_key_or_mesh(); }
    bool is_exported() const { return write != nullptr; }
    bool is_exported_key() const { return is_exported() && written->hierarchy; }
};

/// All formats, in the order in which filters, help and messages list them.
std::span<const Format> formats();

/// The format that the extension of \p file names, in any case; null for none.
const Format* find_format(const std::filesystem::path& file);

/// The format with this extension, ".obj" in small letters; null for none.
const Format* format_with_extension(std::string_view extension);

/// A question about a format, such as &Format::holds_mesh.
using FormatTrait = bool (Format::*)() const;

/// Whether the extension of \p file names a format with this trait.
bool is_called(const std::filesystem::path& file, FormatTrait trait);

/// The extensions of the formats with this trait: ".ilh", ".obj".
std::vector<std::string> extensions_of(FormatTrait trait);

/// The same in words: ".ilh or .obj".
std::string extensions_in_words(FormatTrait trait);

}  // namespace interleaf
