// Time: play, pause, step, position and speed.

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include <vector>

#include "view/window/panels/ui.h"

namespace glibra::view {

namespace {

/// The number of steps of each Step block. Returns true if the user wants the next step.
bool stepControls(Ui& ui) {
    const std::vector<render::Simulation::Progress> progress = ui.session.live().steps();
    if (progress.empty()) return false;
    const bool isWanted = ImGui::Button("Step >");
    mark(ui, "time/step");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Pause, and go to the next step (B)");
    for (const render::Simulation::Progress& each : progress) {
        if (&each == &progress.front()) ImGui::SameLine();
        ImGui::Text("Step %g (line %d): %lld steps", each.rate, each.place.line,
                    static_cast<long long>(each.steps));
        mark(ui, "time/steps/{}", each.place.line);
    }
    return isWanted;
}

}  // namespace

void timePanel(Ui& ui) {
    if (!ImGui::CollapsingHeader("Time", ImGuiTreeNodeFlags_DefaultOpen)) return;
    Clock clock = ui.session.clock();
    // The button has the same width for both words, so that nothing moves.
    const float width = ImGui::CalcTextSize("Pause").x + 2 * ImGui::GetStyle().FramePadding.x;
    if (ImGui::Button(clock.isPlaying() ? "Pause###play" : "Play###play", ImVec2(width, 0)))
        clock.play(!clock.isPlaying());
    mark(ui, "time/play");
    ImGui::SameLine();
    if (ImGui::Button("< Frame")) clock.step(-1);
    mark(ui, "time/back");
    ImGui::SameLine();
    if (ImGui::Button("Frame >")) clock.step(1);
    mark(ui, "time/forward");
    ImGui::SameLine();
    const bool restarts = ImGui::Button("Restart");
    if (restarts) clock.setTime(0);
    mark(ui, "time/restart");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Set the time to 0 seconds; what lasts begins anew");
    const bool steps = stepControls(ui);
    if (!ui.session.live().isAnimated()) {
        ImGui::SameLine();
        ImGui::TextDisabled("no Timer");
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("No shader of this scene reads Timer, so time does not change the picture");
    }

    ImGui::PushItemWidth(-ImGui::CalcTextSize("Seconds ").x);
    constexpr double kShownSeconds = 10;  // the slider ends at a multiple of this
    double time = clock.time();
    const double begin = 0;
    const double end = std::max(kShownSeconds, std::ceil(time / kShownSeconds) * kShownSeconds);
    if (ImGui::SliderScalar("Seconds", ImGuiDataType_Double, &time, &begin, &end, "%.3f")) {
        clock.play(false);
        clock.setTime(time);
    }
    markField(ui, "time/scrub", "Seconds");
    double speed = clock.speed();
    const double slowest = -4;
    const double fastest = 4;
    if (ImGui::SliderScalar("Speed", ImGuiDataType_Double, &speed, &slowest, &fastest, "%.2f x"))
        clock.setSpeed(speed);
    markField(ui, "time/speed", "Speed");
    ImGui::PopItemWidth();
    ui.session.setClock(clock);
    if (restarts) ui.session.restart();
    if (steps) ui.session.nextStep();
}

}  // namespace glibra::view
