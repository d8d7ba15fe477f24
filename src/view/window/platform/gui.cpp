#include "view/window/platform/gui.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>

#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

ImVec2ih scaled(const ImVec2ih& size, float by) {
    const auto one = [by](short each) {
        return static_cast<short>(std::clamp(static_cast<float>(each) * by, -32000.F, 32000.F));
    };
    return {one(size.x), one(size.y)};
}

/// Moves and resizes the windows of this and of earlier runs.
void scaleWindows(float by) {
    ImGuiContext& context = *ImGui::GetCurrentContext();
    for (ImGuiWindowSettings* each = context.SettingsWindows.begin(); each != nullptr;
         each = context.SettingsWindows.next_chunk(each)) {
        each->Pos = scaled(each->Pos, by);
        each->Size = scaled(each->Size, by);
    }
    for (ImGuiWindow* each : context.Windows) {
        if ((each->Flags & ImGuiWindowFlags_ChildWindow) != 0) continue;
        ImGui::SetWindowPos(each, {each->Pos.x * by, each->Pos.y * by});
        ImGui::SetWindowSize(each, {each->SizeFull.x * by, each->SizeFull.y * by});
    }
}

}  // namespace

float scaleOf(const Display& display, const Settings& settings) {
    return display.contentScale() / display.density() * settings.zoom;
}

Gui::Gui(const Display& display, float scale, const Settings& settings) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    // A blinking cursor would need frames while nothing changes.
    ImGui::GetIO().ConfigInputTextCursorBlink = false;
    loadFonts(scale, display.density());
    applyTheme(settings.lightTheme, scale);
    ImGui_ImplGlfw_InitForOpenGL(display.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 410 core");
    ImGui::LoadIniSettingsFromMemory(settings.layout.c_str(), settings.layout.size());
    scaleWindows(scale / settings.layoutScale);
}

void Gui::rescale(const Display& display, float from, float to, const Settings& settings) {
    loadFonts(to, display.density());
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    applyTheme(settings.lightTheme, to);
    scaleWindows(to / from);
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

}  // namespace glibra::view
