#include "view/window/panels/debug_view_panel.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "view/scene/pick.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_slider.h"

namespace glibra::view {
namespace {

const char* helpOf(DebugView kind) {
    switch (kind) {
        case DebugView::picture:
            return "The rendered picture";
        case DebugView::normals:
            return "Yellow: normals of vertices that only the scene's matrices move. Cyan: the direction "
                   "that each triangle faces after all stages. With a geometry stage, colours show that "
                   "direction.";
        case DebugView::coordinates:
            return "Red: s. Green: t. Blue is added outside 0 to 1. After tessellation and geometry stages, "
                   "this shows what the fragment stage gets as vST.";
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

struct LegendEntry {
    std::optional<std::array<std::uint8_t, 3>> color;
    std::string text;
};

/// What the colours of the view mean.
std::vector<LegendEntry> legendOf(DebugView kind, const ValueRange& range) {
    using Color3 = std::array<std::uint8_t, 3>;
    std::vector<LegendEntry> entries;
    if (kind == DebugView::overdraw || kind == DebugView::layers) {
        if (range.isEmpty) return entries;
        constexpr int kColors = 8;
        for (int count = 1; count <= kColors; ++count)
            entries.push_back({colorOfCount(count), std::to_string(count) + (count == kColors ? "+" : "")});
        entries.push_back({std::nullopt, fmt::format("most: {:g}", range.highest)});
    } else if (kind == DebugView::depth) {
        if (range.isEmpty) return entries;
        entries.push_back({Color3{255, 255, 255}, fmt::format("{:.4g}", range.lowest)});
        entries.push_back({Color3{0, 0, 0}, fmt::format("{:.4g} from the eye", range.highest)});
    } else if (kind == DebugView::facing) {
        entries = {{Color3{70, 130, 220}, "front"}, {Color3{235, 120, 40}, "back"}};
    } else if (kind == DebugView::coordinates) {
        entries = {{Color3{255, 0, 0}, "s"}, {Color3{0, 255, 0}, "t"}, {Color3{0, 0, 255}, "outside 0 to 1"}};
    } else if (kind == DebugView::normals) {
        entries = {{Color3{255, 217, 51}, "normals"}, {Color3{77, 230, 255}, "facing"}};
    }
    return entries;
}

/// True if the window shows only what a Fill makes of other passes.
bool isFillAlone(const scene::Scene& scene) {
    const std::vector<const scene::Draw*> draws = windowDraws(scene);
    return !draws.empty() && std::ranges::all_of(draws, [](const scene::Draw* each) { return each->isFill; });
}

/// The legend on the upper left corner of the picture, as far as it is seen. Returns its text.
std::string drawLegend(const Ui& ui, DebugView kind, const std::vector<LegendEntry>& entries) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float gap = 6 * ui.shared.scale, side = ImGui::GetTextLineHeight();
    std::string text(nameOf(kind));
    float width = ImGui::CalcTextSize(text.c_str()).x + gap;
    for (const LegendEntry& each : entries)
        width += (each.color ? side + gap / 2 : 0) + ImGui::CalcTextSize(each.text.c_str()).x + gap;
    ImVec2 at(std::max(ui.frame.picture[0], ui.frame.covered) + 2 * gap, ui.frame.picture[1] + 2 * gap);
    list.PushClipRect({ui.frame.picture[0], ui.frame.picture[1]},
                      {ui.frame.picture[0] + ui.frame.picture[2], ui.frame.picture[1] + ui.frame.picture[3]});
    list.AddRectFilled({at.x - gap, at.y - gap}, {at.x + width, at.y + side + gap}, IM_COL32(0, 0, 0, 190),
                       gap / 2);
    const auto write = [&](const std::string& words) {
        list.AddText(at, IM_COL32_WHITE, words.c_str());
        at.x += ImGui::CalcTextSize(words.c_str()).x + gap;
    };
    write(text);
    for (const LegendEntry& each : entries) {
        if (each.color) {
            const auto& [red, green, blue] = *each.color;
            list.AddRectFilled(at, {at.x + side, at.y + side}, IM_COL32(red, green, blue, 255));
            list.AddRect(at, {at.x + side, at.y + side}, IM_COL32(255, 255, 255, 90));
            at.x += side + gap / 2;
        }
        write(each.text);
        text += " " + each.text;
    }
    list.PopClipRect();
    return text;
}

/// The debug view's numbers of the pixel under the mouse.
void debugViewUnderMouse(Ui& ui, std::string& text) {
    const std::string before = std::exchange(text, {});
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
    // Its window gets the size of the text one frame later.
    if (text != before) ui.frame.isFollowed = true;
}

class DebugViewPanel final : public Panel {
  public:
    void show(Ui& ui) override { debugViewUnderMouse(ui, text_); }
    void drawOver(Ui& ui) override {
        legend_.clear();
        const DebugView kind = ui.session.debugView();
        if (!ui.session.hasScene() || kind == DebugView::picture) return;
        if (std::exchange(drawn_, ui.session.framesDrawn()) != ui.session.framesDrawn())
            range_ = rangeOf(kind, ui.session.debugNumbers());
        legend_ = drawLegend(ui, kind, legendOf(kind, range_));
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["debugViewText"] = text_;
        state["legend"] = legend_;
    }

  private:
    std::string text_, legend_;
    ValueRange range_;
    std::uint64_t drawn_ = 0;  ///< the frame of `range_`
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
    fieldLabel("Show");
    const bool isOpen = beginCombo(ui, "##show", std::string(nameOf(now)).c_str(), "view/show");
    if (isOpen) {
        for (int i = 0; i < kDebugViewCount; ++i) {
            const auto kind = static_cast<DebugView>(i);
            const std::string name(nameOf(kind));
            if (choice(ui, name.c_str(), kind == now, "view/show/{}", name)) ui.session.setDebugView(kind);
            tooltip(helpOf(kind));
        }
        ImGui::EndCombo();
    } else if (ImGui::IsItemHovered()) {
        wrappedTooltip(helpOf(now), ImGui::GetFontSize() * 24);
    }
    if (now == DebugView::normals) {
        double length = ui.session.normalLength();
        fieldLabel("Length");
        if (labelledSlider(ui, "##length", "view/normalLength", {.005, 1, false, true}, length))
            ui.session.setNormalLength(length);
    }
    if (now != DebugView::picture && isFillAlone(ui.session.live().scene())) {
        ImGui::TextWrapped("Only a Fill draws into the window. Frame shows this for every pass.");
        if (smallButton(ui, "Frame", "view/showInFrame")) toolWindow(ui, "frame").isOpen = true;
    }
    checkBox(ui, "Probe a pixel", "view/probe", toolWindow(ui, "probe").isOpen,
             "Click the picture to see the inputs, outputs and uniforms of the fragment (D)");
}

const PanelRow kDebugViewRow{
    .name = "debugView", .place = PanelPlace::picture, .make = make<DebugViewPanel>, .keys = kDebugViewKeys};

}  // namespace glibra::view
