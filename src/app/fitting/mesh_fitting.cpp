#include "app/fitting/mesh_fitting.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "text/shown_text.h"
#include <fmt/core.h>

#include "app/document/message.h"
#include "app/fitting/tile_places.h"
#include "ui/dialogs/progress_dialog.h"
#include "ui/widgets/number_text.h"

namespace interleaf {

namespace {

std::string name_of(const std::filesystem::path& mesh) {
    return shown_name(mesh.filename().string());
}

std::string capitalised(std::string name) {
    if (!name.empty() && name[0] >= 'a' && name[0] <= 'z') name[0] = static_cast<char>(name[0] - 'a' + 'A');
    return name;
}

std::string remark_of(const MeshPreviews::Preview& preview) {
    if (!preview.is_read) return "reading";
    return preview.triangles > 0 ? fmt::format("{} triangles", grouped(preview.triangles)) : "";
}

}  // namespace

void MeshFitting::offer(Task task, Receiver receiver) {
    meshes_ = std::move(task.meshes);
    reason_ = std::move(task.reason);
    receiver_ = std::move(receiver);
    are_roots_given_ = task.roots.has_value();
    roots_ = task.roots ? std::vector{*std::move(task.roots)} : named_roots();
    origin_ = task.origin;
    reference_ = task.reference;
    dialog_.open(meshes_.size(), can_be_placed());
    previews_ = std::make_unique<MeshPreviews>(meshes_);
    is_reading_ = true;
}

void MeshFitting::show(const Rect& area, double now) {
    if (dialog_.is_open()) {
        if (const auto answer = dialog_.show(area, offer_shown())) answer_ = answer;
    } else if (job_) {
        show_work(area, now);
    }
}

std::optional<std::string> MeshFitting::update(float density, double now) {
    std::erase_if(leaving_, [](const auto& previews) { return previews->is_over(); });
    if (const auto answer = std::exchange(answer_, std::nullopt)) close_offer(*answer, now);
    if (dialog_.is_open())
        is_reading_ = previews_->update(static_cast<int>(std::lround(dialog_.tile_side() * density)),
                                        ups_of(dialog_.choices()));
    return std::exchange(is_work_closed_, false) ? hand_on_keys() : std::nullopt;
}

// ---- the fit dialog ----

void MeshFitting::close_offer(bool is_accepted, double now) {
    previews_->stop();
    leaving_.push_back(std::move(previews_));
    is_reading_ = false;
    if (is_accepted)
        start(now);
    else
        receiver_ = nullptr;
}

FitOfferShown MeshFitting::offer_shown() const {
    const bool is_single = meshes_.size() == 1;
    const std::string reason = reason_.empty() ? "" : fmt::format("No keys as they are: {}. ", reason_);
    FitOfferShown shown{.text = is_single ? fmt::format("Fit a key to {}?", name_of(meshes_.front()))
                                          : fmt::format("Fit keys to these {} meshes?", meshes_.size()),
                        .detail = fmt::format(
                            "{}{} mapped to the sphere and sampled over the roots; the picture{} about where "
                            "their edges will lie. For closed surfaces without handles.",
                            reason, is_single ? "It is" : "Each is", is_single ? " shows" : "s show"),
                        .roots = {},
                        .roots_remark = are_roots_given_ ? "those of the family's keys" : "",
                        .meshes = tiles(),
                        .can_be_placed = can_be_placed(),
                        .parts_remark = {},
                        .holes_remark = {},
                        .fault = {}};
    for (const NamedRoots& roots : roots_) shown.roots.push_back(capitalised(roots.name));
    std::vector<std::string> names;
    for (const FitTile& tile : shown.meshes) {
        names.push_back(tile.name);
        if (!tile.fault.empty() && shown.fault.empty()) shown.fault = tile.fault;
    }
    tell_changes(shown);
    const FitChoices& choices = dialog_.choices();
    if (const std::string fault = fault_of(choices, roots_[choices.roots].roots, names); !fault.empty())
        shown.fault = fault;
    return shown;
}

/// Describes the largest loss and the largest addition among the meshes, which the user must allow.
void MeshFitting::tell_changes(FitOfferShown& shown) const {
    const auto& previews = previews_->previews();
    const FitChoices& choices = dialog_.choices();
    const auto tell = [&](double MeshPreviews::Preview::*part, double limit, std::string_view text) {
        const auto most = std::ranges::max_element(previews, {}, part);
        if (!((*most).*part > limit)) return std::string();
        return fmt::format(
            fmt::runtime(text), 100 * (*most).*part,
            previews.size() == 1
                ? ""
                : fmt::format(" of {}", name_of(meshes_[std::size_t(most - previews.begin())])));
    };
    constexpr CleanUpLimits limits;
    shown.parts_remark =
        tell(&MeshPreviews::Preview::dropped, limits.dropped_area, "loses {:.2g} % of the area{} (orange)");
    shown.holes_remark =
        tell(&MeshPreviews::Preview::made, limits.made_area, "adds {:.2g} % to the area{} (blue)");
    if (!shown.fault.empty()) return;
    if (!shown.parts_remark.empty() && !choices.keep_largest)
        shown.fault = "A key is made of one part: keep only the largest, or bring the parts one by one";
    else if (!shown.holes_remark.empty() && !choices.fill_holes)
        shown.fault = "A key is closed: fill the holes, or close them elsewhere first";
}

std::vector<FitTile> MeshFitting::tiles() const {
    const FitChoices& choices = dialog_.choices();
    std::vector<TileBody> bodies;
    bodies.reserve(meshes_.size());
    for (const MeshPreviews::Preview& preview : previews_->previews())
        if (preview.is_read && preview.fault.empty()) bodies.push_back(preview.body);
    const std::vector<TilePlace> places = tile_places(bodies, placing_of(choices), reference_);
    auto place = places.begin();
    std::vector<FitTile> tiles;
    tiles.reserve(meshes_.size());
    for (std::size_t mesh = 0; mesh < meshes_.size(); ++mesh) {
        const MeshPreviews::Preview& preview = previews_->previews()[mesh];
        const FitChoices::Turn& turn = choices.turns[mesh];
        const bool has_place = preview.is_read && preview.fault.empty();
        const TilePlace here = has_place ? *place++ : TilePlace();
        tiles.push_back({.name = name_of(meshes_[mesh]),
                         .remark = remark_of(preview),
                         .picture = preview.picture.name(),
                         .fault = preview.fault,
                         .root_edges = edges_over_mesh(roots_[choices.roots].roots, turn),
                         .axis = turn.axis,
                         .is_turned = rotation_of(turn) != glm::dmat3(1),
                         .center = here.center,
                         .radius = here.radius});
    }
    return tiles;
}

// ---- the work ----

void MeshFitting::start(double now) {
    const FitChoices& choices = dialog_.choices();
    std::vector<glm::dmat3> rotations;
    rotations.reserve(choices.turns.size());
    for (const FitChoices::Turn& turn : choices.turns) rotations.push_back(rotation_of(turn));
    started_ = now;
    job_.emplace(FitTask{.meshes = meshes_,
                         .options = fit_options(choices, roots_[choices.roots].roots),
                         .rotations = std::move(rotations),
                         .ups = ups_of(choices),
                         .placing = placing_of(choices),
                         .matches = choices.match_parts,
                         .origin = origin_,
                         .reference = reference_});
}

void MeshFitting::show_work(const Rect& area, double now) {
    const FitJob::State state = job_->state();
    const std::string title = meshes_.size() == 1 ? fmt::format("Fitting {}", name_of(meshes_.front()))
                                                  : fmt::format("Fitting {} meshes", meshes_.size());
    const bool is_cancelled =
        progress_dialog({.title = title, .stage = state.stage, .part = state.part, .seconds = now - started_},
                        area, state.is_done);
    if (is_cancelled) job_->cancel();
    if (state.is_done) is_work_closed_ = true;
}

/// \pre the work is done
std::optional<std::string> MeshFitting::hand_on_keys() {
    const Receiver receiver = std::exchange(receiver_, nullptr);
    FittedMeshes fitted;
    try {
        fitted = job_->take();
    } catch (const Cancelled&) {
        job_.reset();
        return std::nullopt;
    } catch (const std::exception& error) {
        job_.reset();
        return cause_of(error);
    }
    job_.reset();
    receiver(std::move(fitted));
    return std::nullopt;
}

}  // namespace interleaf
