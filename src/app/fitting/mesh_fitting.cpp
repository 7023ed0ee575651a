#include "app/fitting/mesh_fitting.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>

#include "app/document/message.h"
#include "app/fitting/tile_places.h"
#include "fit/landmarks/landmark_report.h"
#include "fit/preview.h"
#include "text/shown_text.h"
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
    offer_ = {.task = std::move(task), .points = {}};
    const Task& now = offer_.task;
    for (const auto& [name, direction] : now.landmarks) {
        LandmarkPoint point{.name = name, .places = {}, .direction = direction};
        point.places.resize(now.meshes.size() + 1);
        point.places.front() = point_in_direction(**now.first_key, now.roots->roots, direction);
        offer_.points.push_back(std::move(point));
    }
    begin(std::move(receiver));
    // The first key of a family may be any shape; landmarks show that its parts have counterparts.
    dialog_.open(now.meshes.size(), can_be_placed(), now.meshes.size() > 1 || !now.landmarks.empty());
}

void MeshFitting::offer_again(Receiver receiver) {
    offer_ = *last_;
    begin(std::move(receiver));
    dialog_.open(last_->choices);
    open_landmarks();
}

void MeshFitting::begin(Receiver receiver) {
    receiver_ = std::move(receiver);
    roots_ = offer_.task.roots ? std::vector{*offer_.task.roots} : named_roots();
    previews_ = std::make_unique<MeshPreviews>(offer_.task.meshes);
    is_reading_ = true;
}

void MeshFitting::show(const Rect& area, double now) {
    if (landmarks_.is_open()) {
        landmarks_.show(area);
    } else if (dialog_.is_open()) {
        if (const auto answer = dialog_.show(area, offer_shown())) answer_ = answer;
    } else {
        job_.show(area, now);
    }
}

