#include "app/mesh_fitting.h"

#include <charconv>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "ui/progress_dialog.h"

namespace interleaf {

namespace {

constexpr Index least_leaves = 12;
constexpr Index most_leaves = 10'000'000;

std::optional<Index> leaves_in(const std::string& text) {
    Index leaves = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), leaves);
    if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    if (leaves < least_leaves || leaves > most_leaves) return std::nullopt;
    return leaves;
}

std::string fault_of_leaves(const std::string& text) {
    return leaves_in(text) ? "" : fmt::format("a number of leaves, {} to {}", least_leaves, most_leaves);
}

}  // namespace

Question question_about_fit(std::span<const std::filesystem::path> meshes) {
    const bool is_single = meshes.size() == 1;
    return {.text = is_single ? fmt::format("Fit a key to {}?", meshes.front().filename().string())
                              : fmt::format("Fit keys to these {} meshes?", meshes.size()),
            .detail = fmt::format(
                "{} mapped to the sphere and sampled over the roots of a cube, with at most so many "
                "leaves{}. For closed surfaces without handles.",
                is_single ? "It is" : "Their faces differ. Each is", is_single ? "" : " each"),
            .buttons = {"Fit", "Cancel"},
            .entry = "20000",
            .fault = fault_of_leaves};
}

FitOptions fit_options(const Answer& answer) {
    FitOptions options;
    options.leaves = leaves_in(answer.entry);
    return options;
}

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
