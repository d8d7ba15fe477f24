#include "view/window/platform/theme.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace glibra::view {
namespace {

constexpr float kFontPixels = 15;
constexpr float kCodePixels = 14;

/// The path of a DejaVu font in the desktop's data folders; empty if it is not installed.
std::string fontFile(const char* name) {
    const char* variable = std::getenv("XDG_DATA_DIRS");
    std::string_view rest = variable && *variable ? variable : "/usr/local/share:/usr/share";
    while (!rest.empty()) {
        const std::string_view folder = rest.substr(0, rest.find(':'));
        const auto file = std::filesystem::path(folder) / "fonts/truetype/dejavu" / name;
        std::error_code failure;
        if (std::filesystem::is_regular_file(file, failure)) return file.string();
        rest.remove_prefix(std::min(rest.size(), folder.size() + 1));
    }
    return {};
}

void addFont(const char* name, float pixels) {
    ImGuiIO& io = ImGui::GetIO();
    const std::string file = fontFile(name);
    if (!file.empty() && io.Fonts->AddFontFromFileTTF(file.c_str(), pixels)) return;
    ImFontConfig config;
    config.SizePixels = pixels;
    io.Fonts->AddFontDefault(&config);
}

}  // namespace

void loadFonts(float scale) {
    addFont("DejaVuSans.ttf", std::round(kFontPixels * scale));
    addFont("DejaVuSansMono.ttf", std::round(kCodePixels * scale));
}

ImFont* codeFont() {
    return ImGui::GetIO().Fonts->Fonts.back();
}

int roomForCode() {
    constexpr int kNumber = 9;                          // width of "     7 | "
    constexpr std::string_view kSample = "0123456789";  // ImGui rounds the width of a single character up
    const float width = ImGui::CalcTextSize(kSample.data()).x / static_cast<float>(kSample.size());
    return static_cast<int>(ImGui::GetContentRegionAvail().x / width) - kNumber;
}

void applyTheme(bool light, float scale) {
    ImGuiStyle style;
    if (light)
        ImGui::StyleColorsLight(&style);
    else
        ImGui::StyleColorsDark(&style);
    for (const int each : {ImGuiCol_WindowBg, ImGuiCol_PopupBg}) style.Colors[each].w = 1;
    style.WindowRounding = 0;
    style.FrameRounding = 3;
    style.GrabRounding = 3;
    style.WindowBorderSize = 0;
    // White fields on light grey need borders to be visible.
    if (light) {
        style.FrameBorderSize = 1;
        style.Colors[ImGuiCol_Border] = ImVec4(.62F, .62F, .62F, 1);
    }
    style.GrabMinSize = 12;
    style.ScaleAllSizes(scale);
    ImGui::GetStyle() = style;
}

}  // namespace glibra::view
