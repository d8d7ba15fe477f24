#include "view/window/panels/ui.h"

#include <imgui.h>

#include <algorithm>

namespace glibra::view {

void mark(Ui& ui, std::string_view name) {
    if (!ui.shared.marksWidgets || !ImGui::IsItemVisible()) return;
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 size = ImGui::GetItemRectSize();
    ui.widgets[std::string(name)] = {low.x, low.y, size.x, size.y};
}

void markField(Ui& ui, std::string_view name, std::string_view label) {
    mark(ui, name);
    const auto made = ui.widgets.find(std::string(name));
    if (made == ui.widgets.end()) return;
    const float width = ImGui::CalcTextSize(label.data(), label.data() + label.size(), true).x;
    if (width > 0) made->second[2] -= width + ImGui::GetStyle().ItemInnerSpacing.x;
}

namespace {

constexpr float kNarrowestPanel = 240;
constexpr float kWidestPart = .8F;

/// The height of the status line, which stays visible while the sections scroll.
float noticeHeight(const Ui& ui) {
    if (ui.notice.empty()) return 0;
    const ImGuiStyle& style = ImGui::GetStyle();
    return ImGui::CalcTextSize(ui.notice.c_str(), nullptr, false, ImGui::GetContentRegionAvail().x).y +
           3 * style.ItemSpacing.y;
}

/// Returns the panel's width.
float panel(Ui& ui) {
    const ImVec2 window = ImGui::GetIO().DisplaySize;

    const float widest = std::max(1.F, window.x * kWidestPart);
    const float narrowest = std::min(kNarrowestPanel * ui.scale, widest);
    ImGui::SetNextWindowPos({window.x, 0}, ImGuiCond_Always, {1, 0});
    ImGui::SetNextWindowSize({panelWidth(ui), window.y}, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowSizeConstraints({narrowest, window.y}, {widest, window.y});
    if (ImGui::Begin("Controls", nullptr,
                     ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse)) {
        scenePanel(ui);
        ImGui::BeginChild("sections", {0, -noticeHeight(ui)});
        messagesPanel(ui);
        if (ui.session.hasScene()) {
            uniformsPanel(ui);
            keysPanel(ui);
            viewPanel(ui);
            timePanel(ui);
            hardcopyPanel(ui);
            suitePanel(ui);
            costPanel(ui);
        }
        ImGui::EndChild();
        if (!ui.notice.empty()) {
            ImGui::Separator();
            ImGui::TextWrapped("%s", ui.notice.c_str());
        }
    }
    const float width = ImGui::GetWindowWidth();
    ImGui::End();
    ui.settings.panelWidth = width;
    return width;
}

}  // namespace

float panelWidth(const Ui& ui) {
    constexpr float kDefaultWidth = 380;
    return ui.settings.panelWidth > 0 ? ui.settings.panelWidth : kDefaultWidth * ui.scale;
}

void placeFloating(const Ui& ui, float left, float top, float width, float height) {
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    const ImVec2 size(std::min(width * ui.scale, screen.x), std::min(height * ui.scale, screen.y));
    ImGui::SetNextWindowSizeConstraints(
        {std::min(240 * ui.scale, screen.x), std::min(160 * ui.scale, screen.y)}, screen);
    ImGui::SetNextWindowSize(size, ImGuiCond_FirstUseEver);
    ImGui::SetNextWindowPos(
        {std::min(left * ui.scale, screen.x - size.x), std::min(top * ui.scale, screen.y - size.y)},
        ImGuiCond_FirstUseEver);
}

void showAll(Ui& ui) {
    ui.widgets.clear();
    ui.shownTranslation.clear();
    shortcuts(ui);
    const ImVec2 window = ImGui::GetIO().DisplaySize;
    const float width = ui.showPanel ? panel(ui) : 0;
    ui.picture = {0, 0, std::max(1.F, window.x - width), std::max(1.F, window.y)};
    tabBar(ui, ui.picture);
    sourcePanel(ui, ui.picture);
    ui.picture[2] = std::max(1.F, ui.picture[2]);
    ui.picture[3] = std::max(1.F, ui.picture[3]);
    inspectorWindow(ui);
    noiseWindow(ui);
    exampleWindow(ui);
    fileDialog(ui);
    questionDialog(ui);
    helpWindow(ui);
    pictureInput(ui);
    debugViewUnderMouse(ui);
}

}  // namespace glibra::view
