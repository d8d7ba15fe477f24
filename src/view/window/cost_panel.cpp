#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "view/window/ui.h"

namespace glibra::view {

void costPanel(Ui& ui) {
    const bool isOpen = ImGui::CollapsingHeader("Frame rate");
    mark(ui, "cost");
    if (!isOpen) return;
    constexpr int kLeastFrames = 20;
    constexpr double kLeastSeconds = .5;
    if (ImGui::Button("Measure"))
        ui.cost = measureFrames(ui.session, ui.context.capabilities(), kLeastFrames, kLeastSeconds);
    mark(ui, "cost/measure");
    if (!ui.cost || ui.cost->frames == 0) return;
    const FrameCost& cost = *ui.cost;
    constexpr double kMillisecondsInSecond = 1000;
    ImGui::Text("%.1f frames a second, %.3f ms each", kMillisecondsInSecond / cost.millisecondsAFrame,
                cost.millisecondsAFrame);
    ImGui::TextDisabled("mean of %d frames, the scene alone", cost.frames);
    if (cost.counts)
        ImGui::Text("%llu vertices, %llu primitives, %llu fragments",
                    static_cast<unsigned long long>(cost.counts->vertices),
                    static_cast<unsigned long long>(cost.counts->primitives),
                    static_cast<unsigned long long>(cost.counts->fragments));
    double longest = 0;
    for (const DrawCost& each : cost.draws) longest = std::max(longest, each.milliseconds);
    for (const DrawCost& each : cost.draws) {
        const std::string text = fmt::format("{} ({}){}: {:.3f} ms", each.word, each.line,
                                             each.isWindow ? "" : " into textures", each.milliseconds);
        ImGui::ProgressBar(longest > 0 ? static_cast<float>(each.milliseconds / longest) : 0, {-1, 0},
                           text.c_str());
    }
}

}  // namespace glibra::view
