// The description of an export, which every writer of a format gets (formats.h).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "family/family.h"
#include "hierarchy/progress.h"
#include "io/file/output_target.h"
#include "io/hierarchy/hierarchy_file.h"

namespace interleaf {

/// The meshes of a series of files.
enum class SeriesUnion : std::uint8_t {
    all,       ///< the union of all keys, in all files
    interval,  ///< per interval of the timeline, the union of its two keys
};

/// The files of a series, such as .pvd: one per key, unless one of the first three options is set.
struct SeriesExportOptions {
    std::optional<double> frames_per_second{};
    std::optional<double> time_step{};  ///< between two files, in units of the time
    std::vector<double> times{};        ///< of the files
    std::optional<SeriesUnion> mesh{};  ///< none for all, unless that is much larger than interval

    bool has_times() const { return frames_per_second || time_step || !times.empty(); }
};

/// A writer of one blend uses blend_of(). A writer of the whole family uses the keys and their timeline.
struct Export {
    const Family& family;
    std::optional<Weights>
        weights;  ///< of the chosen blend; none if nothing is chosen and the family has no default blend
    HierarchyFileOptions form{};   ///< of key files
    SeriesExportOptions series{};  ///< of formats with one file per time
    bool segments = false;         ///< a mesh per interval of the timeline, in formats of the whole family

    /// If given, receives sentences about content that the format holds only approximately, or otherwise than
    /// asked for.
    std::vector<std::string>* remarks = nullptr;

    Progress progress{};  ///< of formats of the whole family
};

/// Tells the progress of an export.
/// \throw Cancelled if its receiver says so
void report_progress(const Export& exported, std::string_view stage, double part);

/// Writes an export in one format.
/// \throw UsageError    if the export lacks data that the format needs
/// \throw InputError    if the family does not fit into the format
/// \throw MachineError  if the target cannot be written
/// \throw Cancelled     if the receiver of the progress says so; then no target is written
using ExportWriter = void (*)(const Export& exported, const OutputTarget& target);

/// One blend of a family: the union of the active keys, and the blended positions and fields.
struct Blend {
    UnionMesh mesh;               ///< with the fields that all active keys have
    std::vector<float> weights;   ///< one per key of the union
    Buffer<glm::vec3> positions;  ///< one per vertex of the union, relative to the family's origin
    std::vector<Field> fields;    ///< each with one value per vertex of the union
};

/// The error message where a blend is needed, none is chosen, and the family has no default blend.
inline constexpr const char* no_default_blend = "the family has no timeline; say --at or --weights";

/// The blend of \p exported. Remarks if it has too many keys to turn.
/// \throw UsageError if the export has no weights, or a blended value is outside the range of floats
Blend blend_of(const Export& exported);

/// Blends of a family, one after the other. Their union is made only where the active keys change.
class BlendSeries {
  public:
    /// \param family  must outlive this object
    /// \param finest  all blends take its leaves, too; null for none; must outlive this object
    BlendSeries(const Family& family, const Hierarchy* finest) : family_(family), finest_(finest) {}

    /// The blend with \p weights, until the next call.
    /// \throw UsageError as blend_of()
    Blend& at(const Weights& weights);

  private:
    const Family& family_;
    const Hierarchy* finest_;
    std::vector<std::size_t> active_;  ///< the united keys
    Blend blend_;
};

/// Remarks if \p exported is of a family whose parts turn, and \p key_count keys are too many for that.
void remark_on_straight(const Export& exported, std::size_t key_count);

/// The union of \p keys of \p family as one hierarchy, with the fields that all of them have. Its positions and
/// values are those of one key. Stops when it has more than \p max_leaves leaves.
/// \pre \p keys is not empty
Hierarchy finest_of(const Family& family, std::span<const std::size_t> keys, std::size_t max_leaves);

}  // namespace interleaf
