// The tab bar above the picture: one tab per open scene.

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <string>
#include <vector>

#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

/// The room for the names of the tabs: all of it, or equally little for the long ones if the bar is too
/// narrow.
float roomForNames(const Ui& ui, float width) {
    constexpr float kLeast = 48;
    const ImGuiStyle& style = ImGui::GetStyle();
    const float beside = 2 * style.FramePadding.x + style.ItemInnerSpacing.x * 2 + ImGui::GetFontSize() + 2;
    std::vector<float> names;
    for (const TabTitle& each : ui.shared.tabs) names.push_back(ImGui::CalcTextSize(each.label.c_str()).x);
    std::ranges::sort(names);
    float left = width - ImGui::GetFrameHeight() * 2 - beside * static_cast<float>(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        const float share = left / static_cast<float>(names.size() - i);
        if (names[i] > share) return std::max(share, kLeast * ui.shared.scale);
        left -= names[i];
    }
    return names.empty() ? 0 : names.back() + 1;
}

void tabBar(Ui& ui) {
    Rectangle& free = ui.frame.room;
    if (ui.shared.tabs.size() < 2) return;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(4 * ui.shared.scale, 3 * ui.shared.scale));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1, 1));
    const float height = ImGui::GetFrameHeight() + 6 * ui.shared.scale;
    ImGui::SetNextWindowPos({free[0], free[1]});
    ImGui::SetNextWindowSize({free[2], height});
    const bool isOpen = ImGui::Begin(
        "Scenes", nullptr,
        ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
            ImGuiWindowFlags_NoScrollWithMouse | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::PopStyleVar(2);
    // A bar that is new, as after the device was lost, would choose its first tab.
    const bool isGiven = ui.shared.tabChanged || ImGui::IsWindowAppearing();
    if (isOpen && ImGui::BeginTabBar("scenes", ImGuiTabBarFlags_FittingPolicyScroll)) {
        const float room = roomForNames(ui, free[2]);
        for (std::size_t i = 0; i < ui.shared.tabs.size(); ++i) {
            const TabTitle& each = ui.shared.tabs[i];
            ImGuiTabItemFlags flags = each.isUnsaved ? ImGuiTabItemFlags_UnsavedDocument : 0;
            const bool isShown = i == ui.shared.shownTab;
            if (isGiven && isShown) flags |= ImGuiTabItemFlags_SetSelected;
            bool stays = true;
            if (each.hasError) ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().error));
            const bool isChosen = ImGui::BeginTabItem(
                fmt::format("{}###{}", shortened(each.label, room), each.id).c_str(), &stays, flags);
            if (each.hasError) ImGui::PopStyleColor();
            mark(ui, "tab/{}", i);
            if (ImGui::IsItemHovered() && !each.path.empty())
                ImGui::SetTooltip("%s", each.path.generic_string().c_str());
            if (isChosen) ImGui::EndTabItem();
            if (isChosen && !isShown && !isGiven) ui.requests.showTab = i;
            if (!stays) ui.requests.closeTab = i;
        }
        if (ImGui::TabItemButton("+", ImGuiTabItemFlags_Trailing)) openDialog(ui, true);
        mark(ui, "tab/new");
        ui.shared.tabChanged = false;
        // Dear ImGui moves a bar that is too long to the shown tab little by little. Frames are drawn for
        // events only, so the bar would stop halfway, and move on under the mouse later.
        ImGuiTabBar* bar = ImGui::GetCurrentContext()->CurrentTabBar;
        ImGui::EndTabBar();
        bar->ScrollingAnim = bar->ScrollingTarget;
    }
    ImGui::End();
    free[1] += height;
    free[3] -= height;
}

}  // namespace

const PanelRow kTabBarRow{
    .name = "tabs", .place = PanelPlace::edge, .make = make<Drawn<tabBar>>, .isShared = true};

}  // namespace glibra::view
