#include "sequence/series/series.h"

#include <algorithm>
#include <utility>

#include <fmt/core.h>

#include "hierarchy/checker.h"
#include "hierarchy/error.h"
#include "sequence/series/coarsest_mesh.h"
#include "sequence/series/key_comparison.h"
#include "sequence/series/ordered_series.h"
#include "sequence/series/plane_sampling.h"
#include "sequence/series/step_reader.h"
#include "sequence/series/surface_checks.h"

namespace interleaf {

namespace {

class Recovery {
  public:
    Recovery(const Series& series, const SeriesOptions& options, const TakeKey& take_key,
             const SeriesProgress& progress)
        : count_(series.step_count),
          options_(options),
          take_key_(take_key),
          progress_(progress),
          reader_(series, options) {
        report_.steps.resize(count_);
    }

    SeriesReport run() {
        if (options_.tolerance)
            sample();
        else if (recover_at_once())
            report_.method = SeriesMethod::by_order;
        else if (const std::optional<OrderRule> rule = find_rule())
            recover_by_order(*rule);
        else
            recover_by_place();
        report_.notes = reader_.notes();
        return std::move(report_);
    }

  private:
    void tell(std::string_view stage, double part) {
        part_ = std::max(part_, part);
        if (progress_) progress_(stage, part_);
    }

    StepMesh read_conforming(std::size_t step) {
        StepMesh mesh = reader_.read(step);
        if (mesh.hanging)
            throw NeedsTolerance(fmt::format("step {}: hanging vertex at {}: the mesh does not conform", step,
                                             text_of(*mesh.hanging)));
        return mesh;
    }

    /// Recovers by order in one pass, by the rule that suits the first step best. That halves the time.
    /// \return whether the rule suits all steps; if not, nothing has happened
    bool recover_at_once() {
        if (options_.roots != nullptr) return false;
        OrderSearch search(options_.newest);
        StepMesh mesh = read_conforming(0);
        if (!search.add(mesh)) return false;
        const OrderRule rule = *search.best();
        OrderedRoots roots;
        for (std::size_t step = 0; step < count_; ++step) {
            tell("recovering keys", part_of_steps(step));
            if (step > 0) mesh = read_conforming(step);
            std::optional<Hierarchy> key = key_by_order(mesh, rule, reader_.fields(), roots);
            if (!key || key->roots.triangle_count() > mesh.triangles.size() / 2) {
                report_.steps.assign(count_, {});
                moved_.clear();
                return false;
            }
            accept_exact(step, mesh, std::move(*key));
        }
        finish();
        return true;
    }

    std::optional<OrderRule> find_rule() {
        if (options_.roots != nullptr) return std::nullopt;
        OrderSearch search(options_.newest);
        for (std::size_t step = 0; step < count_; ++step) {
            tell("reading the order", 0.4 * part_of_steps(step));
            if (!search.add(read_conforming(step))) return std::nullopt;
        }
        return search.best();
    }

    void recover_by_order(const OrderRule& rule) {
        report_.method = SeriesMethod::by_order;
        OrderedRoots roots;
        for (std::size_t step = 0; step < count_; ++step) {
            tell("recovering keys", 0.4 + 0.6 * part_of_steps(step));
            const StepMesh mesh = read_conforming(step);
            std::optional<Hierarchy> key = key_by_order(mesh, rule, reader_.fields(), roots);
            if (!key) throw step_error(step, "the step has changed since it was read first");
            accept_exact(step, mesh, std::move(*key));
        }
        finish();
    }

    void recover_by_place() {
        report_.method = SeriesMethod::by_place;
        std::optional<CoarsestMesh> coarsest;
        if (options_.roots != nullptr) coarsest.emplace(given_roots_of(*options_.roots));
        Domain first;
        for (std::size_t step = 0; step < count_; ++step) {
            tell("looking for roots", 0.4 * part_of_steps(step));
            const StepMesh mesh = read_conforming(step);
            if (step == 0) first = domain_of(mesh.points, mesh.triangles);
            if (!coarsest) {
                coarsest.emplace(mesh);
                continue;
            }
            if (const Index misfit = coarsest->add(mesh); misfit != no_index)
                refuse(step, mesh, misfit, first, coarsest->common_vertices(mesh));
        }
        const SeriesRoots roots =
            options_.roots != nullptr ? given_roots_of(*options_.roots) : roots_of(*coarsest);
        for (std::size_t step = 0; step < count_; ++step) {
            tell("recovering keys", 0.4 + 0.6 * part_of_steps(step));
            const StepMesh mesh = read_conforming(step);
            std::optional<Hierarchy> key = key_by_place(mesh, roots, reader_.fields());
            if (!key) refuse(step, mesh, 0, first, mesh.points.size());
            accept_exact(step, mesh, std::move(*key));
        }
        finish();
    }

