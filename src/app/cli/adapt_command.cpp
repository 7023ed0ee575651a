#include "app/cli/adapt_command.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/cli/held_interrupts.h"
#include "app/cli/progress_line.h"
#include "hierarchy/error.h"
#include "hierarchy/measure.h"
#include "hierarchy/progress.h"
#include "io/family/family_file.h"
#include "sequence/adaptive_domain.h"
#include "sequence/deformation_flow.h"
#include "sequence/flow.h"
#include "shapes/blend_error.h"

namespace interleaf {
namespace {

/// The part of the tolerance that a key may be away from its own surface.
constexpr double key_part = 0.3;

constexpr double min_adapt_tolerance = 1e-4;

constexpr std::array flow_constants = {SurfaceConstant{"time", 0.5, 0, flow_duration},
                                       SurfaceConstant{"strength", 1, 0, 1}};

std::vector<Shape> all_parametric_shapes() {
    std::vector<Shape> found;
    for (const Shape& shape : shapes())
        if (shape.parametric != nullptr) found.push_back(shape);
    const auto flow = [](const glm::dvec3& direction, std::span<const double> constants) {
        return flowed_point(direction, constants[0], constants[1], flow_duration);
    };
    found.push_back({"flow", "the ball in the flow", unit_sphere, nullptr, flow_constants, flow});
    return found;
}

const Shape& shape_called(const std::string& name) {
    const auto shapes = parametric_shapes();
    const auto found = std::ranges::find(shapes, name, &Shape::name);
    if (found != shapes.end()) return *found;
    std::string known;
    for (const Shape& shape : shapes) known += (known.empty() ? "" : ", ") + std::string(shape.name);
    throw UsageError(fmt::format("--adapt: expected a shape with constants, {}, got '{}'", known, name));
}

/// The place of \p range among the constants of \p shape.
std::size_t constant_of(const Shape& shape, const ConstantRange& range) {
    const auto found = std::ranges::find(shape.constants, range.name, &SurfaceConstant::name);
    if (found == shape.constants.end()) {
        std::string known;
        for (const SurfaceConstant& constant : shape.constants)
            known += (known.empty() ? "" : ", ") + std::string(constant.name);
        throw UsageError(
            fmt::format("--range: {} has the constants {}, got '{}'", shape.name, known, range.name));
    }
    if (!(found->low <= range.low && range.low < range.high && range.high <= found->high))
        throw UsageError(fmt::format("--range: {} of {} goes from {} to {}, got {}:{}", range.name,
                                     shape.name, found->low, found->high, range.low, range.high));
    return static_cast<std::size_t>(found - shape.constants.begin());
}

/// A shape over the plane of two of its constants.
class ShapePlane {
  public:
    ShapePlane(const Shape& shape, const std::vector<ConstantRange>& ranges)
        : shape_(shape), axes_{constant_of(shape, ranges[0]), constant_of(shape, ranges[1])} {
        if (axes_[0] == axes_[1]) throw UsageError("--range: expected two different constants");
    }

    Shape at(const glm::dvec2& parameter) const {
        std::vector<double> values;
        for (const SurfaceConstant& constant : shape_.constants) values.push_back(constant.value);
        values[axes_[0]] = parameter.x;
        values[axes_[1]] = parameter.y;
        return with_constants(shape_, std::move(values));
    }

  private:
    const Shape& shape_;
    std::array<std::size_t, 2> axes_;
};

/// Diagonal of the box of the surfaces at the corners of the domain and in its middle.
double diagonal_of(const ShapePlane& plane, const DomainBox& box) {
    constexpr Index leaves = 2000;
    std::optional<Box> all;
    for (const glm::dvec2 part : {glm::dvec2(0, 0), {1, 0}, {0, 1}, {1, 1}, {0.5, 0.5}}) {
        const Hierarchy key = make_key(plane.at(glm::mix(box.low, box.high, part)), {leaves, {}});
        const Box own = bounding_box(key.positions);
        all = all ? Box{glm::min(all->min, own.min), glm::max(all->max, own.max)} : own;
    }
    return glm::distance(glm::dvec3(all->min), glm::dvec3(all->max));
}

}  // namespace

std::span<const Shape> parametric_shapes() {
    static const std::vector<Shape> found = all_parametric_shapes();
    return found;
}

void run_adapt(const AdaptOptions& options, const std::filesystem::path& folder,
               const HierarchyFileOptions& form) {
    const Shape& shape = shape_called(options.shape);
    if (options.ranges.size() != 2)
        throw UsageError("--adapt: expected two --range, one per axis of the domain");
    if (!options.tolerance || !(*options.tolerance >= min_adapt_tolerance && *options.tolerance <= 1))
        throw UsageError(fmt::format("--adapt: expected --tolerance {} to 1", min_adapt_tolerance));
    const ShapePlane plane(shape, options.ranges);
    const DomainBox box{{options.ranges[0].low, options.ranges[1].low},
                        {options.ranges[0].high, options.ranges[1].high}};
    const double allowed = *options.tolerance * diagonal_of(plane, box);
    const ComputedSurfaces surfaces{
        .key =
            [&](const glm::dvec2& at) {
                return Key{fmt::format("{:.4g}, {:.4g}", at.x, at.y),
                           make_key(plane.at(at), {{}, key_part * *options.tolerance})};
            },
        .distance =
            [&](const glm::dvec2& at, const UnionMesh& mesh, std::span<const glm::vec3> positions) {
                return distance_from(plane.at(at), mesh, positions) / allowed;
            }};

    const HeldInterrupts interrupts;
    Family family;
    try {
        ProgressLine line;
        family = adapt_domain(surfaces, {.box = box}, [&](std::size_t keys) {
            line.show(fmt::format("{} keys", keys), 0);
            if (interrupts.is_waiting()) throw Cancelled();
        });
    } catch (const Cancelled&) {
        return;  // the held interrupt ends the program when `interrupts` is destroyed
    }
    family.name = fmt::format("{} by {} and {}", shape.name, options.ranges[0].name, options.ranges[1].name);
    write_family(family, folder, form);
    fmt::print("{} keys, {} triangles in the domain\n", family.keys.size(),
               family.domain->triangles().size());
}

}  // namespace interleaf