std::optional<std::string> MeshFitting::update(float density, double now) {
    std::erase_if(leaving_, [](const auto& previews) { return previews->is_over(); });
    if (const auto answer = std::exchange(answer_, std::nullopt)) close_offer(*answer, now);
    if (auto points = landmarks_.update(density)) offer_.points = *std::move(points);
    if (dialog_.wants_landmarks()) open_landmarks();
    if (dialog_.is_open())
        is_reading_ = previews_->update(static_cast<int>(std::lround(dialog_.tile_side() * density)),
                                        ups_of(dialog_.choices()));
    return job_.is_over() ? hand_on_keys() : std::nullopt;
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
    const bool is_single = offer_.task.meshes.size() == 1;
    const std::string reason =
        offer_.task.reason.empty() ? "" : fmt::format("No keys as they are: {}. ", offer_.task.reason);
    FitOfferShown shown{
        .text = is_single ? fmt::format("Fit a key to {}?", name_of(offer_.task.meshes.front()))
                          : fmt::format("Fit keys to these {} meshes?", offer_.task.meshes.size()),
        .detail =
            fmt::format("{}{} mapped to the sphere and sampled over the roots; the picture{} about where "
                        "their edges will lie. For closed surfaces without handles.",
                        reason, is_single ? "It is" : "Each is", is_single ? " shows" : "s show"),
        .roots = {},
        .roots_remark = offer_.task.roots ? "those of the family's keys" : "",
        .meshes = tiles(),
        .can_be_matched = offer_.can_be_matched(),
        .landmarks = {},
        .can_be_placed = can_be_placed(),
        .parts_remark = {},
        .holes_remark = {},
        .fault = {}};
    const auto pairs =
        std::ranges::count_if(offer_.points, [](const LandmarkPoint& point) { return is_paired(point, 0); });
    if (pairs > 0) shown.landmarks = fmt::format("{} {} of points", pairs, pairs == 1 ? "pair" : "pairs");
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
                : fmt::format(" of {}", name_of(offer_.task.meshes[std::size_t(most - previews.begin())])));
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
    bodies.reserve(offer_.task.meshes.size());
    for (const MeshPreviews::Preview& preview : previews_->previews())
        if (preview.is_read && preview.fault.empty()) bodies.push_back(preview.body);
    const std::vector<TilePlace> places = tile_places(bodies, placing_of(choices), offer_.task.reference);
    auto place = places.begin();
    std::vector<FitTile> tiles;
    tiles.reserve(offer_.task.meshes.size());
    for (std::size_t mesh = 0; mesh < offer_.task.meshes.size(); ++mesh) {
        const MeshPreviews::Preview& preview = previews_->previews()[mesh];
        const FitChoices::Turn& turn = choices.turns[mesh];
        const bool has_place = preview.is_read && preview.fault.empty();
        const TilePlace here = has_place ? *place++ : TilePlace();
        tiles.push_back({.name = name_of(offer_.task.meshes[mesh]),
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
    FitTask task{.meshes = offer_.task.meshes,
                 .options = fit_options(choices, roots_[choices.roots].roots),
                 .rotations = std::move(rotations),
                 .ups = ups_of(choices),
                 .placing = placing_of(choices),
                 .matches = choices.match_parts,
                 .origin = offer_.task.origin,
                 .reference = offer_.task.reference};
    add_landmarks(task);
    last_ = LastFit{offer_, choices};
    const std::string title = offer_.task.meshes.size() == 1
                                  ? fmt::format("Fitting {}", name_of(offer_.task.meshes.front()))
                                  : fmt::format("Fitting {} meshes", offer_.task.meshes.size());
    job_.start(title, fit_work(std::move(task)), now);
}

/// Gives the task the landmarks that correspond, and the first key of the family.
void MeshFitting::add_landmarks(FitTask& task) const {
    const Task& now = offer_.task;
    const std::size_t before = now.first_key ? 1 : 0;  // the key comes before the meshes
    if (now.first_key) task.first_key = **now.first_key;
    const bool has_pairs =
        std::ranges::any_of(offer_.points, [](const LandmarkPoint& point) { return is_paired(point, 0); });
    if (!has_pairs) return;
    for (std::size_t mesh = 0; mesh < now.meshes.size(); ++mesh)
        task.landmarks.push_back(counting_landmarks(offer_.points, mesh + before));
    if (!now.first_key) return;
    const PreviewReference reference = preview_reference(**now.first_key, task.options.roots);
    std::vector<Landmark> first;
    for (const LandmarkPoint& point : offer_.points)
        if (is_paired(point, 0)) first.push_back({point.name, *point.places.front(), point.direction});
    task.targets = targets_on(reference, first);
}

void MeshFitting::open_landmarks() {
    const Task& now = offer_.task;
    const FitChoices& choices = dialog_.choices();
    const std::vector<UpAxis> ups = ups_of(choices);
    LandmarkEditing::Task task{
        .sources = {}, .names = {}, .roots = roots_[choices.roots].roots, .points = offer_.points};
    if (now.first_key) {
        task.sources.push_back(
            {.file = {}, .up = UpAxis::y, .rotation = glm::dmat3(1), .key = **now.first_key});
        task.names.push_back(now.key_name);
    }
    for (std::size_t mesh = 0; mesh < now.meshes.size(); ++mesh) {
        task.sources.push_back({.file = now.meshes[mesh],
                                .up = ups[mesh],
                                .rotation = rotation_of(choices.turns[mesh]),
                                .key = {}});
        task.names.push_back(name_of(now.meshes[mesh]));
    }
    task.other = std::max<std::size_t>(1, dialog_.selected_mesh() + task.sources.size() - now.meshes.size());
    landmarks_.open(std::move(task));
}

/// \pre the work is done
std::optional<std::string> MeshFitting::hand_on_keys() {
    const Receiver receiver = std::exchange(receiver_, nullptr);
    FittedMeshes fitted;
    try {
        fitted = job_.take();
    } catch (const Cancelled&) {
        return std::nullopt;
    } catch (const std::exception& error) {
        return cause_of(error);
    }
    receiver(std::move(fitted));
    return std::nullopt;
}

}  // namespace interleaf
