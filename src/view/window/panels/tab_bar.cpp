// The tab bar above the picture: one tab per open scene.

#include <fmt/format.h>
#include <imgui.h>

#include <string>

#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

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
    if (isOpen && ImGui::BeginTabBar("scenes", ImGuiTabBarFlags_FittingPolicyScroll)) {
        for (std::size_t i = 0; i < ui.shared.tabs.size(); ++i) {
            const TabTitle& each = ui.shared.tabs[i];
            ImGuiTabItemFlags flags = each.isUnsaved ? ImGuiTabItemFlags_UnsavedDocument : 0;
            const bool isShown = i == ui.shared.shownTab;
            if (ui.shared.tabChanged && isShown) flags |= ImGuiTabItemFlags_SetSelected;
            bool stays = true;
            if (each.hasError) ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().error));
            const bool isChosen =
                ImGui::BeginTabItem(fmt::format("{}###{}", each.label, each.id).c_str(), &stays, flags);
            if (each.hasError) ImGui::PopStyleColor();
            mark(ui, "tab/{}", i);
            if (ImGui::IsItemHovered() && !each.path.empty()) ImGui::SetTooltip("%s", each.path.c_str());
            if (isChosen) ImGui::EndTabItem();
            if (isChosen && !isShown && !ui.shared.tabChanged) ui.requests.showTab = i;
            if (!stays) ui.requests.closeTab = i;
        }
        if (ImGui::TabItemButton("+", ImGuiTabItemFlags_Trailing)) openDialog(ui, true);
        mark(ui, "tab/new");
        ui.shared.tabChanged = false;
        ImGui::EndTabBar();
    }
    ImGui::End();
    free[1] += height;
    free[3] -= height;
}

}  // namespace

const PanelRow kTabBarRow{
    .name = "tabs", .place = PanelPlace::edge, .make = make<Drawn<tabBar>>, .isShared = true};

}  // namespace glibra::view
