// Time: play, pause, step, position and speed.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <vector>

#include "view/window/panels/icons.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_slider.h"

namespace glibra::view {
namespace {

/// The number of steps of each Step block. Returns true if the user wants the next step.
bool stepControls(Ui& ui) {
    const std::vector<render::Simulation::Progress> progress = ui.session.live().steps();
    if (progress.empty()) return false;
    continueRowForIcon();
    const bool isWanted = iconButton(Icon::step, "step", "Pause, and go to the next step (B)");
    mark(ui, "time/step");
    for (const render::Simulation::Progress& each : progress) {
        ImGui::Text("Step %g (line %d): %lld steps", each.rate, each.place.line,
                    static_cast<long long>(each.steps));
        mark(ui, "time/steps/{}", each.place.line);
    }
    return isWanted;
}

/// There is nothing to play. What Once has made can be made anew.
void withoutTime(Ui& ui) {
    ImGui::TextDisabled("This scene does not use time.");
    mark(ui, "time/none");
    tooltip("No shader reads Timer, and no expression reads time, frame or tick");
    if (ui.session.live().scene().once.empty()) return;
    if (button(ui, "Restart", "time/restart", "What Once has made begins anew")) ui.session.restart();
}

void timePanel(Ui& ui) {
    if (!section(ui, "Time", "time", ui.session.usesTime())) return;
    if (!ui.session.usesTime()) return withoutTime(ui);
    Clock clock = ui.session.clock();
    const bool isPlaying = clock.isPlaying();
    if (iconButton(isPlaying ? Icon::pause : Icon::play, "play", isPlaying ? "Pause (Space)" : "Play (Space)",
                   isPlaying))
        clock.play(!isPlaying);
    mark(ui, "time/play");
    continueRowForIcon();
    if (iconButton(Icon::back, "back", "Previous frame (,)")) clock.step(-1);
    mark(ui, "time/back");
    continueRowForIcon();
    if (iconButton(Icon::forward, "forward", "Next frame (.)")) clock.step(1);
    mark(ui, "time/forward");
    continueRowForIcon();
    const bool restarts =
        iconButton(Icon::restart, "restart", "Set the time to 0 seconds; what lasts begins anew");
    if (restarts) clock.setTime(0);
    mark(ui, "time/restart");
    const bool steps = stepControls(ui);

    constexpr double kShownSeconds = 10;  // the slider ends at a multiple of this
    double time = clock.time();
    const double end = std::max(kShownSeconds, std::ceil(time / kShownSeconds) * kShownSeconds);
    fieldLabel("Seconds");
    if (labelledSlider(ui, "##seconds", "time/scrub", {0, end}, time, " s")) {
        clock.play(false);
        clock.setTime(time);
    }
    double speed = clock.speed();
    constexpr double kFastest = 4;
    fieldLabel("Speed");
    if (labelledSlider(ui, "##speed", "time/speed", {-kFastest, kFastest}, speed, " x"))
        clock.setSpeed(speed);
    ui.session.setClock(clock);
    if (restarts) ui.session.restart();
    if (steps) ui.session.nextStep();
}

/// Changes the time of a scene that uses it.
template <class Change>
void changeClock(Ui& ui, const Change& change) {
    if (!ui.session.usesTime()) return;
    Clock clock = ui.session.clock();
    change(clock);
    ui.session.setClock(clock);
}

template <int frames>
void stepFrames(Ui& ui, Panel& /*panel*/) {
    changeClock(ui, [](Clock& clock) { clock.step(frames); });
}

constexpr auto kTimeKeys = std::to_array<Shortcut>({
    {KeyGroup::time, GLFW_KEY_SPACE, false, "Space", "play or pause",
     [](Ui& ui, Panel&) { changeClock(ui, [](Clock& clock) { clock.play(!clock.isPlaying()); }); }},
    {KeyGroup::time, GLFW_KEY_PERIOD, false, ".", "next frame", stepFrames<1>},
    {KeyGroup::time, GLFW_KEY_COMMA, false, ",", "previous frame", stepFrames<-1>},
    {KeyGroup::time, GLFW_KEY_B, false, "B", "pause, and go to the next step",
     [](Ui& ui, Panel&) { ui.session.nextStep(); }},
    // Without a key: for the list of commands.
    {KeyGroup::time, kNoKey, false, "", "restart at 0 seconds; what Once has made begins anew",
     [](Ui& ui, Panel&) { ui.session.restart(); }},
});

}  // namespace

const PanelRow kTimeRow{
    .name = "time", .place = PanelPlace::section, .make = make<Drawn<timePanel>>, .keys = kTimeKeys};

}  // namespace glibra::view
