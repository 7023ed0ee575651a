#include "app/landmarks/landmark_preview.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "app/landmarks/landmark_points.h"
#include "fit/clean_up/clean_up.h"
#include "fit/landmarks/landmark_report.h"
#include "fit/landmarks/landmark_targets.h"
#include "fit/landmarks/proposals.h"
#include "hierarchy/error.h"
#include "io/read_files.h"

namespace interleaf {
namespace {

SurfaceMesh mesh_of(const LandmarkSource& source) {
    if (source.key) return surface_of(*source.key);
    SurfaceFile surface = read_surface(source.file);
    turn_up(surface.positions, source.up);
    return clean_up({std::move(surface.positions), std::move(surface.triangles), {}}, {}).mesh;
}

/// The names of landmarks that mirror each other on the first mesh.
std::vector<std::array<std::string, 2>> mirrored_names(const std::vector<Landmark>& landmarks) {
    std::vector<glm::dvec3> places;
    places.reserve(landmarks.size());
    for (const Landmark& landmark : landmarks) places.push_back(landmark.position);
    std::vector<std::array<std::string, 2>> names;
    for (const auto& [left, right] : mirror_pairs(places))
        names.push_back({landmarks[left].name, landmarks[right].name});
    return names;
}

/// Places \p key by its landmarks, or else gives it the size and the center of \p first.
Hierarchy placed(Hierarchy key, std::optional<Similarity> placement, const Hierarchy& first) {
    if (!placement) {
        const SurfaceExtent own = extent_of(surface_of(key));
        const SurfaceExtent wanted = extent_of(surface_of(first));
        placement = Similarity{.scale = own.size > 0 ? wanted.size / own.size : 1,
                               .rotation = glm::dmat3(1),
                               .from_center = own.center,
                               .to_center = wanted.center};
    }
    for (glm::vec3& position : key.positions) position = glm::vec3((*placement)(glm::dvec3(position)));
    return key;
}

}  // namespace

LandmarkPreview::LandmarkPreview(std::vector<LandmarkSource> sources, SphereRoots roots)
    : sources_(std::move(sources)),
      roots_(std::move(roots)),
      bodies_(sources_.size()),
      thread_([this](const std::stop_token& stop) { work(stop); }) {}

void LandmarkPreview::wish(std::size_t mesh, std::vector<Landmark> first, std::vector<Landmark> other) {
    const std::scoped_lock lock(mutex_);
    wish_ = Wish{mesh, std::move(first), std::move(other), ++wish_count_};
    is_working_ = true;
    wished_.notify_all();
}

std::shared_ptr<const LandmarkBody> LandmarkPreview::body(std::size_t mesh) const {
    const std::scoped_lock lock(mutex_);
    return bodies_[mesh];
}

std::shared_ptr<const LandmarkBlend> LandmarkPreview::blend() const {
    const std::scoped_lock lock(mutex_);
    return blend_;
}

bool LandmarkPreview::is_working() const {
    const std::scoped_lock lock(mutex_);
    return is_working_;
}

bool LandmarkPreview::is_over() const {
    const std::scoped_lock lock(mutex_);
    return is_over_;
}

bool LandmarkPreview::is_wanted(std::size_t number) const {
    const std::scoped_lock lock(mutex_);
    return number == wish_count_;
}

void LandmarkPreview::work(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
        Wish wish;
        {
            std::unique_lock lock(mutex_);
            is_working_ = wish_.has_value();
            if (!wished_.wait(lock, stop, [&] { return wish_.has_value(); })) break;
            wish = *std::exchange(wish_, std::nullopt);
        }
        const auto first = read(0, stop);
        const auto other = read(wish.mesh, stop);
        if (first && other && first->fault.empty() && other->fault.empty()) make_blend(wish, stop);
    }
    const std::scoped_lock lock(mutex_);
    is_working_ = false;
    is_over_ = true;
}

/// Reads a body, first without proposals.
std::shared_ptr<const LandmarkBody> LandmarkPreview::read(std::size_t mesh, const std::stop_token& stop) {
    if (auto present = body(mesh)) return present;
    const auto publish = [&](const LandmarkBody& body) {
        const std::scoped_lock lock(mutex_);
        bodies_[mesh] = std::make_shared<const LandmarkBody>(body);
        return bodies_[mesh];
    };
    LandmarkBody body;
    try {
        body.mesh = mesh_of(sources_[mesh]);
        publish(body);
        for (const Extremity& each : find_extremities(
                 body.mesh, {}, [&](std::string_view, double) { return !stop.stop_requested(); }))
            body.proposals.push_back(body.mesh.positions[each.vertex]);
    } catch (const Cancelled&) {
        return nullptr;
    } catch (const std::exception& error) {
        body.fault = error.what();
    }
    return publish(body);
}

void LandmarkPreview::make_blend(const Wish& wish, const std::stop_token& stop) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    std::shared_ptr<LandmarkBlend> blend;
    try {
        blend = blended(
            wish, [&](std::string_view, double) { return !stop.stop_requested() && is_wanted(wish.number); });
    } catch (const Cancelled&) {
        return;
    } catch (const std::exception& error) {
        blend = std::make_shared<LandmarkBlend>();
        blend->fault = error.what();
    }
    blend->mesh = wish.mesh;
    blend->first = wish.first;
    blend->other = wish.other;
    blend->seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const std::scoped_lock lock(mutex_);
    blend_ = std::move(blend);
}

std::shared_ptr<LandmarkBlend> LandmarkPreview::blended(const Wish& wish, const Progress& progress) {
    PreviewOptions options{.roots = roots_};
    if (!reference_) {
        const LandmarkSource& source = sources_.front();
        options.rotation = source.rotation;
        reference_ = source.key ? preview_reference(*source.key, roots_)
                                : preview_reference(body(0)->mesh, options, progress);
    }
    options.rotation = sources_[wish.mesh].rotation;
    auto blend = std::make_shared<LandmarkBlend>();
    AimedLandmarks aimed;
    std::optional<Similarity> placement;
    if (!wish.other.empty()) {
        aimed = aim(wish.other, targets_on(*reference_, wish.first));
        try {
            placement = placement_of(aimed, std::nullopt);
        } catch (const InputError& error) {
            blend->warnings.emplace_back(error.what());
        }
    }
    PreviewKey made =
        preview_key(body(wish.mesh)->mesh, aimed, mirrored_names(wish.first), options, progress);
    blend->warnings.insert(blend->warnings.end(), made.faults.begin(), made.faults.end());
    blend->ways = std::move(made.agreement.ways);
    if (!wish.first.empty()) {
        std::vector<glm::dvec3> places;
        places.reserve(wish.first.size());
        for (const Landmark& landmark : wish.first) places.push_back(landmark.position);
        const MorphDistortion distortion = morph_distortion(reference_->key, made.key, places);
        const std::string fault = fault_of_distortion(distortion, wish.first[distortion.worst].name);
        if (!fault.empty()) blend->warnings.push_back(fault);
    }
    blend->first_key = std::make_shared<const Hierarchy>(reference_->key);
    blend->placed_key = std::make_shared<const Hierarchy>(placed(made.key, placement, reference_->key));
    blend->other_key = std::make_shared<const Hierarchy>(std::move(made.key));
    return blend;
}

}  // namespace interleaf
