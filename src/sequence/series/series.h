// Recovers key hierarchies from a series of flat meshes, one per time step, that a program for numerics has
// refined and coarsened by bisection. docs/series.md describes the methods, and what each of them needs.
//
// The recovery reads the steps one after the other, up to four times, and holds a few of them at a time.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hierarchy/error.h"
#include "hierarchy/field_mesh.h"
#include "hierarchy/hierarchy.h"

namespace interleaf {

struct Series {
    std::size_t step_count = 0;

    /// Reads the step with a number from 0 to step_count - 1. It gives the same mesh for the same number.
    std::function<FieldMesh(std::size_t step)> read;
};

struct SeriesOptions {
    /// If set, the keys are sampled: each field differs from the field of the step by at most this part of the
    /// field's range over all steps, 0 to 1. With 0, a triangle is bisected until one cell of the step holds
    /// it. If not set, the leaves of each key are the triangles of the step.
    std::optional<double> tolerance{};

    /// The corner of a triangle, 0 to 2, that is the newest vertex. If not set, all three are tried.
    std::optional<unsigned> newest{};

    /// The point fields that the keys get; all if empty.
    std::vector<std::string> fields{};

    /// A point field of two or three components. The positions of a key are the points plus this field, and
    /// the points alone tell which vertices of two steps are the same. None if empty.
    std::string displacement{};

    /// A key whose roots, with their positions, are the roots of all keys; null to find the roots.
    const Hierarchy* roots = nullptr;
};

/// Flat steps that are not the leaves of one hierarchy, or do not conform: with a tolerance, they can be sampled.
struct NeedsTolerance : InputError {
    /// A tolerance that usually keeps a sampled key about as large as its step.
    static constexpr double usual = 0.003;

    explicit NeedsTolerance(const std::string& why);

    std::string reason;  ///< the text without the advice
};

/// How the hierarchies were found. docs/series.md describes the methods.
enum class SeriesMethod {
    by_order,     ///< the order of corners and triangles tells which triangles are the halves of one
    by_place,     ///< vertices at one place are the same vertex
    by_sampling,  ///< the fields were sampled to a tolerance
    by_fitting,   ///< a key was fitted to each surface; recover() never does so
};

/// Surfaces that are not flat, and that no method of recover() suits. Keys may still be fitted to closed ones.
struct UnrecoveredSurfaces : InputError {
    using InputError::InputError;
};

/// "order of corners", "place of vertices", "sampling" or "fitting".
std::string_view name_of(SeriesMethod method);

/// How a key compares with the step that it stands for.
struct StepReport {
    std::size_t triangles = 0;  ///< of the step
    std::size_t leaves = 0;     ///< of the key

    /// Largest difference between the key and the step, as a part of the range of the field over all steps;
    /// of the worst field. 0 for an exact key. Of a fitted key, at the vertices of the step.
    double largest_difference = 0;

    /// Largest distance between the surfaces of key and step, as a part of the diagonal of the step's box. 0 unless
    /// the key is fitted.
    double distance = 0;

    /// Largest difference of the integrals over the surface, as a part of area times range.
    double integral_error = 0;

    /// How far corresponding points of a fitted key move until the next key, and how far the surface moves: means
    /// over the area, as parts of the diagonal of the box. 0 in the last step, and for keys that are not fitted.
    double point_motion = 0;
    double surface_motion = 0;

    /// How far fronts move until the next key, in widths of a front; of the field with the most. Linear
    /// interpolation shows fronts that move by more than a width as two fading fronts. 0 in the last step.
    double moved_widths = 0;
};

struct SeriesReport {
    SeriesMethod method = SeriesMethod::by_order;
    std::size_t root_count = 0;
    std::vector<StepReport> steps;   ///< one per step
    std::vector<std::string> notes;  ///< sentences about what had to be decided, for the user
};

/// Receives what is going on and the part of the whole work that is done, 0 to 1. It may throw to end the
/// work. An empty function is never called.
using SeriesProgress = std::function<void(std::string_view stage, double part)>;

/// Receives the keys in the order of the steps. All keys have equal roots and the same fields, and pass
/// check(). A field of several components becomes one scalar per component: "name x", "name y", "name z". Where a
/// step shows that the method does not hold, all keys come once more by another method, from step 0 on.
using TakeKey = std::function<void(std::size_t step, Hierarchy key)>;

/// Recovers the key hierarchies of \p series.
///
/// Without a tolerance, the leaves of each key are exactly the triangles of its step, or the series is
/// refused. The recovery is deterministic. The time is linear in the number of triangles.
/// \throw InputError  naming the step and the place, and what would help, where the steps are no surfaces, have
///     different fields, or are not the leaves of one hierarchy; an UnrecoveredSurfaces where that is the only
///     fault, and they are not flat, or NeedsTolerance, if they are
/// \throw UsageError  if an option is out of its range
SeriesReport recover(const Series& series, const SeriesOptions& options, const TakeKey& take_key,
                     const SeriesProgress& progress = {});

}  // namespace interleaf
