// The section "Frame rate": measures the time per frame, pass and draw.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

/// A bar per pass, and below it one per draw. The full width is the longest pass.
void bars(Ui& ui, const FrameCost& cost) {
    double longest = 0;
    for (const PassCost& each : cost.passes) longest = std::max(longest, each.milliseconds);
    const auto bar = [&](double milliseconds, const std::string& text) {
        const float part = longest > 0 ? static_cast<float>(milliseconds / longest) : 0;
        ImGui::ProgressBar(part, {-1, 0}, fmt::format("{}: {:.3f} ms", text, milliseconds).c_str());
    };
    for (std::size_t pass = 0; pass < cost.passes.size(); ++pass) {
        const PassCost& each = cost.passes[pass];
        const std::string line = each.line > 0 ? fmt::format(" (line {})", each.line) : "";
        bar(each.milliseconds, fmt::format("pass {} into {}{}", pass + 1, each.target, line));
        mark(ui, "cost/pass/{}", pass);
        ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_SliderGrabActive));
        ImGui::Indent();
        for (const DrawCost& draw : cost.draws)
            if (draw.pass == static_cast<int>(pass))
                bar(draw.milliseconds, fmt::format("{} (line {})", draw.word, draw.line));
        ImGui::Unindent();
        ImGui::PopStyleColor();
    }
}

}  // namespace

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
    ImGui::Text("%.1f frames per second, %.3f ms per frame",
                kMillisecondsInSecond / cost.millisecondsPerFrame, cost.millisecondsPerFrame);
    ImGui::TextDisabled("mean of %d frames, without panels", cost.frames);
    if (cost.counts)
        ImGui::Text("%llu vertices, %llu primitives, %llu fragments",
                    static_cast<unsigned long long>(cost.counts->vertices),
                    static_cast<unsigned long long>(cost.counts->primitives),
                    static_cast<unsigned long long>(cost.counts->fragments));
    bars(ui, cost);
}

}  // namespace glibra::view
