#include "view/window/platform/gui.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <iterator>

#include "view/window/platform/input_queue.h"
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

void giveToImGui(const InputQueue& queue, const InputQueue::Frame& frame) {
    ImGuiIO& io = ImGui::GetIO();
    io.ClearInputCharacters();
    for (const unsigned each : frame.characters) io.AddInputCharacter(each);
    const auto isDown = [&](int left, int right) { return queue.isDown(left) || queue.isDown(right); };
    for (int key = 0; key < static_cast<int>(InputQueue::kKeys); ++key) io.KeysDown[key] = queue.isDown(key);
    io.KeyCtrl = isDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = isDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = isDown(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    io.KeySuper = isDown(GLFW_KEY_LEFT_SUPER, GLFW_KEY_RIGHT_SUPER);
    if (frame.mouse) io.MousePos = {static_cast<float>(frame.mouse->x), static_cast<float>(frame.mouse->y)};
    for (unsigned i = 0; i < std::size(io.MouseDown); ++i) io.MouseDown[i] = (frame.buttons >> i & 1U) != 0;
    io.MouseWheel = static_cast<float>(frame.wheel);
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

}  // namespace glibra::view
