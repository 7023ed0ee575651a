#include "app/window/film_export.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>
#include <utility>

#include <fmt/core.h>
#include <glm/common.hpp>

#include "app/pictures/picture_legend.h"
#include "family/family_fields.h"
#include "hierarchy/progress.h"
#include "io/file/file_pattern.h"
#include "io/file/safe_write.h"
#include "io/film/png_bytes.h"
#include "render/image_texture.h"
#include "text/shown_text.h"
#include "ui/dialogs/progress_dialog.h"
#include "ui/widgets/number_text.h"

namespace interleaf {
namespace {

using Clock = std::chrono::steady_clock;

/// How long frames of the film are painted in one frame of the window, so that the window lives.
constexpr std::chrono::milliseconds painting_time{40};

std::string name_of_film(const std::filesystem::path& file) {
    return shown_name(file.filename().string());
}

std::string detail_of(const FilmPlan& plan, bool is_film) {
    if (!is_film) return fmt::format("{}x{} pixels", plan.size.x, plan.size.y);
    const FrameTimes& frames = plan.film.frames;
    return fmt::format("{} frames, {:.4g} s", grouped(frames.count),
                       static_cast<double>(frames.count) / frames.rate);
}

void write_picture(const std::filesystem::path& file, const FilmPlan& plan,
                   const std::vector<std::uint8_t>& rgba) {
    write_file(file, png_bytes(rgba, plan.size.x, plan.size.y));
}

}  // namespace

void FilmExport::offer(std::filesystem::path file, std::shared_ptr<const Family> family,
                       const Session& session, const Camera& camera, glm::ivec2 view_size) {
    const FilmFormat* const format = film_format_with_extension(lower_case_extension(file));
    preview_of_.reset();
    preview_fault_.clear();
    preview_ = {};
    dialog_.open(first_choices(session, format == nullptr ? std::optional(view_size) : std::nullopt));
    has_legend_ = has_picture_legend(session.display, fields_of(*family));
    offer_.emplace(Offer{std::move(file), format, std::move(family), session, camera});
}

FilmPlan FilmExport::plan() const {
    return plan_of(dialog_.choices(), offer_->session, offer_->camera, offer_->format);
}

void FilmExport::show(const Rect& area, double now) {
    if (dialog_.is_open()) {
        const FilmPlan planned = plan();
        const bool is_sound = planned.fault.empty();
        const FilmOfferShown shown{
            .title = fmt::format("{} {}", offer_->format != nullptr ? "Film" : "Picture",
                                 name_of_film(offer_->file)),
            .detail = is_sound ? detail_of(planned, offer_->format != nullptr) : "",
            .is_film = offer_->format != nullptr,
            .offers_legend = has_legend_,
            .shows_edges = offer_->session.display.wireframe || offer_->session.display.refinement_edges ||
                           offer_->session.display.root_edges,
            .preview = preview_.name(),
            .aspect = preview_of_
                          ? static_cast<float>(preview_of_->size.x) / static_cast<float>(preview_of_->size.y)
                          : 16 / 9.0F,
            .fault = is_sound ? preview_fault_ : planned.fault};
        if (const auto answer = dialog_.show(area, shown)) answer_ = answer;
    } else if (work_) {
        const std::size_t count = work_->plan.film.frames.count;
        const bool is_painted = work_->next == count;
        const bool is_cancelled = progress_dialog(
            {.title = fmt::format("Making {}", name_of_film(offer_->file)),
             .stage = is_painted ? "encoding" : fmt::format("frame {} of {}", work_->next + 1, count),
             .part = static_cast<double>(work_->next) / static_cast<double>(count),
             .seconds = now - work_->started},
            area, work_->is_closing);
        if (is_cancelled && work_->encoder) work_->encoder->cancel();
        work_->is_cancelled |= is_cancelled && !is_painted;
    }
}

std::optional<Message> FilmExport::update(float density, double now) {
    try {
        if (const auto answer = std::exchange(answer_, std::nullopt)) {
            if (*answer)
                start(now);
            else
                offer_.reset();
        }
        if (dialog_.is_open()) draw_preview(density);
        if (work_ && !work_->is_closing)
            paint_some();
        else if (work_)
            return end_work(now);
    } catch (const std::runtime_error& error) {
        work_.reset();
        offer_.reset();
        return message_of(error);
    }
    return std::nullopt;
}

/// Draws the first frame small, if the choices give another one than the preview shows.
void FilmExport::draw_preview(float density) {
    const FilmPlan planned = plan();
    if (!planned.fault.empty()) return;
    const float width = std::max(std::round(dialog_.preview_width() * density), 1.0F);
    const float aspect = static_cast<float>(planned.size.x) / static_cast<float>(planned.size.y);
    const glm::ivec2 size(width, std::max(std::round(width / aspect), 1.0F));
    const PreviewOf wanted{size, planned.film.frames.begin, planned.display};
    if (wanted == preview_of_) return;
    preview_of_ = wanted;
    preview_fault_.clear();
    try {
        BlendPainter painter(*offer_->family, size.x, size.y, planned.display);
        const Weights weights = weights_of_frame(planned.film, *offer_->family, 0);
        preview_ = image_texture(size.x, size.y, painter.paint(weights, planned.film.camera));
    } catch (const std::runtime_error& error) {
        preview_ = {};
        preview_fault_ = error.what();
    }
}

void FilmExport::start(double now) {
    Work work{.plan = plan()};
    const glm::ivec2 size = work.plan.size;
    work.painter = std::make_unique<BlendPainter>(*offer_->family, size.x, size.y, work.plan.display);
    if (offer_->format != nullptr)
        work.encoder = std::make_unique<FilmEncoder>(offer_->file, *offer_->format,
                                                     FilmPicture{size.x, size.y, work.plan.film.frames.rate});
    work.started = now;
    work_.emplace(std::move(work));
}

/// Paints frames until the time is over, or ffmpeg takes no more for now.
void FilmExport::paint_some() {
    Work& work = *work_;
    const Film& film = work.plan.film;
    const auto end = Clock::now() + painting_time;
    while (!work.is_cancelled && work.next < film.frames.count && Clock::now() < end) {
        if (work.encoder && !work.encoder->takes_frames()) return;
        std::vector<std::uint8_t> rgba = work.painter->paint(
            weights_of_frame(film, *offer_->family, work.next), camera_of_frame(film, work.next));
        ++work.next;
        if (work.encoder)
            work.encoder->add(std::move(rgba));
        else
            write_picture(offer_->file, work.plan, rgba);
    }
    const bool is_painted = work.next == film.frames.count;
    if (is_painted && work.encoder && !work.finished.valid())
        work.finished = std::async(std::launch::async, [encoder = work.encoder.get()] { encoder->finish(); });
    const bool is_finished = !work.finished.valid() ||
                             work.finished.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    work.is_closing = work.is_cancelled || (is_painted && is_finished);
}

/// The progress dialog has closed.
std::optional<Message> FilmExport::end_work(double now) {
    Work work = *std::exchange(work_, std::nullopt);
    const Offer offer = *std::exchange(offer_, std::nullopt);
    try {
        if (work.finished.valid()) work.finished.get();
    } catch (const Cancelled&) {
        work.is_cancelled = true;
    }
    if (work.is_cancelled) return std::nullopt;
    const std::string made = fmt::format(": {}", detail_of(work.plan, offer.format != nullptr));
    const std::string folder = shown_name(offer.file.parent_path().string());
    return Message{.text = fmt::format("Made {} in {}{}", name_of_film(offer.file), folder, made),
                   .kind = MessageKind::notice,
                   .seen = now};
}

}  // namespace interleaf
