#include "app/mesh_fitting.h"

#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "ui/progress_dialog.h"

namespace interleaf {

void MeshFitting::start(std::vector<std::filesystem::path> meshes, FitOptions options, Receiver receiver,
                        double now) {
    title_ = meshes.size() == 1 ? fmt::format("Fitting {}", meshes.front().filename().string())
                                : fmt::format("Fitting {} meshes", meshes.size());
    receiver_ = std::move(receiver);
    started_ = now;
    job_.emplace(std::move(meshes), std::move(options));
}

std::optional<std::string> MeshFitting::show(const Rect& area, double now) {
    if (!job_) return std::nullopt;
    const FitJob::State state = job_->state();
    const bool is_cancelled = progress_dialog(
        {.title = title_, .stage = state.stage, .part = state.part, .seconds = now - started_}, area,
        state.is_done);
    if (is_cancelled) job_->cancel();
    if (!state.is_done) return std::nullopt;

    const Receiver receiver = std::exchange(receiver_, nullptr);
    std::vector<Key> keys;
    try {
        keys = job_->take();
    } catch (const Cancelled&) {
        job_.reset();
        return std::nullopt;
    } catch (const std::exception& error) {
        job_.reset();
        return error.what();
    }
    job_.reset();
    receiver(std::move(keys));
    return std::nullopt;
}

}  // namespace interleaf
