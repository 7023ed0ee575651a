#include "app/cli/landmarks_command.h"

#include <utility>
#include <vector>

#include <fmt/core.h>

#include "app/cli/held_interrupts.h"
#include "app/cli/progress_line.h"
#include "fit/clean_up/clean_up.h"
#include "fit/landmarks/proposals.h"
#include "hierarchy/error.h"
#include "hierarchy/landmark.h"
#include "io/file/file_pattern.h"
#include "io/file/output_target.h"
#include "io/landmarks/landmark_file.h"
#include "io/read_files.h"

namespace interleaf {
namespace {

OutputTarget landmark_target_of(const LandmarksOptions& options) {
    if (options.output == "-") return {};
    const std::filesystem::path file = options.output;
    if (lower_case_extension(file) != ".json")
        throw UsageError(fmt::format("landmarks: -o must name a .json file, got '{}'", options.output));
    return {.file = file};
}

struct Proposals {
    LandmarkSet set;
    std::vector<Extremity> extremities;
};

Proposals proposals_for(const LandmarksOptions& options, const Progress& progress) {
    SurfaceFile surface = read_surface(options.mesh);
    try {
        const CleanMesh clean = clean_up({std::move(surface.positions), std::move(surface.triangles), {}},
                                         part_of(progress, 0, 0.2));
        Proposals made;
        made.extremities =
            find_extremities(clean.mesh, {.max_count = options.max_count}, part_of(progress, 0.2, 1));
        for (const Extremity& each : made.extremities)
            made.set.landmarks.push_back(
                {fmt::format("tip {}", made.set.landmarks.size() + 1), clean.mesh.positions[each.vertex]});
        return made;
    } catch (const InputError& error) {
        throw InputError(fmt::format("{}: {}", options.mesh.string(), error.what()));
    }
}

}  // namespace

void run_landmarks(const LandmarksOptions& options) {
    const OutputTarget target = landmark_target_of(options);
    if (options.max_count < 1 || options.max_count > max_landmarks)
        throw UsageError(
            fmt::format("--max: expected a number from 1 to {}, got {}", max_landmarks, options.max_count));
    const HeldInterrupts interrupts;
    Proposals made;
    try {
        ProgressLine line;
        made = proposals_for(options, [&](std::string_view stage, double part) {
            line.show(fmt::format("{}: {}", options.mesh.filename().string(), stage), part);
            return !interrupts.is_waiting();
        });
    } catch (const Cancelled&) {
        return;  // the held interrupt ends the program when `interrupts` is destroyed
    }
    write_output(target, landmarks_text(made.set));
    if (options.output == "-") return;
    for (std::size_t k = 0; k < made.extremities.size(); ++k) {
        const Landmark& landmark = made.set.landmarks[k];
        const glm::dvec3& at = landmark.position;
        fmt::print("{}: at ({:.6g}, {:.6g}, {:.6g}), stands out by {:.3g} %\n", landmark.name, at.x, at.y,
                   at.z, 100 * made.extremities[k].persistence);
    }
}

}  // namespace interleaf
