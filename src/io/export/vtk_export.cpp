#include "io/export/vtk_export.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include <fmt/core.h>

#include "family/family_time.h"
#include "hierarchy/error.h"
#include "hierarchy/union_fields.h"
#include "io/export/frames.h"
#include "io/export/vtk_document.h"

namespace interleaf {
namespace {

/// How many times as large as the largest union of an interval the union of all keys may be.
constexpr std::size_t max_growth = 4;

/// What is the same for all frames.
struct FrameMesh {
    std::optional<Hierarchy> finest;   ///< none if each frame has its own union
    std::vector<KeySet> leaf_origins;  ///< per leaf of the finest: the family's keys in which it is a node
    std::vector<FieldName> fields;     ///< that all keys have
};

/// Per leaf of \p mesh, the keys of the family in which it is a node: bit i for key i.
std::vector<KeySet> family_origins(const UnionMesh& mesh, std::span<const std::size_t> keys) {
    std::vector<KeySet> leaf_origins(mesh.leaf_count(), 0);
    for (std::size_t leaf = 0; leaf < leaf_origins.size(); ++leaf)
        for (std::size_t n = 0; n < keys.size(); ++n)
            if ((mesh.origins[leaf] & key_bit(n)) != 0) leaf_origins[leaf] |= key_bit(keys[n]);
    return leaf_origins;
}

/// The same over the leaves of \p finest, which contains all \p keys.
std::vector<KeySet> origins_over(const Hierarchy& finest, const Family& family,
                                 std::span<const std::size_t> keys) {
    std::vector<KeySet> leaf_origins(finest.leaf_count(), 0);
    UnionMesh mesh;
    for (const std::size_t key : keys) {
        unite(std::array<const Hierarchy*, 2>{&finest, &*family.keys[key].hierarchy}, mesh);
        for (std::size_t leaf = 0; leaf < leaf_origins.size(); ++leaf)
            if ((mesh.origins[leaf] & key_bit(1)) != 0) leaf_origins[leaf] |= key_bit(key);
    }
    return leaf_origins;
}

std::vector<FieldName> fields_of_all(const Family& family, std::span<const std::size_t> keys) {
    std::vector<const Hierarchy*> hierarchies;
    for (const std::size_t key : keys) hierarchies.push_back(&*family.keys[key].hierarchy);
    return common_fields(hierarchies);
}

std::size_t largest_union(const Family& family, std::span<const Frame> frames) {
    std::size_t most = 0;
    UnionMesh mesh;
    for (const Frame& frame : frames) {
        unite(family, frame.weights, mesh);
        most = std::max(most, mesh.leaf_count());
    }
    return most;
}

/// Removes the files that a series has made if the series does not become complete. Files that were there before
/// stay, with their new content.
class UnfinishedSeries {
  public:
    UnfinishedSeries() = default;
    UnfinishedSeries(const UnfinishedSeries&) = delete;
    UnfinishedSeries& operator=(const UnfinishedSeries&) = delete;
    ~UnfinishedSeries() {
        std::error_code ignored;
        for (const std::filesystem::path& file : new_files_) std::filesystem::remove(file, ignored);
    }

    void write(const std::filesystem::path& file, std::string_view bytes) {
        std::error_code ignored;
        const bool is_new = !std::filesystem::exists(file, ignored);
        write_output({file}, bytes);
        if (is_new) new_files_.push_back(file);
    }

    void keep() { new_files_.clear(); }

