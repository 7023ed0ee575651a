// Makes pictures and films in the window: shows the film dialog, then paints the frames, some in every frame of
// the window, while ffmpeg encodes them.
#pragma once

#include <cstddef>
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>

#include "app/document/message.h"
#include "app/document/session.h"
#include "app/pictures/blend_painter.h"
#include "app/pictures/film_plan.h"
#include "io/film/film_encoder.h"
#include "render/camera.h"
#include "render/gl_object.h"
#include "ui/dialogs/film_dialog.h"
#include "ui/widgets/rect.h"

namespace interleaf {

class FilmExport {
  public:
    /// Opens the dialog for \p file, a film or a picture. Everything is taken from the present state: later
    /// edits do not change the film.
    /// \param family  of \p session
    /// \param view_size  of the window's view, pixels
    /// \pre is_open() is false
    void offer(std::filesystem::path file, std::shared_ptr<const Family> family, const Session& session,
               const Camera& camera, glm::ivec2 view_size);

    /// Whether the dialog or the progress is in front of the window.
    bool is_open() const { return dialog_.is_open() || work_.has_value(); }

    /// Whether the window must draw again soon, even without input.
    bool is_working() const { return work_.has_value(); }

    const FilmDialog& dialog() const { return dialog_; }

    /// Closes the dialog, if it is open, with the next show(), and makes nothing.
    void dismiss_dialog() { dialog_.dismiss(); }

    /// Shows the dialog or the progress, if open, in the middle of \p area. Call it in every frame from the
    /// same place.
    void show(const Rect& area, double now);

    /// Acts on the answer, draws the preview, and paints frames for a short time. Call it in every frame.
    /// \param density  framebuffer pixels per screen coordinate
    /// \return         what to tell the user, once
    /// \pre a GL context is current
    std::optional<Message> update(float density, double now);

  private:
    /// The subject of the dialog.
    struct Offer {
        std::filesystem::path file;
        const FilmFormat* format;  ///< null for a picture
        std::shared_ptr<const Family> family;
        Session session;
        Camera camera;
    };

    /// What the preview shows.
    struct PreviewOf {
        glm::ivec2 size;  ///< pixels
        double begin;     ///< seconds
        Display display;
        bool operator==(const PreviewOf&) const = default;
    };

    /// Frames in the making.
    struct Work {
        FilmPlan plan;
        std::unique_ptr<BlendPainter> painter{};
        std::unique_ptr<FilmEncoder> encoder{};  ///< null for a picture
        std::size_t next = 0;                    ///< frame to paint
        std::future<void> finished{};            ///< valid when all frames are painted
        double started = 0;
        bool is_cancelled = false;
        bool is_closing = false;  ///< the progress dialog is shown for the last time
    };

    FilmPlan plan() const;
    void draw_preview(float density);
    void start(double now);
    void paint_some();
    std::optional<Message> end_work(double now);

    std::optional<Offer> offer_;
    bool has_legend_ = false;  ///< whether the colors of the offer have one
    FilmDialog dialog_;
    std::optional<bool> answer_;  ///< kept for update()
    std::optional<PreviewOf> preview_of_;
    GlTexture preview_;
    std::string preview_fault_;  ///< why there is no preview; "" if there is one
    std::optional<Work> work_;
};

}  // namespace interleaf
