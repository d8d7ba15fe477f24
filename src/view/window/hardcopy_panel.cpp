#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <string>

#include "view/hardcopy.h"
#include "view/window/ui.h"

namespace glibra::view {
namespace {

void write(Ui& ui, bool asVideo) {
    HardcopyEntries& entries = ui.hardcopy;
    Hardcopy wanted{entries.file.data(), entries.width, entries.height, entries.frames,
                    static_cast<double>(entries.framesPerSecond)};
    const Diagnostics problems =
        asVideo ? writeVideo(ui.context, ui.session, wanted) : writeHardcopy(ui.context, ui.session, wanted);
    entries.failed = hasError(problems);
    if (!entries.failed) {
        entries.message = "written: " + wanted.file.string();
        return;
    }
    const auto error = std::find_if(problems.begin(), problems.end(),
                                    [](const Diagnostic& each) { return each.severity == Severity::error; });
    entries.message = toString(*error);
}

}  // namespace

void hardcopyPanel(Ui& ui) {
    const bool isOpen = ImGui::CollapsingHeader("Hardcopy");
    mark(ui, "hardcopy");
    if (!isOpen) return;
    HardcopyEntries& entries = ui.hardcopy;
    ImGui::PushItemWidth(-ImGui::CalcTextSize("Frames, a second ").x);
    ImGui::InputTextWithHint("File", "picture.png", entries.file.data(), entries.file.size());
    mark(ui, "hardcopy/file");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("The ending decides: .png, .bmp, .exr, .jpg, .tif ...; .mp4 or .webm for a video");
    std::array<int, 2> size{entries.width, entries.height};
    if (ImGui::InputInt2("Size", size.data())) {
        constexpr int kMostPixels = 65536;
        entries.width = std::clamp(size[0], 0, kMostPixels);
        entries.height = std::clamp(size[1], 0, kMostPixels);
    }
    mark(ui, "hardcopy/size");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Pixels; 0: as on the screen (%d x %d)", ui.session.width(), ui.session.height());
    ImGui::InputInt("Frames", &entries.frames, 0);
    entries.frames = std::clamp(entries.frames, 1, 1'000'000);
    mark(ui, "hardcopy/frames");
    ImGui::InputFloat("a second", &entries.framesPerSecond, 0, 0, "%.3g");
    entries.framesPerSecond = std::clamp(entries.framesPerSecond, .001F, 1000.F);
    ImGui::PopItemWidth();
    const std::string ending = std::filesystem::path(entries.file.data()).extension().string();
    const bool asVideo = ending == ".mp4" || ending == ".webm" || ending == ".mkv" || ending == ".avi" ||
                         ending == ".mov" || ending == ".gif";
    ImGui::BeginDisabled(entries.file[0] == 0);
    if (ImGui::Button("Write")) write(ui, asVideo);
    ImGui::EndDisabled();
    mark(ui, "hardcopy/write");
    ImGui::SameLine();
    if (ImGui::Button("Copy command")) {
        const std::string file = entries.file[0] ? entries.file.data() : "picture.png";
        ImGui::SetClipboardText(
            renderCommand(ui.session, {file, entries.width, entries.height, entries.frames,
                                       static_cast<double>(entries.framesPerSecond)})
                .c_str());
    }
    mark(ui, "hardcopy/copy");
    if (!entries.message.empty()) ImGui::TextWrapped("%s", entries.message.c_str());
}

}  // namespace glibra::view
