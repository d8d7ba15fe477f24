// Time: play, pause, step, position and speed.

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "view/session/frame_cost.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"

namespace glibra::view {
namespace {

/// The number of steps of each Step block, and a button for the next step.
void stepControls(Ui& ui) {
    const std::vector<render::Simulation::Progress> progress = ui.session.live().steps();
    if (progress.empty()) return;
    continueRowForIcon();
    if (iconButton(Icon::step, "step", "Pause, and go to the next step (B)")) ui.session.nextStep();
    mark(ui, "time/step");
    for (const render::Simulation::Progress& each : progress) {
        ImGui::Text("Step %g (line %d): %lld steps", each.rate, each.place.line,
                    static_cast<long long>(each.steps));
        mark(ui, "time/steps/{}", each.place.line);
    }
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
    Clock& clock = ui.session.clock();
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
    if (iconButton(Icon::restart, "restart", "Set the time to 0 seconds; what lasts begins anew"))
        ui.session.restart();
    mark(ui, "time/restart");
    stepControls(ui);

    constexpr double kShownSeconds = 10;  // the slider ends at a multiple of this
    double time = clock.time();
    const double end = std::max(kShownSeconds, std::ceil(time / kShownSeconds) * kShownSeconds);
    fieldLabel("Seconds");
    if (labelledSlider(ui, "##seconds", "time/scrub", {0, end}, time, " s")) clock.pauseAt(time);
    double speed = clock.speed();
    constexpr double kFastest = 4;
    fieldLabel("Speed");
    if (labelledSlider(ui, "##speed", "time/speed", {-kFastest, kFastest}, speed, " x"))
        clock.setSpeed(speed);
}

void playOrPause(Ui& ui, Panel& /*panel*/) {
    if (ui.session.usesTime()) ui.session.clock().play(!ui.session.clock().isPlaying());
}

template <int frames>
void stepFrames(Ui& ui, Panel& /*panel*/) {
    if (ui.session.usesTime()) ui.session.clock().step(frames);
}

constexpr auto kTimeKeys = std::to_array<Shortcut>({
    {KeyGroup::time, GLFW_KEY_SPACE, false, "Space", "play or pause", playOrPause},
    {KeyGroup::time, GLFW_KEY_PERIOD, false, ".", "next frame", stepFrames<1>},
    {KeyGroup::time, GLFW_KEY_COMMA, false, ",", "previous frame", stepFrames<-1>},
    {KeyGroup::time, GLFW_KEY_B, false, "B", "pause, and go to the next step",
     [](Ui& ui, Panel&) { ui.session.nextStep(); }},
    // Without a key: for the list of commands.
    {KeyGroup::time, kNoKey, false, "", "restart at 0 seconds; what Once has made begins anew",
     [](Ui& ui, Panel&) { ui.session.restart(); }},
});

// The section "Frame rate": measures the time per frame, pass, dispatch, draw and step.

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

const PanelRow kTimeRow{
    .name = "time", .place = PanelPlace::section, .make = make<Drawn<timePanel>>, .keys = kTimeKeys};

const PanelRow kCostRow{
    .name = "cost", .place = PanelPlace::section, .make = make<CostPanel>, .keys = kCostKeys};

}  // namespace glibra::view
