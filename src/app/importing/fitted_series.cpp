#include "app/importing/fitted_series.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/core.h>
#include <glm/mat3x3.hpp>

#include "app/importing/point_motion.h"
#include "fit/clean_up/clean_up.h"
#include "fit/correspondence/match.h"
#include "fit/fit.h"
#include "fit/mesh/space_triangle.h"
#include "fit/mesh/surface_distance.h"
#include "hierarchy/error.h"
#include "sequence/series/key_comparison.h"
#include "sequence/series/step_mesh.h"

namespace interleaf {
namespace {

/// The parts of the work on one step: the clean-up, the continued map, the map of its own.
constexpr double clean_up_ends = 0.1;
constexpr double fit_begins = 0.5;

/// The mesh of a step with its scalars.
SurfaceMesh surface_of_step(FieldMesh step, const SeriesFields& fields) {
    constexpr double most = std::numeric_limits<float>::max();
    SurfaceMesh surface{std::move(step.points), std::move(step.triangles), {}};
    surface.scalars.reserve(fields.scalars.size());
    for (const SeriesScalar& scalar : fields.scalars) {
        const auto field = std::ranges::find(step.point_fields, scalar.field, &MeshField::name);
        if (field == step.point_fields.end())
            throw InputError(fmt::format("field {} is missing", scalar.field));
        if (scalar.component >= field->components ||
            field->values.size() != field->components * surface.positions.size())
            throw InputError(
                fmt::format("field {} has {} components and {} values for {} points, expected at "
                            "least {} components",
                            field->name, field->components, field->values.size(), surface.positions.size(),
                            scalar.component + 1));
        MeshField& own = surface.scalars.emplace_back(MeshField{scalar.name, 1, {}});
        own.values.reserve(surface.positions.size());
        for (std::size_t point = 0; point < surface.positions.size(); ++point) {
            own.values.push_back(field->values[field->components * point + scalar.component]);
            if (!(std::abs(own.values.back()) <= most))
                throw InputError(fmt::format("field {} is not finite at point {}", field->name, point));
        }
    }
    return surface;
}

/// The largest difference of a scalar of \p mesh between its vertices and the nearest places of \p key, as a part of
/// its range.
double largest_difference(const SurfaceMesh& mesh, const Hierarchy& key, std::span<const double> ranges) {
    double largest = 0;
    if (ranges.empty()) return largest;
    const SurfaceMesh leaves = surface_of(key);
    const SurfaceDistance distance(leaves.triangles, leaves.positions);
    Index nearest = no_index;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        distance(mesh.positions[v], nearest);
        const Triangle& corners = leaves.triangles[nearest];
        const glm::dvec3 place = nearest_place(
            mesh.positions[v], TriangleCorners{leaves.positions[corners[0]], leaves.positions[corners[1]],
                                               leaves.positions[corners[2]]});
        for (std::size_t s = 0; s < ranges.size(); ++s) {
            if (!(ranges[s] > 0)) continue;
            const auto& values = key.fields[s].values;
            const double on_key = place.x * double{values[corners[0]]} +
                                  place.y * double{values[corners[1]]} + place.z * double{values[corners[2]]};
            largest = std::max(largest, std::abs(on_key - mesh.scalars[s].values[v]) / ranges[s]);
        }
    }
    return largest;
}

class StepFitting {
  public:
    StepFitting(const Series& series, const SeriesOptions& options, const TakeKey& take_key,
                const SeriesProgress& progress)
        : series_(series), options_(options), take_key_(take_key), progress_(progress) {
        report_.method = SeriesMethod::by_fitting;
        report_.steps.resize(series.step_count);
        fit_.tolerance = options.tolerance;
    }

    SeriesReport run() {
        for_steps([this] { read_step(); });
        for (std::size_t s = 0; s < lows_.size(); ++s) ranges_.push_back(highs_[s] - lows_[s]);
        for_steps([this] { fit_step(); });
        take_key_(series_.step_count - 1, std::move(before_.hierarchy));
        return std::move(report_);
    }

  private:
    template <typename Action>
    void for_steps(Action action) {
        for (step_ = 0; step_ < series_.step_count; ++step_) {
            try {
                action();
            } catch (const InputError& error) {
                throw InputError(fmt::format("step {}: {}", step_, error.what()));
            }
        }
    }

    /// Progress from \p begin to \p end of the work on the present step.
    Progress part_of_step(double begin, double end) const {
        return [this, begin, end](std::string_view stage, double part) {
            const double done = static_cast<double>(step_) + begin + (end - begin) * part;
            if (progress_) progress_(stage, done / static_cast<double>(series_.step_count));
            return true;
        };
    }

