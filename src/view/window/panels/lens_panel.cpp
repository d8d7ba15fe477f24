// Which view of the pipeline is shown, and what its colours mean.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "view/window/ui.h"

namespace glibra::view {
namespace {

const char* helpOf(Lens lens) {
    switch (lens) {
        case Lens::picture:
            return "The picture, as it is rendered";
        case Lens::normals:
            return "Yellow: normals of vertices that the scene's matrices alone place. Cyan: the direction "
                   "each "
                   "triangle faces, after every stage. Surfaces behind a geometry stage show it as a colour.";
        case Lens::coordinates:
            return "s in red, t in green; blue where they leave 0 to 1. After tessellation and geometry "
                   "stages: "
                   "what reaches the fragment stage as vST";
        case Lens::facing:
            return "Blue: the front is seen. Orange: the back";
        case Lens::overdraw:
            return "How many fragments passed the depth test, one after another, at each pixel";
        case Lens::layers:
            return "How many surfaces lie behind each pixel, hidden ones too";
        case Lens::depth:
            break;
    }
    return "Distance from the eye: white is nearest";
}

void swatch(const std::array<std::uint8_t, 3>& color, const std::string& label) {
    const float side = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side},
                                              IM_COL32(color[0], color[1], color[2], 255));
    ImGui::Dummy({side, side});
    ImGui::SameLine(0, 3);
    ImGui::TextUnformatted(label.c_str());
}

void legend(const Ui& ui) {
    const Lens lens = ui.session.lens();
    const LensRange range = rangeOf(lens, ui.session.lensNumbers());
    if (range.isEmpty) return;
    if (lens == Lens::depth) {
        ImGui::TextDisabled("%.4g (white) to %.4g from the eye", range.lowest, range.highest);
    } else if (lens == Lens::overdraw || lens == Lens::layers) {
        constexpr int kColors = 8;
        for (int count = 1; count <= kColors; ++count) {
            if (count > 1) ImGui::SameLine(0, 8);
            swatch(colorOfCount(count), std::to_string(count) + (count == kColors ? "+" : ""));
        }
        ImGui::TextDisabled("at most %g", range.highest);
    }
}

}  // namespace

void lensControls(Ui& ui) {
    const Lens now = ui.session.lens();
    const bool isOpen = ImGui::BeginCombo("Show", std::string(nameOf(now)).c_str());
    markField(ui, "view/lens", "Show");
    if (isOpen) {
        for (int i = 0; i < kLensCount; ++i) {
            const auto lens = static_cast<Lens>(i);
            const std::string name(nameOf(lens));
            if (ImGui::Selectable(name.c_str(), lens == now)) ui.session.setLens(lens);
            mark(ui, "view/lens/" + name);
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", helpOf(lens));
        }
        ImGui::EndCombo();
    } else if (ImGui::IsItemHovered()) {
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(ImGui::GetFontSize() * 24);
        ImGui::TextUnformatted(helpOf(now));
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }
    if (now == Lens::normals) {
        auto length = static_cast<float>(ui.session.normalLength());
        if (ImGui::SliderFloat("Length", &length, .005F, 1, "%.3f", ImGuiSliderFlags_Logarithmic))
            ui.session.setNormalLength(length);
        markField(ui, "view/normalLength", "Length");
    }
    legend(ui);
}

void nextLens(Ui& ui) {
    ui.session.setLens(static_cast<Lens>((static_cast<int>(ui.session.lens()) + 1) % kLensCount));
}

void lensUnderMouse(Ui& ui) {
    ui.lensWords.clear();
    const TexelImage& numbers = ui.session.lensNumbers();
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    if (numbers.rgba.empty() || ImGui::GetIO().WantCaptureMouse || ui.dragButton >= 0 || ui.picture[2] <= 0)
        return;
    const float perUnit = static_cast<float>(numbers.width) / ui.picture[2];
    const int x = static_cast<int>((mouse.x - ui.picture[0]) * perUnit);
    const int y = numbers.height - 1 - static_cast<int>((mouse.y - ui.picture[1]) * perUnit);
    if (mouse.x < ui.picture[0] || mouse.y < ui.picture[1] || x >= numbers.width || y < 0) return;
    const std::size_t at = 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(numbers.width) +
                                static_cast<std::size_t>(x));
    ui.lensWords = wordsOf(ui.session.lens(), numbers.rgba.data() + at);
    ImGui::SetTooltip("%s", ui.lensWords.c_str());
}

}  // namespace glibra::view
