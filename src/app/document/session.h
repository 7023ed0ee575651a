// The session: the open family with its present time and its point in the parameter domain. No window, no GL.
//
// The time, the point, a single key or weights set by hand drive the morph. The time is that of the timeline's keys or
// of the path through the domain, whichever the family chooses. While the keys drive, the point follows them; there is
// no point while their weights are not those of a point of the domain. Moving the point does not change the time.
#pragma once

#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "family/family.h"
#include "family/playback.h"
#include "render/display.h"

namespace interleaf {

/// The source of the weights.
enum class Driver {
    timeline,  ///< the time: keys or path, by source_of_time() (family_time.h)
    point,     ///< the point of the parameter domain
    key,       ///< a single key
    weights,   ///< weights set by hand
};

/// The name of \p driver, such as "timeline".
std::string_view name_of(Driver driver);

class Session {
  public:
    /// Starts paused at the beginning of the timeline or the path that drives; without either, at the first vertex
    /// of the domain; without a domain, too, at the first key.
    /// \pre check(*family) finds nothing
    explicit Session(std::shared_ptr<const Family> family);

    const Family& family() const { return *family_; }

    /// Continues with \p family, an edited version, at the same or the nearest time and point. A single key
    /// remains the key with the same hierarchy, or else in the same place with the same name; or becomes the first
    /// key. Weights set by hand stay with their keys in the same way. If the family has lost what drove
    /// the morph, the time drives; without a timeline and a path the point; without a domain the first key.
    /// \pre check(*family) finds nothing
    void replace_family(std::shared_ptr<const Family> family, double now);

    /// Updates time, point and weights to wall time \p now, in seconds. The other functions with a parameter
    /// \p now do so, too.
    void advance(double now);

    Driver driver() const { return driver_; }
    const Weights& weights() const { return weights_; }

    /// The sets of active keys that may be shown next. While the keys of the timeline drive: those of the next two
    /// intervals in the direction of playback, then of the previous one. Otherwise those of the triangles that share
    /// an edge with the triangle of the point, in no special order; none without a point, or while a single key
    /// drives.
    std::vector<std::vector<std::size_t>> next_key_sets() const;

    /// The point with the present weights; none without a domain, or if no point has these weights.
    const std::optional<DomainPoint>& point() const { return point_; }

    /// Moves the point to \p at, or to the nearest point of the domain, and lets the point drive. Pauses
    /// playback.
    /// \pre the family has a domain
    void move_point(glm::dvec2 at, double now);

    /// Lets the single key \p key drive. Pauses playback.
    void show_key(std::size_t key, double now);

    /// Sets the weights by hand, and lets them drive. Pauses playback.
    /// \param weights  keys ascending, each once and below the number of keys; at least one; finite values
    void set_weights(Weights weights, double now);

    /// The weights from which set_weights() has departed; null while other weights drive.
    const Weights* first_weights() const { return driver_ == Driver::weights ? &first_weights_ : nullptr; }

    /// Lets \p driver drive from what it had last: the present time; the last point that drove, or the first
    /// vertex; the last single key; or the present weights. Pauses playback.
    /// \pre can_drive(driver)
    void drive_by(Driver driver, double now);
    bool can_drive(Driver driver) const;

    bool has_timeline() const { return family_->timeline.has_value(); }

    /// Whether the family has a timeline or a path.
    bool has_time() const;

    /// Time on the timeline or the path that drives at the last advance(), in its unit; 0 without either.
    double time() const { return playback_.time(now_); }
    bool is_playing() const { return playback_.is_playing(now_); }
    bool plays_back() const { return playback_.goes_back(now_); }
    const Playback& playback() const { return playback_; }

    /// The functions below do nothing without has_time(). Those that play or change the time let the time
    /// drive.

    /// Pauses playback in the given direction, or plays in it.
    void toggle_playing(double now, bool backward = false);
    void pause(double now);
    void seek(double time, double now);

    /// Goes to the next frame (\p direction 1) or to the previous one (-1). Frames begin at playback's
    /// begin and last 1 / frame_rate units of the time.
    void step_frame(int direction, double now);

    /// Goes to the next key of the timeline (\p direction 1) or to the previous one (-1); while the path drives
    /// the time, to its points.
    void seek_key(int direction, double now);

    void set_repeat(Repeat repeat, double now);

    /// \param speed  units of the time per second of wall time
    void set_speed(double speed, double now);

    /// The in and out points; none for the whole interval.
    void set_range(std::optional<TimeRange> range, double now);

    Display display;
    double frame_rate = 30;  ///< frames per unit of the time, for step_frame(); above 0

  private:
    /// Parts of next_key_sets().
    std::vector<std::vector<std::size_t>> next_intervals() const;
    std::vector<std::vector<std::size_t>> neighboring_triangles() const;

    /// The weights of the keys with the same hierarchies in \p family; empty if it has none of them.
    Weights weights_in(const Family& family, const Weights& weights) const;

    /// Lets the time drive; without one the point, which starts at the first vertex if there was
    /// none; without either the first key.
    void drive_with_what_there_is();

    /// Gives playback the interval of the family's time.
    void follow_interval(double now);

    std::shared_ptr<const Family> family_;
    double now_ = 0;           ///< wall time of the last advance(), seconds
    Playback playback_{0, 0};  ///< of the family's time; without one it rests at 0 and keeps repeat and speed
    Driver driver_ = Driver::key;
    std::size_t key_ = 0;  ///< the key that drives under Driver::key
    std::optional<DomainPoint> point_;
    std::optional<glm::dvec2> driving_point_;  ///< the last point that drove
    Weights first_weights_;                    ///< the weights before the first of set_weights()
    Weights weights_{{0, 1.0}};
};

}  // namespace interleaf
