// The section "Frame rate": measures the time per frame, pass, dispatch, draw and step.

#include <fmt/format.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "view/session/frame_cost.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

std::string lineNote(int line) {
    return line > 0 ? fmt::format(" (line {})", line) : "";
}

void bar(double milliseconds, double longest, const std::string& text, int decimals) {
    const float part = longest > 0 ? static_cast<float>(milliseconds / longest) : 0;
    // A thin line below the text, which nobody takes for a slider.
    ImGui::BeginGroup();
    ImGui::Text("%s: %s ms", text.c_str(), millisecondsText(milliseconds, decimals).c_str());
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const float height = std::max(2.F, ImGui::GetFontSize() * .2F), width = ImGui::GetContentRegionAvail().x;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(at, {at.x + width, at.y + height}, ImGui::GetColorU32(ImGuiCol_FrameBg));
    list.AddRectFilled(at, {at.x + width * part, at.y + height}, ImGui::GetColorU32(ImGuiCol_PlotHistogram));
    ImGui::Dummy({width, height});
    ImGui::EndGroup();
}

/// Bars in another colour, farther to the right.
template <class Draw>
void inner(const Draw& draw) {
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    ImGui::Indent();
    draw();
    ImGui::Unindent();
    ImGui::PopStyleColor();
}

/// A bar for each pass, dispatch and clear of the frame, with one for each draw below, and for each Once and
/// Step block, with what a run executes. The longest bar has the full width.
void bars(Ui& ui, const FrameCost& cost) {
    const int decimals = decimalsOf(cost);
    double longest = cost.millisecondsOfParts;
    for (const NodeCost& each : cost.nodes) longest = std::max(longest, each.milliseconds);
    for (const BlockCost& each : cost.blocks) longest = std::max(longest, each.milliseconds);
    bar(cost.millisecondsOfParts, longest, cost.isEstimate ? "frame, about" : "frame", decimals);
    mark(ui, "cost/whole");
    for (std::size_t node = 0; node < cost.nodes.size(); ++node) {
        const NodeCost& each = cost.nodes[node];
        bar(each.milliseconds, longest, each.what + lineNote(each.line), decimals);
        mark(ui, "cost/node/{}", node);
        inner([&] {
            for (const DrawCost& draw : cost.draws)
                if (draw.node == node)
                    bar(draw.milliseconds, longest, draw.word + lineNote(draw.line), decimals);
        });
    }
    for (const BlockCost& each : cost.blocks) {
        if (each.runs == 0) {
            ImGui::TextDisabled("%s%s: no step has run yet", each.what.c_str(), lineNote(each.line).c_str());
            continue;
        }
        bar(each.milliseconds, longest, each.what + lineNote(each.line), decimals);
        if (ImGui::IsItemHovered())
            ImGui::SetTooltip("One run of the block: mean of the last %d before this picture", each.runs);
        inner([&] {
            for (const NodeCost& node : each.nodes)
                bar(node.milliseconds, longest, node.what + lineNote(node.line), decimals);
        });
    }
}

/// Nothing would end the frames of a shader that does not end.
bool canMeasure(const Session& session) {
    return session.hasScene() && !session.isStopped() && !session.isDrawing();
}

void measure(Ui& ui, std::optional<FrameCost>& measured) {
    constexpr int kLeastFrames = 20;
    constexpr double kLeastSeconds = .5;
    measured = measureFrames(ui.session, ui.context.capabilities(), kLeastFrames, kLeastSeconds);
}

void costPanel(Ui& ui, std::optional<FrameCost>& measured) {
    if (!section(ui, "Frame rate", "cost", false)) return;
    ImGui::BeginDisabled(!canMeasure(ui.session));
    if (button(ui, "Measure", "cost/measure")) measure(ui, measured);
    ImGui::EndDisabled();
    ImGui::SameLine();
    bool isLive = ui.session.measuresObjects();
    if (checkBox(ui, "On the picture", "cost/live", isLive,
                 "GPU time of the draws and dispatches of every frame, without clears, panels and the wait "
                 "for the screen (F)"))
        ui.session.setMeasuresObjects(isLive);
    if (!measured || measured->frames == 0) return;
    const FrameCost& cost = *measured;
    constexpr double kMillisecondsInSecond = 1000;
    ImGui::Text("%.1f frames per second", kMillisecondsInSecond / cost.millisecondsPerFrame);
    ImGui::TextDisabled("mean of %d frames, without panels and timers", cost.frames);
    if (cost.counts)
        ImGui::Text("%llu vertices, %llu primitives, %llu fragments",
                    static_cast<unsigned long long>(cost.counts->vertices),
                    static_cast<unsigned long long>(cost.counts->primitives),
                    static_cast<unsigned long long>(cost.counts->fragments));
    if (!cost.isTimed)
        ImGui::TextWrapped("Estimates, rounded: the driver has no timer, so each part is waited for.");
    else if (cost.isEstimate)
        ImGui::TextWrapped("Estimates, rounded: the processor draws, and would do parts together.");
    else
        ImGui::TextDisabled("GPU time by timer queries");
    mark(ui, "cost/how");
    bars(ui, cost);
}

nlohmann::ordered_json nodesJson(const std::vector<NodeCost>& nodes) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const NodeCost& each : nodes)
        json.push_back({{"what", each.what}, {"line", each.line}, {"milliseconds", each.milliseconds}});
    return json;
}

nlohmann::ordered_json costJson(const FrameCost& cost) {
    nlohmann::ordered_json blocks = nlohmann::ordered_json::array();
    for (const BlockCost& each : cost.blocks)
        blocks.push_back({{"what", each.what},
                          {"line", each.line},
                          {"runs", each.runs},
                          {"milliseconds", each.milliseconds},
                          {"nodes", nodesJson(each.nodes)}});
    return {{"frames", cost.frames},
            {"milliseconds", cost.millisecondsPerFrame},
            {"isTimed", cost.isTimed},
            {"isEstimate", cost.isEstimate},
            {"whole", cost.millisecondsOfParts},
            {"wholeText", millisecondsText(cost.millisecondsOfParts, decimalsOf(cost))},
            {"nodes", nodesJson(cost.nodes)},
            {"blocks", blocks}};
}

class CostPanel final : public Panel {
  public:
    void show(Ui& ui) override { costPanel(ui, measured_); }
    void measureNow(Ui& ui) {
        if (!canMeasure(ui.session)) return;
        ui.shared.showPanel = ui.settings.folds["cost"] = true;
        measure(ui, measured_);
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        if (measured_) state["cost"] = costJson(*measured_);
    }

  private:
    std::optional<FrameCost> measured_;
};

constexpr auto kCostKeys = std::to_array<Shortcut>(
    {{KeyGroup::pipeline, GLFW_KEY_F, false, "F", "show on the picture how long its objects take",
      [](Ui& ui, Panel&) { ui.session.setMeasuresObjects(!ui.session.measuresObjects()); }},
     // Without a key: for the list of commands.
     {KeyGroup::pipeline, kNoKey, false, "", "measure the frame rate: passes, dispatches, draws",
      call<&CostPanel::measureNow>}});

}  // namespace

const PanelRow kCostRow{
    .name = "cost", .place = PanelPlace::section, .make = make<CostPanel>, .keys = kCostKeys};

}  // namespace glibra::view
