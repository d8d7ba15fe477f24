#include "view/window/panels/debug_view_panel.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "view/scene/window_draws.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

const char* helpOf(DebugView kind) {
    switch (kind) {
        case DebugView::picture:
            return "The rendered picture";
        case DebugView::normals:
            return "Yellow: normals of vertices that only the scene's matrices move. Cyan: the direction "
                   "that each "
                   "triangle faces after all stages. With a geometry stage, colours show that direction.";
        case DebugView::coordinates:
            return "Red: s. Green: t. Blue is added outside 0 to 1. After tessellation and geometry stages, "
                   "this shows "
                   "what the fragment stage gets as vST.";
        case DebugView::facing:
            return "Blue: front side. Orange: back side";
        case DebugView::overdraw:
            return "How many fragments passed the depth test at each pixel, in drawing order";
        case DebugView::layers:
            return "How many surfaces cover each pixel, including hidden ones";
        case DebugView::depth:
            break;
    }
    return "Distance from the eye: white is nearest";
}

void colorSwatch(const std::array<std::uint8_t, 3>& color, const std::string& label) {
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side},
                                              IM_COL32(color[0], color[1], color[2], 255));
    ImGui::Dummy({side, side});
    ImGui::SameLine(0, 3);
    ImGui::TextUnformatted(label.c_str());
}

/// True if the window shows only what a Fill makes of other passes.
bool isFillAlone(const scene::Scene& scene) {
    const std::vector<const scene::Draw*> draws = windowDraws(scene);
    return !draws.empty() &&
           std::all_of(draws.begin(), draws.end(), [](const scene::Draw* each) { return each->isFill; });
}

void legend(const Ui& ui) {
    const DebugView kind = ui.session.debugView();
    const ValueRange range = rangeOf(kind, ui.session.debugNumbers());
    if (range.isEmpty) return;
    if (kind == DebugView::depth) {
        ImGui::TextDisabled("%.4g (white) to %.4g from the eye", range.lowest, range.highest);
    } else if (kind == DebugView::overdraw || kind == DebugView::layers) {
        constexpr int kColors = 8;
        for (int count = 1; count <= kColors; ++count) {
            if (count > 1) ImGui::SameLine(0, 8);
            colorSwatch(colorOfCount(count), std::to_string(count) + (count == kColors ? "+" : ""));
        }
        ImGui::TextDisabled("maximum %g", range.highest);
    }
}

/// The debug view's numbers of the pixel under the mouse.
void debugViewUnderMouse(const Ui& ui, std::string& text) {
    text.clear();
    const TexelImage& numbers = ui.session.debugNumbers();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (numbers.rgba.empty() || ImGui::GetIO().WantCaptureMouse || ui.frame.isDragging ||
        ui.frame.picture[2] <= 0)
        return;
    const float perUnit = static_cast<float>(numbers.width) / ui.frame.picture[2];
    const int x = static_cast<int>((mouse.x - ui.frame.picture[0]) * perUnit);
    const int y = numbers.height - 1 - static_cast<int>((mouse.y - ui.frame.picture[1]) * perUnit);
    if (mouse.x < ui.frame.picture[0] || mouse.y < ui.frame.picture[1] || x >= numbers.width || y < 0) return;
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(numbers.width) +
                                static_cast<std::size_t>(x));
    text = wordsOf(ui.session.debugView(), numbers.rgba.data() + at);
    ImGui::SetTooltip("%s", text.c_str());
}

class DebugViewPanel final : public Panel {
  public:
    void show(Ui& ui) override { debugViewUnderMouse(ui, text_); }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["debugViewText"] = text_;
    }

  private:
    std::string text_;
};

void showNextDebugView(Ui& ui, Panel& /*panel*/) {
    Session& session = ui.session;
    session.setDebugView(
        static_cast<DebugView>((static_cast<int>(session.debugView()) + 1) % kDebugViewCount));
    ui.notice = "Show: " + std::string(nameOf(session.debugView()));
}

constexpr auto kDebugViewKeys = std::to_array<Shortcut>(
    {{KeyGroup::pipeline, GLFW_KEY_V, false, "V",
      "show normals, facing, overdraw, depth ... in place of the picture", showNextDebugView}});

}  // namespace

void debugViewControls(Ui& ui) {
    const DebugView now = ui.session.debugView();
    const bool isOpen = ImGui::BeginCombo("Show", std::string(nameOf(now)).c_str());
    markField(ui, "view/show", "Show");
    if (isOpen) {
        for (int i = 0; i < kDebugViewCount; ++i) {
            const auto kind = static_cast<DebugView>(i);
            const std::string name(nameOf(kind));
            if (ImGui::Selectable(name.c_str(), kind == now)) ui.session.setDebugView(kind);
            mark(ui, "view/show/" + name);
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", helpOf(kind));
        }
        ImGui::EndCombo();
    } else if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
        ImGui::TextUnformatted(helpOf(now));
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
    if (now == DebugView::normals) {
        auto length = static_cast<float>(ui.session.normalLength());
        if (ImGui::SliderFloat("Length", &length, .005F, 1, "%.3f", ImGuiSliderFlags_Logarithmic))
            ui.session.setNormalLength(length);
        markField(ui, "view/normalLength", "Length");
    }
    legend(ui);
    if (now != DebugView::picture && isFillAlone(ui.session.live().scene())) {
        ImGui::TextWrapped("Only a Fill draws into the window. Frame shows this for every pass.");
        if (ImGui::SmallButton("Frame")) toolWindow(ui, "frame").isOpen = true;
        mark(ui, "view/showInFrame");
    }
    ImGui::Checkbox("Probe a pixel", &toolWindow(ui, "probe").isOpen);
    mark(ui, "view/probe");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Click the picture to see the inputs, outputs and uniforms of the fragment (D)");
}

const PanelRow kDebugViewRow{
    .name = "debugView", .place = PanelPlace::picture, .make = make<DebugViewPanel>, .keys = kDebugViewKeys};

}  // namespace glibra::view