    /// Learns the fields and their ranges.
    void read_step() {
        FieldMesh mesh = series_.read(step_);
        if (step_ == 0) fields_ = fields_of(mesh, options_.fields, options_.displacement);
        extend_ranges(surface_of_step(std::move(mesh), fields_));
        if (progress_) progress_("reading steps", 0);
    }

    void fit_step() {
        SurfaceMesh surface = surface_of_step(series_.read(step_), fields_);
        StepReport& figures = report_.steps[step_];
        figures.triangles = surface.triangles.size();
        FittedKey fitted = fitted_to(clean_up(std::move(surface), part_of_step(0, clean_up_ends)));
        note(fitted.report);
        figures.leaves = fitted.hierarchy.leaf_count();
        figures.distance = fitted.report.hausdorff_as_brought;
        report_.root_count = fitted.hierarchy.roots.triangle_count();
        StepMesh step;
        step.points = fitted.mesh.positions;
        step.triangles = fitted.mesh.triangles;
        for (const MeshField& scalar : fitted.mesh.scalars) step.values.push_back(scalar.values);
        figures.integral_error = integral_error(step, fitted.hierarchy, ranges_);
        figures.largest_difference = largest_difference(fitted.mesh, fitted.hierarchy, ranges_);
        if (step_ > 0) {
            StepReport& before = report_.steps[step_ - 1];
            before.moved_widths = moved_widths(before_.hierarchy, fitted.hierarchy, ranges_);
            const PointMotion motion = motion_of_points(before_.hierarchy, fitted.hierarchy);
            before.point_motion = motion.points;
            before.surface_motion = motion.surface;
            take_key_(step_ - 1, std::move(before_.hierarchy));
        }
        before_ = std::move(fitted);
    }

    /// Continues the map of the step before, or else matches a map of the step's own to it.
    FittedKey fitted_to(CleanMesh clean) {
        FitOptions options = fit_;
        std::unique_ptr<const MatchedBody> model;
        if (step_ > 0) {
            if (auto continued =
                    fit_continued(clean, before_, wanted_, options, part_of_step(clean_up_ends, fit_begins)))
                return *std::move(continued);
            model = model_of(before_.mapped_mesh(), before_.points, options.rotation, {}, options.matching,
                             part_of_step(fit_begins, fit_begins));
            options.model = model.get();
        }
        FittedKey fitted = fit(std::move(clean), options, part_of_step(fit_begins, 1));
        wanted_ = fitted.report.at_20000_leaves;
        return fitted;
    }

    void extend_ranges(const SurfaceMesh& mesh) {
        lows_.resize(mesh.scalars.size(), std::numeric_limits<double>::max());
        highs_.resize(mesh.scalars.size(), std::numeric_limits<double>::lowest());
        for (std::size_t s = 0; s < mesh.scalars.size(); ++s) {
            const auto [low, high] = std::ranges::minmax(mesh.scalars[s].values);
            lows_[s] = std::min(lows_[s], low);
            highs_[s] = std::max(highs_[s], high);
        }
    }

    void note(const FitReport& report) {
        constexpr std::size_t max_notes = 4;
        const auto add = [&](const std::string& sentence) {
            if (report_.notes.size() < max_notes)
                report_.notes.push_back(fmt::format("step {}: {}", step_, sentence));
        };
        for (const std::string& sentence : report.clean_up.sentences()) add(sentence);
        if (report.match && !report.match->fault.empty() && report.match->before.distortion >= bad_match)
            add(fmt::format("not matched to the step before: {}", report.match->fault));
    }

    /// From this distortion on, a map that could not be matched is worth a note (MatchFigures).
    static constexpr double bad_match = 1.5;

    const Series& series_;
    const SeriesOptions& options_;
    const TakeKey& take_key_;
    const SeriesProgress& progress_;
    FitOptions fit_;
    SeriesFields fields_;
    SeriesReport report_;
    std::vector<double> lows_;  ///< per scalar, over all steps
    std::vector<double> highs_;
    std::vector<double> ranges_;
    FittedKey before_;   ///< of the step before
    FitQuality wanted_;  ///< of the last key with a map of its own
    std::size_t step_ = 0;
};

}  // namespace

bool can_be_fitted(const SeriesOptions& options) {
    return options.roots == nullptr && options.displacement.empty();
}

SeriesReport fit_steps(const Series& series, const SeriesOptions& options, const std::string& reason,
                       const TakeKey& take_key, const SeriesProgress& progress) {
    try {
        SeriesReport report = StepFitting(series, options, take_key, progress).run();
        report.notes.insert(
            report.notes.begin(),
            fmt::format("a key was fitted to each step, because no bisection connects them: {}", reason));
        return report;
    } catch (const InputError& error) {
        throw InputError(
            fmt::format("{}; a key was to be fitted to each step, because no bisection connects "
                        "them: {}",
                        error.what(), reason));
    }
}

}  // namespace interleaf
