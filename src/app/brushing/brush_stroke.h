// A stroke of the refine brush over the selected key: one undoable step of the document, which follows the mouse
// while the stroke goes on. Only the selected key changes.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "app/brushing/brushed_key.h"
#include "app/brushing/fitted_surface.h"
#include "app/document/viewer_state.h"
#include "render/pick.h"

namespace interleaf {

/// The key that the brush works on: the selected key, while it is shown alone; none otherwise.
std::optional<std::size_t> brushed_key(const ViewerState& state);

/// What the user has to do before the brush works; "" if it does.
const char* brush_hint(const ViewerState& state);

/// The radius of the brush on the key \p key, in the unit of its positions.
float brush_radius(const ViewerState& state, std::size_t key);

/// Takes the brush in hand, or puts it away. Shows the selected key alone, or the key with the largest weight, at
/// full detail. The levels of the brush become two above and two below the level of most leaves of that key.
void toggle_brush(ViewerState& state, double now);

class BrushStroke {
  public:
    bool is_active() const { return active_ != nullptr; }

    /// Begins a stroke on brushed_key(). Does nothing if there is none.
    void begin(ViewerState& state, bool coarsens);

    /// Touches the key where \p rays meet it. Ends the stroke, without further effect, if something else has changed
    /// the document since.
    /// \param shows  whether the document follows now; otherwise it follows in a later call, or in end()
    void touch(ViewerState& state, std::span<const Ray> rays, bool shows, double now);

    /// Ends the stroke. The document has all of it.
    void end(ViewerState& state, double now);

    /// Takes the stroke back, as if it had never been.
    void cancel(ViewerState& state, double now);

  private:
    struct Active {
        std::size_t key;
        bool coarsens;
        float radius;
        BrushedKey brushed;
        std::shared_ptr<const Family> family;  ///< the document's last state that the stroke knows
        std::size_t shown_leaves;              ///< of the key in that state
    };
    /// A key that strokes have made of a fitted key.
    struct Descendant {
        SharedHierarchy key;
        std::shared_ptr<const FitComparison> comparison;
    };

    void follow_surface(const ViewerState& state, const SharedHierarchy& key);
    bool is_stale(const ViewerState& state) const;
    void show(ViewerState& state, double now);
    void report(ViewerState& state) const;
    void put_down(ViewerState& state);

    std::unique_ptr<FittedSurface> surface_;  ///< of the brushed key; null if there is none
    std::vector<Descendant> descendants_;
    std::unique_ptr<Active> active_;
};

}  // namespace interleaf
