#include "view/window/platform/gui.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "view/window/platform/theme.h"

namespace glibra::view {

Gui::Gui(const Display& display, float scale, const Settings& settings) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    // A blinking cursor would need frames while nothing changes.
    ImGui::GetIO().ConfigInputTextCursorBlink = false;
    loadFonts(scale);
    applyTheme(settings.lightTheme, scale);
    ImGui_ImplGlfw_InitForOpenGL(display.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 410 core");
    ImGui::LoadIniSettingsFromMemory(settings.layout.c_str(), settings.layout.size());
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

}  // namespace glibra::view
