// The session: what is open and where it stands in time and in the parameter domain. No window, no GL.
//
// The timeline, the point or a single key drives the morph. While the timeline drives, the point follows
// along its path; where the timeline's weights are not a point of the domain there is none. Moving the point
// leaves the timeline where it is.
#pragma once

#include <memory>
#include <optional>
#include <string_view>

#include "family/family.h"
#include "family/playback.h"
#include "render/display.h"

namespace interleaf {

/// What the weights come from.
enum class Driver {
    timeline,
    point,  ///< of the parameter domain
    key,    ///< alone
};

/// "timeline".
std::string_view name_of(Driver driver);

class Session {
  public:
    /// At the timeline's begin, paused; without a timeline at the domain's first vertex; without either at
    /// the first key. \pre  check(*family) finds nothing
    explicit Session(std::shared_ptr<const Family> family);

    const Family& family() const { return *family_; }

    /// Goes on with \p family, an edited one: at the same time and point, or the nearest there are. A single
    /// key stays the one with the same hierarchy, or becomes the first. Without what drove, the timeline
    /// drives, else the point, else the first key. \pre  check(*family) finds nothing
    void replace_family(std::shared_ptr<const Family> family, double now);

    /// Brings time, point and weights up to wall time \p now, in seconds. The other functions that take \p
    /// now do so, too.
    void advance(double now);

    Driver driver() const { return driver_; }
    const Weights& weights() const { return weights_; }

    /// The point with the present weights; none without a domain and where no point has them.
    const std::optional<DomainPoint>& point() const { return point_; }

    /// Moves the point to \p at, or to the nearest point of the domain, and lets it drive. Playback pauses.
    /// \pre  the family has a domain
    void move_point(glm::dvec2 at, double now);

    /// Lets \p key alone drive. Playback pauses.
    void show_key(std::size_t key, double now);

    bool has_timeline() const { return family_->timeline.has_value(); }

    /// Time on the timeline at the last advance(), seconds; 0 without a timeline.
    double time() const { return playback_.time(now_); }
    bool is_playing() const { return playback_.is_playing(now_); }
    bool loops() const { return has_timeline() && playback_.loops(); }

    /// The functions below do nothing without a timeline. All but toggle_loop() let the timeline drive.
    void toggle_playing(double now);
    void seek(double time, double now);

    /// Goes to the next key of the timeline (\p direction 1) or to the one before (-1).
    void seek_key(int direction, double now);

    void toggle_loop(double now);

    Display display;

  private:
    /// The timeline, else the point, where it is or at the first vertex, else the first key.
    void drive_with_what_there_is();

    std::shared_ptr<const Family> family_;
    double now_ = 0;           ///< wall time of the last advance(), seconds
    Playback playback_{0, 0};  ///< over the timeline; without one it rests at 0, but keeps its loop
    Driver driver_ = Driver::key;
    std::size_t key_ = 0;  ///< that drives where a single one does
    std::optional<DomainPoint> point_;
    Weights weights_{{0, 1.0}};
};

}  // namespace interleaf
