#include "view/window/platform/theme.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "system/places.h"
#include "system/window.h"

namespace glibra::view {
namespace {

constexpr float kTextPixels = 14;
constexpr float kSmallPixels = 12;
constexpr float kCodePixels = 14;

enum Font { kText, kHeading, kSmall, kCode };

bool isLightTheme = false;

void addFont(const char* name, float pixels) {
    ImGuiIO& io = ImGui::GetIO();
    const std::string file = system::fontFile(name).generic_string();
    if (!file.empty() && io.Fonts->AddFontFromFileTTF(file.c_str(), pixels)) return;
    ImFontConfig config;
    config.SizePixels = pixels;
    io.Fonts->AddFontDefault(&config);
}

}  // namespace

void loadFonts(float scale, float density) {
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    io.FontGlobalScale = 1 / density;
    const float pixels = scale * density;
    addFont("DejaVuSans.ttf", std::round(kTextPixels * pixels));
    addFont("DejaVuSans-Bold.ttf", std::round(kTextPixels * pixels));
    addFont("DejaVuSans.ttf", std::round(kSmallPixels * pixels));
    addFont("DejaVuSansMono.ttf", std::round(kCodePixels * pixels));
}

ImFont* headingFont() {
    return ImGui::GetIO().Fonts->Fonts[kHeading];
}
ImFont* smallFont() {
    return ImGui::GetIO().Fonts->Fonts[kSmall];
}
ImFont* codeFont() {
    return ImGui::GetIO().Fonts->Fonts[kCode];
}

int roomForCode() {
    constexpr int kNumber = 9;                          // width of "     7 | "
    constexpr std::string_view kSample = "0123456789";  // ImGui rounds the width of a single character up
    const float width = ImGui::CalcTextSize(kSample.data()).x / static_cast<float>(kSample.size());
    return static_cast<int>(ImGui::GetContentRegionAvail().x / width) - kNumber;
}

const Palette& palette() {
    return paletteOf(isLightTheme);
}

ImVec4 asVector(const Color& color) {
    return {color.r, color.g, color.b, 1};
}

void applyTheme(bool light, float scale) {
    system::setTitleBars(!light);
    isLightTheme = light;
    const Palette& p = palette();
    ImGuiStyle style;
    if (light)
        ImGui::StyleColorsLight(&style);
    else
        ImGui::StyleColorsDark(&style);
    const std::pair<Color, std::vector<ImGuiCol>> uses[] = {
        {p.text, {ImGuiCol_Text}},
        {p.dim, {ImGuiCol_TextDisabled}},
        {p.panel, {ImGuiCol_WindowBg, ImGuiCol_ScrollbarBg, ImGuiCol_Tab, ImGuiCol_TabUnfocused}},
        {p.popup, {ImGuiCol_PopupBg}},
        {p.section,
         {ImGuiCol_MenuBarBg, ImGuiCol_TitleBg, ImGuiCol_TitleBgActive, ImGuiCol_TitleBgCollapsed,
          ImGuiCol_Header, ImGuiCol_TableHeaderBg}},
        {p.border,
         {ImGuiCol_Border, ImGuiCol_Separator, ImGuiCol_TableBorderStrong, ImGuiCol_TableBorderLight}},
        {p.frame, {ImGuiCol_FrameBg}},
        {p.frameHovered, {ImGuiCol_FrameBgHovered}},
        {p.frameActive, {ImGuiCol_FrameBgActive}},
        {p.button,
         {ImGuiCol_ScrollbarGrab, ImGuiCol_Button, ImGuiCol_ResizeGrip, ImGuiCol_TabActive,
          ImGuiCol_TabUnfocusedActive}},
        {p.buttonHovered, {ImGuiCol_ScrollbarGrabHovered, ImGuiCol_ButtonHovered, ImGuiCol_TabHovered}},
        {p.buttonActive, {ImGuiCol_ScrollbarGrabActive, ImGuiCol_ButtonActive}},
        {p.accent,
         {ImGuiCol_CheckMark, ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_SeparatorHovered,
          ImGuiCol_SeparatorActive, ImGuiCol_ResizeGripHovered, ImGuiCol_ResizeGripActive, ImGuiCol_PlotLines,
          ImGuiCol_NavHighlight}},
        {p.sectionHovered, {ImGuiCol_HeaderHovered}},
        {p.sectionActive, {ImGuiCol_HeaderActive}},
        {p.fill, {ImGuiCol_PlotHistogram, ImGuiCol_PlotHistogramHovered}},
        {p.selection, {ImGuiCol_TextSelectedBg}}};
    for (const auto& [color, elements] : uses)
        for (const ImGuiCol each : elements) style.Colors[each] = asVector(color);
    // Behind a dialog everything is darker, in both themes.
    style.Colors[ImGuiCol_ModalWindowDimBg] = ImVec4(0, 0, 0, light ? .3F : .55F);
    style.WindowPadding = {2 * kSpace, 2 * kSpace};
    style.FramePadding = {2 * kSpace, kSpace};
    style.ItemSpacing = {2 * kSpace, kSpace};
    style.ItemInnerSpacing = {kSpace, kSpace};
    style.CellPadding = {kSpace, .5F * kSpace};
    style.IndentSpacing = 3 * kSpace;
    style.ScrollbarSize = 3 * kSpace;
    style.GrabMinSize = 3 * kSpace;
    style.WindowRounding = 0;
    style.PopupRounding = kSpace;
    style.FrameRounding = kSpace;
    style.GrabRounding = kSpace;
    style.TabRounding = kSpace;
    style.ScrollbarRounding = kSpace;
    style.WindowBorderSize = 1;
    style.PopupBorderSize = 1;
    // White fields on light grey need borders to be visible.
    style.FrameBorderSize = light ? 1.F : 0.F;
    style.WindowTitleAlign = {0, .5F};
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

}  // namespace glibra::view
