// The row of controls that play the timeline.
#pragma once

#include <optional>
#include <string>

#include "family/family.h"
#include "family/interpolation.h"
#include "family/playback.h"
#include "ui/widgets/rect.h"

namespace interleaf {

/// The state of playback that the controls show.
struct TransportState {
    double time;
    double end;                         ///< of the timeline
    TimeUnit unit = TimeUnit::seconds;  ///< what these times count
    std::string unit_name = "s";        ///< as people write it; empty for steps
    bool playing;
    bool plays_back;  ///< whether playback runs backward
    Repeat repeat;
    double speed;                 ///< units of the time per second
    double frame_rate;            ///< frames per second, for single steps
    Interpolation interpolation;  ///< of the keys
    BlendKind blend = BlendKind::straight;
    TimeSource source;      ///< what drives the blend over time
    bool has_both_sources;  ///< whether the user can choose the other source
};

/// A button of the row.
enum class TransportButton {
    first_key,
    previous_key,
    step_back,
    play_backward,
    play,
    step_forward,
    next_key,
    last_key,
    ask_for_time,   ///< the user wants to type the time
    ask_for_speed,  ///< the user wants to type the speed
    ask_for_rate,   ///< the user wants to type the frame rate
    ask_for_degree  ///< the user wants to type the degree of Bernstein pieces
};

struct TransportResult {
    std::optional<TransportButton> pressed;
    std::optional<Repeat> repeat;                ///< chosen
    std::optional<double> speed;                 ///< chosen
    std::optional<double> frame_rate;            ///< chosen
    std::optional<Interpolation> interpolation;  ///< chosen
    std::optional<BlendKind> blend;              ///< chosen
    std::optional<TimeSource> source;            ///< chosen
};

/// Draws the row at the cursor.
/// \param width  of the row; a narrow row shows fewer controls
TransportResult show_transport(const TransportState& state, float width);

}  // namespace interleaf