    static UnrecoveredSurfaces unrecovered(std::size_t step, const std::string& text) {
        return UnrecoveredSurfaces(step_error(step, text).what());
    }

    static SeriesRoots roots_of(const CoarsestMesh& coarsest) {
        try {
            return coarsest.roots();
        } catch (const InputError& error) {
            throw InputError(
                fmt::format("the coarsest triangles of all steps are no surface: {}", error.what()));
        }
    }

    /// Says why \p step is not of one hierarchy with the earlier steps, and what would help.
    [[noreturn]] void refuse(std::size_t step, const StepMesh& mesh, Index triangle, const Domain& first,
                             std::size_t common_vertices) const {
        try {
            require_fans(mesh);
        } catch (const InputError& error) {
            throw step_error(step, error.what());
        }
        const bool is_flat = flat_axis(mesh.points).has_value();
        const bool same_domain = first.is_about(domain_of(mesh.points, mesh.triangles));
        if (is_flat && !same_domain) throw step_error(step, "the mesh covers another domain than step 0");
        if (!is_flat && common_vertices < mesh.points.size() / 4)
            throw unrecovered(step,
                              "vertices move and no order of corners marks the newest vertex: write "
                              "triangles in the program's own order, or name a displacement field");
        const auto& [a, b, c] = mesh.triangles[triangle];
        const std::string text = fmt::format(
            "step {}, triangle {} at {} neither contains nor is contained in triangles of {}: not one "
            "bisection hierarchy",
            step, triangle, text_of((mesh.points[a] + mesh.points[b] + mesh.points[c]) / 3.0),
            options_.roots != nullptr ? "the given roots" : "earlier steps");
        if (!is_flat) throw UnrecoveredSurfaces(text);
        throw NeedsTolerance(text);
    }

    void sample() {
        report_.method = SeriesMethod::by_sampling;
        const SeriesRoots roots = roots_to_sample();
        const std::vector<double> ranges = reader_.ranges();
        PlaneSampling sampling;
        sampling.axis = axis_;
        sampling.tolerance = *options_.tolerance;
        sampling.ranges = ranges;
        for (std::size_t step = 0; step < count_; ++step) {
            const double part = 0.3 + 0.7 * part_of_steps(step);
            sampling.report = [this, part] { tell("sampling", part); };
            const StepMesh mesh = reader_.read(step);
            try {
                SampledKey sampled = sample_in_plane(mesh, roots, reader_.fields(), sampling);
                StepReport& figures = report_.steps[step];
                figures.largest_difference = sampled.largest_difference;
                figures.integral_error = integral_error(mesh, sampled.key, ranges);
                accept(step, mesh, std::move(sampled.key));
            } catch (const InputError& error) {
                throw step_error(step, error.what());
            }
        }
        finish();
    }

