#include "app/window/blend_panel.h"

#include <cstddef>
#include <vector>

#include "app/document/blend_commands.h"
#include "family/family_time.h"
#include "ui/panels/weights_panel.h"
#include "ui/widgets/command_keys.h"

namespace interleaf {

namespace {

DriverButton driver_button(Driver driver, const Family& family) {
    switch (driver) {
        case Driver::timeline:
            return source_of_time(family) == TimeSource::path
                       ? DriverButton{"Path",
                                      with_keys("The present time on the path drives", {"Follow timeline"})}
                       : DriverButton{"Timeline", with_keys("The present time drives", {"Follow timeline"})};
        case Driver::point:
            return {"Domain", with_keys("The point of the parameter domain drives, where it was last",
                                        {"Follow point in domain"})};
        case Driver::key:
            return {"Key", with_keys("One key is shown alone, the selected one", {"Show one key"})};
        case Driver::weights:
            return {"Weights", with_keys("The sliders drive: each is a weight. Moving one chooses this, too",
                                         {"Hold weights"})};
    }
    return {"", ""};
}

}  // namespace

BlendActions show_blend(const ViewerState& state) {
    const Session& session = state.session;
    std::vector<Driver> drivers;
    std::vector<DriverButton> buttons;
    std::size_t present = 0;
    for (const Driver driver : {Driver::timeline, Driver::point, Driver::key, Driver::weights}) {
        if (!session.can_drive(driver)) continue;
        if (driver == session.driver()) present = drivers.size();
        drivers.push_back(driver);
        buttons.push_back(driver_button(driver, session.family()));
    }
    const WeightsPanelResult done = weights_panel({.family = session.family(),
                                                   .weights = session.weights(),
                                                   .drivers = buttons,
                                                   .driver = present,
                                                   .can_reset = can_reset_weights(state)});
    BlendActions actions{.driver = {}, .weights = done.weights, .resets = done.resets};
    if (done.driver) actions.driver = drivers[*done.driver];
    return actions;
}

void apply_to_blend(const BlendActions& done, ViewerState& state, double now) {
    if (done.weights) state.session.set_weights(*done.weights, now);
    if (done.resets) reset_weights(state, now);
    if (done.driver) choose_driver(state, *done.driver, now);
}

}  // namespace interleaf
