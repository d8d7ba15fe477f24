#include "view/window/panels/probe_window.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

std::string pixelText(const ProbedPixel& pixel) {
    std::string text =
        fmt::format("pixel {}, {}: line {} {}\n", pixel.x, pixel.y, pixel.draw.line, pixel.word);
    const auto add = [&](const char* title, const std::vector<ProbedValue>& values) {
        if (!values.empty()) text += fmt::format("{}\n", title);
        for (const ProbedValue& each : values)
            text += fmt::format("  {} {} = {}\n", each.type, each.name, numbersText(each));
    };
    add("outputs", pixel.outputs);
    add("inputs", pixel.inputs);
    add("uniforms", pixel.uniforms);
    return text;
}

void valueSwatch(const ProbedValue& value) {
    const float side = ImGui::GetTextLineHeight();
    const auto part = [&](std::size_t i) {
        return static_cast<float>(std::clamp(value.numbers[i], 0.0, 1.0));
    };
    const ImVec2 at = ImGui::GetCursorScreenPos();
    ImGui::GetWindowDrawList()->AddRectFilled(at, {at.x + side, at.y + side},
                                              ImGui::ColorConvertFloat4ToU32({part(0), part(1), part(2), 1}));
    ImGui::Dummy({side, side});
    ImGui::SameLine();
}

void table(Ui& ui, const char* title, const std::vector<ProbedValue>& values, bool areColors) {
    if (values.empty() || !ImGui::CollapsingHeader(title, ImGuiTreeNodeFlags_DefaultOpen)) return;
    if (!ImGui::BeginTable(title, 3, ImGuiTableFlags_RowBg)) return;
    // Without these widths the columns fit only some frames after the first.
    const auto widest = [&](auto member) {
        float width = 0;
        for (const ProbedValue& each : values)
            width = std::max(width, ImGui::CalcTextSize((each.*member).c_str()).x);
        return std::ceil(width);
    };
    ImGui::TableSetupColumn("name", ImGuiTableColumnFlags_WidthFixed, widest(&ProbedValue::name));
    ImGui::TableSetupColumn("type", ImGuiTableColumnFlags_WidthFixed, widest(&ProbedValue::type));
    ImGui::TableSetupColumn("value", ImGuiTableColumnFlags_WidthStretch);
    for (const ProbedValue& each : values) {
        ImGui::TableNextColumn();
        ImGui::TextUnformatted(each.name.c_str());
        mark(ui, "probe/" + each.name);
        ImGui::TableNextColumn();
        ImGui::TextDisabled("%s", each.type.c_str());
        mark(ui, "probe/type/{}", each.name);
        ImGui::TableNextColumn();
        if (areColors && each.numbers.size() >= 3 && each.numbers.size() <= 4) valueSwatch(each);
        if (each.numbers.empty())
            ImGui::TextDisabled("%s", each.why.c_str());
        else
            ImGui::TextWrapped("%s", numbersText(each).c_str());
    }
    ImGui::EndTable();
}

/// A ring around the pixel.
void ring(const Ui& ui, const ProbedPixel& pixel) {
    const float perPixel = ui.picture[2] / static_cast<float>(std::max(1, ui.session.width()));
    const ImVec2 at(ui.picture[0] + (static_cast<float>(pixel.x) + .5F) * perPixel,
                    ui.picture[1] + (static_cast<float>(pixel.y) + .5F) * perPixel);
    ImDrawList& draw = *ImGui::GetBackgroundDrawList();
    draw.AddCircle(at, 6 * ui.scale, IM_COL32_BLACK, 0, 3 * ui.scale);
    draw.AddCircle(at, 6 * ui.scale, IM_COL32_WHITE, 0, 1.5F * ui.scale);
}

/// Whenever the window appears it lies over the lower part of the panel, so that it covers no pixel. Without
/// the panel it lies in the corner of the picture.
void place(const Ui& ui) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const float panel = screen.x - ui.room[0] - ui.room[2];
    const bool isOverPanel = ui.showPanel && panel > 0;
    const ImVec2 size(isOverPanel ? panel : std::min(400 * ui.scale, screen.x / 2),
                      std::min(420 * ui.scale, screen.y * (isOverPanel ? .7F : .4F)));
    ImGui::SetNextWindowSizeConstraints({std::min(size.x, 200 * ui.scale), std::min(size.y, 120 * ui.scale)},
                                        screen);
    ImGui::SetNextWindowSize(size, ImGuiCond_Appearing);
    ImGui::SetNextWindowPos(screen, ImGuiCond_Appearing, {1, 1});
}

void probeContent(Ui& ui) {
    const ProbedPixel& pixel = *ui.probe.pixel;
    if (!pixel.isDrawn) {
        ImGui::Text("pixel %d, %d: nothing is drawn here", pixel.x, pixel.y);
        return;
    }
    ImGui::Text("pixel %d, %d, depth %.6g, %s", pixel.x, pixel.y, pixel.depth,
                pixel.isFront ? "front" : "back");
    if (ui.session.isMoving()) {
        ImGui::SameLine();
        ImGui::TextDisabled("at %.2f s", ui.probe.time);
    }
    ImGui::Text("%s in line %d%s%s", pixel.word.c_str(), pixel.draw.line,
                pixel.program.empty() ? "" : ", program ", pixel.program.c_str());
    if (pixel.draw.file == 0) {
        ImGui::SameLine();
        if (ImGui::SmallButton("Show")) showSource(ui, {ui.session.path().string(), pixel.draw.line, 1});
        mark(ui, "probe/show");
    }
    ImGui::SameLine();
    if (ImGui::SmallButton("Copy")) ImGui::SetClipboardText(pixelText(pixel).c_str());
    mark(ui, "probe/copy");
    ImGui::BeginChild("values");
    table(ui, "Outputs", pixel.outputs, true);
    table(ui, "Inputs", pixel.inputs, false);
    table(ui, "Uniforms", pixel.uniforms, false);
    ImGui::EndChild();
}

}  // namespace

void toggleProbe(Ui& ui) {
    ui.probe.isOn = !ui.probe.isOn && ui.session.hasScene();
    ui.probe.pixel.reset();
}

void probeSwitch(Ui& ui) {
    bool isOn = ui.probe.isOn;
    if (ImGui::Checkbox("Probe a pixel", &isOn)) toggleProbe(ui);
    mark(ui, "view/probe");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Click the picture to see the inputs, outputs and uniforms of the fragment (D)");
}

void probeAt(Ui& ui, int x, int y) {
    ui.probe.pixel = ui.session.probe(x, y);
    ui.probe.frame = ui.session.framesDrawn();
    ui.probe.time = ui.session.clock().time();
}

void probeWindow(Ui& ui) {
    if (!ui.probe.isOn) return;
    if (!ui.session.hasScene()) return toggleProbe(ui);
    if (ui.probe.pixel && ui.probe.frame != ui.session.framesDrawn() && !ui.session.isMoving())
        probeAt(ui, ui.probe.pixel->x, ui.probe.pixel->y);
    place(ui);
    if (ImGui::Begin(kProbeWindow, &ui.probe.isOn,
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        const ImVec2 at = ImGui::GetWindowPos();
        const ImVec2 size = ImGui::GetWindowSize();
        if (ui.shared.marksWidgets) ui.widgets["probeWindow"] = {at.x, at.y, size.x, size.y};
        if (ui.probe.pixel)
            probeContent(ui);
        else
            ImGui::TextWrapped("Click a pixel of the picture.");
    }
    ImGui::End();
    if (ui.probe.pixel) ring(ui, *ui.probe.pixel);
}

}  // namespace glibra::view
