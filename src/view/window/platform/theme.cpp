#include "view/window/platform/theme.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui_internal.h>

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

/// Loads the fonts for that scale of texts, and replaces those that were loaded before. `density`: pixels per
/// screen coordinate. Call it between frames; the backend must upload the new texture.
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

const Color& kindColor(SyntaxKind kind) {
    const Palette& p = palette();
    switch (kind) {
        case SyntaxKind::keyword:
            return p.keyword;
        case SyntaxKind::type:
            return p.type;
        case SyntaxKind::number:
            return p.number;
        case SyntaxKind::comment:
            return p.comment;
        case SyntaxKind::directive:
            return p.directive;
        case SyntaxKind::builtin:
            return p.builtin;
        case SyntaxKind::plain:
            break;
    }
    return p.text;
}

}  // namespace

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

ImU32 syntaxColor(SyntaxKind kind) {
    return packed(kindColor(kind));
}

ImU32 tintColor(CodeTint tint) {
    const Tint color = tintOf(tint, palette().panel == paletteOf(true).panel);
    return IM_COL32(color.red, color.green, color.blue, color.alpha);
}

ImU32 packed(const Color& color) {
    return ImGui::ColorConvertFloat4ToU32(asVector(color));
}

const Color& severityColor(Severity severity) {
    if (severity == Severity::note) return palette().text;
    return severity == Severity::error ? palette().error : palette().warning;
}

}  // namespace glibra::view
