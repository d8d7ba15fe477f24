// The section "Hardcopy": writes the picture, frames or a video.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "view/export/hardcopy.h"
#include "view/window/panels/ui.h"

namespace glibra::view {
namespace {

void end(HardcopyEntries& entries, const Diagnostics& problems, const std::string& message) {
    const auto error = std::find_if(problems.begin(), problems.end(),
                                    [](const Diagnostic& each) { return each.severity == Severity::error; });
    entries.failed = error != problems.end();
    entries.message = entries.failed ? toString(*error) : message;
    entries.job.reset();
}

void begin(Ui& ui) {
    HardcopyEntries& entries = ui.hardcopy;
    const Hardcopy wanted{entries.file.data(), entries.width, entries.height, entries.frames,
                          static_cast<double>(entries.framesPerSecond)};
    Result<HardcopyJob> job = HardcopyJob::begin(ui.context, ui.session, wanted);
    if (!job) return end(entries, job.diagnostics, {});
    entries.job = std::move(job.value);
    entries.message = "wrote " + wanted.file.string();
    if (const std::string without = ui.session.onlyOnScreen(); !without.empty())
        entries.message += ", without " + without;
    entries.failed = false;
}

/// The progress of a running hardcopy, with a button to stop it.
void progress(Ui& ui) {
    HardcopyEntries& entries = ui.hardcopy;
    const int written = entries.job->framesWritten();
    const int frames = entries.job->wanted().frames;
    if (ImGui::Button("Stop"))
        end(entries, {}, fmt::format("stopped after {} of {} frames", written, frames));
    mark(ui, "hardcopy/stop");
    ImGui::SameLine();
    ImGui::ProgressBar(static_cast<float>(written) / static_cast<float>(frames), {-1, 0},
                       fmt::format("{} of {}", written, frames).c_str());
}

}  // namespace

void continueHardcopy(Ui& ui) {
    HardcopyEntries& entries = ui.hardcopy;
    if (!entries.job) return;
    // Write several small frames at once, but never so many that the window seems to hang.
    constexpr std::chrono::milliseconds kAtOnce{30};
    const auto start = std::chrono::steady_clock::now();
    Diagnostics problems;
    while (!entries.job->isDone() && std::chrono::steady_clock::now() - start < kAtOnce)
        append(problems, entries.job->step());
    if (entries.job->isDone()) end(entries, problems, entries.message);
}

void hardcopyPanel(Ui& ui) {
    const bool isOpen = ImGui::CollapsingHeader("Hardcopy");
    mark(ui, "hardcopy");
    if (!isOpen) return;
    HardcopyEntries& entries = ui.hardcopy;
    ImGui::PushItemWidth(-ImGui::CalcTextSize("Frames per second ").x);
    ImGui::InputTextWithHint("File", "picture.png", entries.file.data(), entries.file.size());
    markField(ui, "hardcopy/file", "File");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip(
            "The extension selects the format: .png, .bmp, .exr, .jpg, .tif ...; .mp4 or .webm for a video");
    std::array<int, 2> size{entries.width, entries.height};
    if (ImGui::InputInt2("Size", size.data())) {
        entries.width = std::clamp(size[0], 0, kLargestPictureSide);
        entries.height = std::clamp(size[1], 0, kLargestPictureSide);
    }
    markField(ui, "hardcopy/size", "Size");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Width and height in pixels; 0: the size on the screen (%d x %d)",
                          ui.session.width(), ui.session.height());
    ImGui::InputInt("Frames", &entries.frames, 0);
    entries.frames = std::clamp(entries.frames, 1, 1'000'000);
    markField(ui, "hardcopy/frames", "Frames");
    ImGui::InputFloat("Frames per second", &entries.framesPerSecond, 0, 0, "%.3g");
    entries.framesPerSecond = std::clamp(entries.framesPerSecond, .001F, 1000.F);
    ImGui::PopItemWidth();
    if (entries.job) return progress(ui);
    ImGui::BeginDisabled(entries.file[0] == 0);
    if (ImGui::Button("Write")) begin(ui);
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
    if (!entries.message.empty() && !entries.job) ImGui::TextWrapped("%s", entries.message.c_str());
}

}  // namespace glibra::view
