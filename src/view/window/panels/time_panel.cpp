// Time: play, pause, step, position and speed.

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "view/window/panels/ui.h"

namespace glibra::view {

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
    if (ImGui::Button("Restart")) clock.setTime(0);
    mark(ui, "time/restart");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Set the time to 0 seconds");
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
}

}  // namespace glibra::view