  private:
    std::vector<std::filesystem::path> new_files_;
};

/// The finest mesh, unless frames are to have their own unions, or it is much larger than these.
std::optional<Hierarchy> finest_mesh(const Export& exported, std::span<const Frame> intervals,
                                     std::span<const std::size_t> keys) {
    const std::optional<SeriesUnion> wanted = exported.series.mesh;
    if (wanted == SeriesUnion::interval) return std::nullopt;
    if (wanted == SeriesUnion::all) return finest_of(exported.family, keys, no_index);
    const std::size_t limit = max_growth * largest_union(exported.family, intervals);
    Hierarchy finest = finest_of(exported.family, keys, limit);
    if (finest.leaf_count() <= limit) return finest;
    if (exported.remarks != nullptr)
        exported.remarks->push_back(
            fmt::format("The union of all keys has over {} times as many triangles as those of the "
                        "intervals, so each interval "
                        "has a mesh of its own; --union all gives one mesh.",
                        max_growth));
    return std::nullopt;
}

std::string blend_bytes(const Export& exported, const Blend& blend, std::span<const KeySet> leaf_origins,
                        std::optional<double> time, VtkDataSet data_set) {
    return vtk_bytes({.triangles = blend.mesh.triangles,
                      .positions = blend.positions,
                      .origin = exported.family.origin,
                      .fields = blend.fields,
                      .scales = exported.family.field_scales,
                      .tags = blend.mesh.tags,
                      .leaf_origins = leaf_origins,
                      .time = time},
                     data_set);
}

void export_blend(const Export& exported, const OutputTarget& target, VtkDataSet data_set) {
    const Blend blend = blend_of(exported);
    const std::vector<KeySet> leaf_origins = family_origins(blend.mesh, active_keys(*exported.weights));
    write_output(target, blend_bytes(exported, blend, leaf_origins, std::nullopt, data_set));
}

std::string frame_bytes(const Export& exported, const FrameMesh& shared, BlendSeries& blends,
                        const Frame& frame) {
    Blend& blend = blends.at(frame.weights);
    std::erase_if(blend.fields, [&](const Field& field) {
        return std::ranges::find(shared.fields, field.label()) == shared.fields.end();
    });
    const std::vector<KeySet> own =
        !shared.finest ? family_origins(blend.mesh, active_keys(frame.weights)) : std::vector<KeySet>();
    return blend_bytes(exported, blend, !shared.finest ? own : shared.leaf_origins, frame.time,
                       VtkDataSet::polygons);
}

/// Says how ParaView shows the time between two keys, unless that is the blend.
void remark_interpolation(const Export& exported) {
    const std::optional<Timeline>& timeline = exported.family.timeline;
    if (exported.remarks == nullptr || exported.series.has_times() || !timeline) return;
    if (exported.family.blend == BlendKind::turning)
        exported.remarks->emplace_back(
            "Parts of this family turn, and ParaView's time between two keys is straight; --fps or --every "
            "writes more times.");
    const Basis basis = timeline->interpolation().basis;
    if (basis == Basis::linear) return;
    exported.remarks->push_back(
        fmt::format("The timeline's interpolation is {}, and ParaView's between two keys is linear; --fps or "
                    "--every writes "
                    "more times.",
                    name_of(basis)));
}

/// The frames of an export. Without anything that drives the family over time, that is the chosen blend.
/// \param are_of_intervals  two frames per interval of the timeline instead of one per key
/// \throw UsageError        if there is no number of frames where it is needed, or no blend is chosen
std::vector<Frame> frames_of(const Export& exported, bool are_of_intervals) {
    const Family& family = exported.family;
    const std::optional<double> per_second = exported.series.frames_per_second;
    const std::optional<TimeSource> source = source_of_time(family);
    if (!source && !exported.weights) throw UsageError(no_default_blend);
    if (!source) return {{0, *exported.weights}};
    if (per_second) return frames_per_second(family, *source, *per_second);
    if (exported.series.time_step) return frames_every(family, *source, *exported.series.time_step);
    if (!exported.series.times.empty()) return frames_at(family, *source, exported.series.times);
    if (*source == TimeSource::path)
        throw UsageError("the time of the family is that of a path; say --fps, --every or --times");
    return are_of_intervals ? frames_of_intervals(family) : frames_of_keys(family);
}

}  // namespace

void export_vtp(const Export& exported, const OutputTarget& target) {
    export_blend(exported, target, VtkDataSet::polygons);
}

void export_vtu(const Export& exported, const OutputTarget& target) {
    export_blend(exported, target, VtkDataSet::grid);
}

void export_pvd(const Export& exported, const OutputTarget& target) {
    if (target.file.empty()) throw UsageError(".pvd names other files, expected a file for -o");
    report_progress(exported, "uniting keys", 0);
    std::vector<Frame> frames = frames_of(exported, true);
    const std::vector<std::size_t> keys = keys_of(frames);
    FrameMesh shared{finest_mesh(exported, frames, keys), {}, fields_of_all(exported.family, keys)};
    if (shared.finest) {
        shared.leaf_origins = origins_over(*shared.finest, exported.family, keys);
        frames = frames_of(exported, false);
    }
    remark_interpolation(exported);
    std::size_t most_keys = 0;
    for (const Frame& frame : frames) most_keys = std::max(most_keys, frame.weights.size());
    remark_on_straight(exported, most_keys);

    BlendSeries blends(exported.family, shared.finest ? &*shared.finest : nullptr);
    const std::string stem = target.file.stem().string();
    std::string list;
    UnfinishedSeries written;
    for (std::size_t n = 0; n < frames.size(); ++n) {
        report_progress(exported, fmt::format("file {} of {}", n + 1, frames.size()),
                        0.1 + 0.9 * static_cast<double>(n) / static_cast<double>(frames.size()));
        const std::string name = fmt::format("{}.{:04}.vtp", stem, n);
        written.write(target.file.parent_path() / name, frame_bytes(exported, shared, blends, frames[n]));
        list += fmt::format("<DataSet timestep=\"{}\" part=\"0\" file=\"{}\"/>\n", frames[n].time,
                            xml_escaped(name));
    }
    write_output(target,
                 fmt::format("<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\">\n"
                             "<Collection>\n{}</Collection>\n</VTKFile>\n",
                             list));
    written.keep();
}

}  // namespace interleaf
