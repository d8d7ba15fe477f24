// What the window offers while it has no scene.

#include <imgui.h>

#include <filesystem>

#include "view/window/panels/file_menu.h"
#include "view/window/panels/recent_scenes.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

void welcome(Ui& ui) {
    if (ui.session.hasScene() || toolWindow(ui, "examples").isOpen) return;
    const Rectangle& room = ui.frame.room;
    // Below the hint that stands in the middle.
    ImGui::SetNextWindowPos(
        {room[0] + room[2] / 2, room[1] + room[3] / 2 + 2 * ImGui::GetTextLineHeightWithSpacing()},
        ImGuiCond_Always, {.5F, 0});
    constexpr ImGuiWindowFlags kFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                        ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                        ImGuiWindowFlags_NoBringToFrontOnFocus |
                                        ImGuiWindowFlags_NoFocusOnAppearing;
    if (ImGui::Begin("##welcome", nullptr, kFlags)) {
        if (button(ui, "New scene...", "welcome/new")) askEmptyScene(ui);
        ImGui::SameLine();
        if (button(ui, "Open...", "welcome/open")) openDialog(ui, false);
        ImGui::SameLine();
        if (button(ui, "Examples", "welcome/examples")) toolWindow(ui, "examples").isOpen = true;
        constexpr std::size_t kMost = 8;
        if (!ui.settings.recent.empty()) ImGui::TextDisabled("Recent scenes");
        const std::filesystem::path chosen = recentScenes(ui, kMost, "welcome/recent", false);
        if (!chosen.empty()) ui.requests.open = chosen;
    }
    ImGui::End();
}

}  // namespace

const PanelRow kWelcomeRow{.name = "welcome", .place = PanelPlace::floating, .make = make<Drawn<welcome>>};

}  // namespace glibra::view