    /// The given roots, or the coarsest triangles of the first steps that are of one hierarchy, or the triangles
    /// of the coarsest step, whichever are fewer.
    SeriesRoots roots_to_sample() {
        std::optional<CoarsestMesh> coarsest;
        std::optional<SeriesRoots> fewest;
        bool is_one_hierarchy = true;
        Domain first;
        for (std::size_t step = 0; step < count_; ++step) {
            tell("looking for roots", 0.3 * part_of_steps(step));
            const StepMesh mesh = reader_.read(step);
            const Domain domain = domain_of(mesh.points, mesh.triangles);
            if (step == 0) {
                const std::optional<unsigned> axis = flat_axis(mesh.points);
                if (!axis)
                    throw unrecovered(0,
                                      "the points are not in a plane x, y or z = constant, as sampling to a "
                                      "tolerance needs");
                axis_ = *axis;
                first = domain;
            } else if (!domain.is_about(first)) {
                throw step_error(step, "the mesh covers another domain than step 0");
            }
            if (options_.roots != nullptr) continue;
            if (mesh.hanging) {
                is_one_hierarchy = false;
                continue;
            }
            if (!fewest || mesh.triangles.size() < fewest->complex.triangle_count())
                fewest = roots_of_step(mesh);
            if (!coarsest && is_one_hierarchy)
                coarsest.emplace(mesh);
            else if (is_one_hierarchy)
                is_one_hierarchy = coarsest->add(mesh) == no_index;
        }
        if (options_.roots != nullptr) return given_roots(first);
        if (!fewest)
            throw InputError(
                "each step has hanging vertices, so no step can be the roots: name a mesh of roots");
        if (coarsest && coarsest->triangle_count() < fewest->complex.triangle_count())
            return roots_of(*coarsest);
        return *fewest;
    }

    SeriesRoots given_roots(const Domain& first) const {
        SeriesRoots roots = given_roots_of(*options_.roots);
        if (!domain_of(roots.points, roots.complex.triangles()).is_about(first))
            throw InputError("the given roots cover another domain than step 0");
        return roots;
    }

    void accept_exact(std::size_t step, const StepMesh& mesh, Hierarchy key) {
        if (key.leaf_count() != mesh.triangles.size())
            throw step_error(step, "the hierarchy has other leaves than the step has triangles");
        accept(step, mesh, std::move(key));
    }

    /// Checks \p key, and hands over the key before, which waits for the comparison with its successor.
    void accept(std::size_t step, const StepMesh& mesh, Hierarchy key) {
        if (const std::vector<std::string> violations = check(key, 1); !violations.empty())
            throw step_error(step, fmt::format("not a sound hierarchy: {}", violations[0]));
        report_.steps[step].triangles = mesh.triangles.size();
        report_.steps[step].leaves = key.leaf_count();
        report_.root_count = key.roots.triangle_count();
        if (step > 0) {
            moved_.push_back(moved_widths_times_range(waiting_, key));
            take_key_(step - 1, std::move(waiting_));
        }
        waiting_ = std::move(key);
    }

    void finish() {
        for (std::size_t step = 0; step < moved_.size(); ++step)
            report_.steps[step].moved_widths = widths_of(moved_[step], reader_.ranges());
        take_key_(count_ - 1, std::move(waiting_));
        tell("recovering keys", 1);
    }

    double part_of_steps(std::size_t step) const {
        return static_cast<double>(step) / static_cast<double>(count_);
    }

    std::size_t count_;
    const SeriesOptions& options_;
    const TakeKey& take_key_;
    const SeriesProgress& progress_;
    StepReader reader_;
    SeriesReport report_;
    std::vector<std::vector<double>> moved_;  ///< per step and scalar, times the range
    Hierarchy waiting_;
    unsigned axis_ = 2;  ///< across the plane of all steps
    double part_ = 0;
};

}  // namespace

NeedsTolerance::NeedsTolerance(const std::string& why)
    : InputError(fmt::format("{}; try --tolerance {}", why, usual)), reason(why) {}

std::string_view name_of(SeriesMethod method) {
    switch (method) {
        case SeriesMethod::by_order:
            return "order of corners";
        case SeriesMethod::by_place:
            return "place of vertices";
        case SeriesMethod::by_sampling:
            return "sampling";
        case SeriesMethod::by_fitting:
            return "fitting";
    }
    return "";
}

SeriesReport recover(const Series& series, const SeriesOptions& options, const TakeKey& take_key,
                     const SeriesProgress& progress) {
    if (series.step_count == 0) throw InputError("the series has no steps");
    if (options.tolerance && !(*options.tolerance >= 0 && *options.tolerance <= 1))
        throw UsageError(fmt::format("tolerance {} is out of range, expected 0 to 1", *options.tolerance));
    if (options.newest && *options.newest > 2)
        throw UsageError(fmt::format("newest corner {} is out of range, expected 0 to 2", *options.newest));
    return Recovery(series, options, take_key, progress).run();
}

}  // namespace interleaf
