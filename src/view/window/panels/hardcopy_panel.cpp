// The section "Hardcopy": writes the picture, frames or a film.

#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include "image/video/video_file.h"
#include "system/places.h"
#include "system/process.h"
#include "view/edit/edited_file.h"
#include "view/export/hardcopy.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"
#include "view/window/platform/keys.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// The entries of the section.
struct HardcopyEntries {
    std::array<char, 1024> file{};    ///< a name in the folder of the settings, or a path
    std::string proposed;             ///< what `file` had when a free name was proposed last
    std::string stem;                 ///< of the proposed name, without the number that makes it free
    fs::path scene;                   ///< the scene that the name was proposed for
    int preset = 0;                   ///< of the sizes in the menu
    int width = 1920, height = 1080;  ///< of the preset "other"
    int frames = 1;
    float framesPerSecond = 30;
    std::optional<int> samples;      ///< per pixel; without, as on the screen
    std::optional<HardcopyJob> job;  ///< running now
    std::string message;             ///< the result of the last hardcopy
    std::string note;                ///< what the running one leaves out
    bool failed = false;
    fs::path last;      ///< the first file of the last hardcopy
    bool asks = false;  ///< whether to replace a file
    /// The folder of the settings when the user was asked for another one.
    std::optional<std::string> folderBefore;
};

/// The sizes in the menu; 0 x 0 are those of the window and of the scene, and the last one is typed.
struct Preset {
    const char* name;
    int width, height;
    int times = 1;  ///< of the window's size
};
constexpr std::array kPresets{Preset{"as on the screen", 0, 0, 1}, Preset{"twice the screen", 0, 0, 2},
                              Preset{"as in the scene", 0, 0, 0},  Preset{"800 x 600", 800, 600},
                              Preset{"1280 x 720", 1280, 720},     Preset{"1920 x 1080", 1920, 1080},
                              Preset{"3840 x 2160", 3840, 2160},   Preset{"other", 0, 0, -1}};

std::pair<int, int> sizeOf(const Ui& ui, const HardcopyEntries& entries, std::size_t index) {
    const Preset& preset = kPresets.at(index);
    if (preset.width > 0) return {preset.width, preset.height};
    if (preset.times > 0) return {ui.look.width() * preset.times, ui.look.height() * preset.times};
    if (preset.times < 0) return {entries.width, entries.height};
    const scene::Scene& scene = ui.session.live().scene();
    return {scene.width, scene.height};
}

/// The endings in the menu, and what it calls them.
constexpr std::array kEndings{std::pair{".png", "PNG"},         std::pair{".bmp", "BMP"},
                              std::pair{".jpg", "JPEG"},        std::pair{".tif", "TIFF"},
                              std::pair{".exr", "EXR, floats"}, std::pair{".mp4", "MP4 film"},
                              std::pair{".webm", "WebM film"},  std::pair{".gif", "GIF film"}};

/// The folder of hardcopies: the one that was chosen, else the current one, or the user's own if that must
/// not be written to.
fs::path folderOf(const Settings& settings) {
    std::error_code failure;
    if (const fs::path chosen = settings.hardcopyFolder;
        fs::is_directory(chosen, failure) && !isExample(chosen / "picture.png"))
        return chosen;
    const fs::path current = fs::current_path(failure);
    if (system::mayWrite(current) && !isExample(current / "picture.png")) return current;
    const fs::path home = system::homeFolder();
    return home.empty() ? current : home;
}

int samplesOfScreen(const Ui& ui) {
    return std::max(1, ui.shared.samples.value_or(ui.settings.samples));
}

Hardcopy wanted(const Ui& ui, const HardcopyEntries& entries) {
    const auto [width, height] = sizeOf(ui, entries, static_cast<std::size_t>(entries.preset));
    return {folderOf(ui.settings) / entries.file.data(),
            width,
            height,
            entries.frames,
            static_cast<double>(entries.framesPerSecond),
            entries.samples.value_or(samplesOfScreen(ui))};
}

/// Puts the path of a free name into the entry: the name alone if it is in the folder of hardcopies.
void proposeFile(Ui& ui, HardcopyEntries& entries, const fs::path& file) {
    const bool isHere = file.parent_path() == folderOf(ui.settings);
    entries.proposed = isHere ? file.filename().generic_string() : file.generic_string();
    setField(entries.file, entries.proposed);
}

/// Proposes a name for a new scene, and another one if a file has got the proposed name meanwhile.
void proposeIfNeeded(Ui& ui, HardcopyEntries& entries) {
    if (entries.folderBefore && *entries.folderBefore != ui.settings.hardcopyFolder) {
        entries.folderBefore.reset();
        entries.scene.clear();
    }
    if (entries.scene != ui.session.path()) {
        const fs::path ending =
            entries.proposed.empty() ? fs::path(".png") : fs::path(entries.proposed).extension();
        entries.scene = ui.session.path();
        entries.stem = ui.session.path().stem().generic_string();
        Hardcopy first = wanted(ui, entries);
        first.file = folderOf(ui.settings) / (entries.stem + ending.generic_string());
        return proposeFile(ui, entries, freeName(first));
    }
    if (entries.proposed != entries.file.data() || entries.job) return;
    if (const Hardcopy next = wanted(ui, entries); replacesFile(next))
        proposeFile(ui, entries, freeName(next));
}

void endHardcopy(Ui& ui, HardcopyEntries& entries, const Diagnostics& problems, const std::string& message) {
    const auto error = std::ranges::find(problems, Severity::error, &Diagnostic::severity);
    entries.failed = error != problems.end();
    entries.message = entries.failed ? toString(*error) : message;
    if (entries.job && !entries.job->filesWritten().empty()) entries.last = firstFile(entries.job->wanted());
    entries.job.reset();
    ui.notice = {entries.message, entries.failed};
    if (entries.proposed != entries.file.data())
        entries.stem = fs::path(entries.file.data()).stem().generic_string();
    proposeFile(ui, entries, freeName(wanted(ui, entries)));
}

void beginHardcopy(Ui& ui, HardcopyEntries& entries, const Hardcopy& hardcopy) {
    entries.last.clear();
    ui.notice = {};
    entries.note = ui.session.onlyOnScreen();
    if (const Diagnostics problems = writingProblem(hardcopy.file); !problems.empty())
        return endHardcopy(ui, entries, problems, {});
    if (ui.session.isStopped()) {
        ui.notice = {"no hardcopy is written, because the scene is stopped", true};
        return;
    }
    Result<HardcopyJob> job = HardcopyJob::begin(ui.context, ui.session, hardcopy);
    if (!job) return endHardcopy(ui, entries, job.diagnostics, {});
    entries.job = std::move(job.value);
    entries.failed = false;
}

std::string outcome(const HardcopyEntries& entries) {
    const std::string files = entries.job->filesWritten();
    std::string text = files.empty() ? "nothing was written" : "written: " + files;
    if (!entries.note.empty()) text += ", without " + entries.note;
    return text;
}

/// The progress of a running hardcopy, with a button to stop it.
void progress(Ui& ui, HardcopyEntries& entries) {
    const int written = entries.job->framesWritten();
    const int frames = entries.job->wanted().frames;
    const bool isStopped = button(ui, "Stop", "hardcopy/stop");
    ImGui::SameLine();
    ImGui::ProgressBar(static_cast<float>(written) / static_cast<float>(frames), {-1, 0},
                       fmt::format("{} of {}", written, frames).c_str());
    if (isStopped)
        endHardcopy(ui, entries, {},
                    fmt::format("stopped after {} of {} frames; {}", written, frames, outcome(entries)));
}

/// Changes the ending of the name. A film gets the frames of one period of Timer; a picture is one frame.
void setEnding(Ui& ui, HardcopyEntries& entries, const char* ending) {
    const bool wasFilm = image::holdsAnimation(entries.file.data());
    Hardcopy next = wanted(ui, entries);
    // A proposed name may need no number with the other ending.
    if (entries.proposed == entries.file.data() && !entries.stem.empty())
        next.file.replace_filename(entries.stem + ending);
    else
        next.file.replace_extension(ending);
    const bool isFilm = image::holdsAnimation(next.file);
    constexpr double kSeconds = 10;  // the usual period of Timer
    if (isFilm && entries.frames == 1)
        entries.frames =
            static_cast<int>(std::lround(kSeconds * static_cast<double>(entries.framesPerSecond)));
    if (wasFilm && !isFilm) entries.frames = 1;
    next.frames = entries.frames;
    proposeFile(ui, entries, freeName(next));
}

void fileEntry(Ui& ui, HardcopyEntries& entries) {
    fieldLabel("File");
    ImGui::InputTextWithHint("##file", "picture.png", entries.file.data(), entries.file.size(),
                             ImGuiInputTextFlags_AutoSelectAll);
    mark(ui, "hardcopy/file");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", wanted(ui, entries).file.generic_string().c_str());
    const std::string ending = fs::path(entries.file.data()).extension().generic_string();
    const auto* known = std::ranges::find(kEndings, ending, [](const auto& each) { return each.first; });
    fieldLabel("Format");
    if (ImGui::BeginCombo("##format", known == kEndings.end() ? ending.c_str() : known->second)) {
        for (const auto& [other, name] : kEndings)
            if (choice(ui, name, ending == other, "hardcopy/format/{}", other + 1))
                setEnding(ui, entries, other);
        ImGui::EndCombo();
    }
    mark(ui, "hardcopy/format");
    const fs::path folder = folderOf(ui.settings);
    if (button(ui, "Folder...", "hardcopy/folder")) {
        entries.folderBefore = ui.settings.hardcopyFolder;
        askForFile(ui,
                   {.kind = FileQuestion::Kind::folder,
                    .title = "The folder of hardcopies",
                    .button = "Use this folder",
                    .chosen =
                        [](Ui& in, const fs::path& chosen) {
                            std::error_code failure;
                            fs::create_directories(chosen, failure);
                            in.settings.hardcopyFolder = chosen.generic_string();
                            return std::string();
                        }},
                   folder);
    }
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    ImGui::TextDisabled("%s", folder.generic_string().c_str());
    tooltip(folder.generic_string().c_str());
}

void sizeEntry(Ui& ui, HardcopyEntries& entries) {
    const auto labelOf = [&](std::size_t index) {
        const auto [width, height] = sizeOf(ui, entries, index);
        const Preset& preset = kPresets.at(index);
        if (preset.times < 0) return std::string("another size");
        return preset.width > 0 ? std::string(preset.name)
                                : fmt::format("{} x {} ({})", width, height, preset.name);
    };
    fieldLabel("Pixels");
    if (ImGui::BeginCombo("##size", labelOf(static_cast<std::size_t>(entries.preset)).c_str())) {
        for (std::size_t i = 0; i < kPresets.size(); ++i)
            if (choice(ui, labelOf(i).c_str(), static_cast<int>(i) == entries.preset, "hardcopy/size/{}",
                       kPresets.at(i).name))
                entries.preset = static_cast<int>(i);
        ImGui::EndCombo();
    }
    mark(ui, "hardcopy/size");
    if (kPresets.at(static_cast<std::size_t>(entries.preset)).times >= 0) return;
    fieldLabel("");
    sidesEntry(ui, "##pixels", entries.width, entries.height, kLargestPictureSide);
    markPlace(ui, "hardcopy/pixels");
}

void samplesEntry(Ui& ui, HardcopyEntries& entries) {
    const auto labelOf = [](int samples) {
        return samples <= 1 ? std::string("one sample") : fmt::format("{} samples", samples);
    };
    const std::string screen = labelOf(samplesOfScreen(ui)) + " (as on the screen)";
    fieldLabel("Smooth");
    if (ImGui::BeginCombo("##smooth", entries.samples ? labelOf(*entries.samples).c_str() : screen.c_str())) {
        if (ImGui::Selectable(screen.c_str(), !entries.samples)) entries.samples.reset();
        mark(ui, "hardcopy/samples/screen");
        for (int samples = 1; samples <= ui.context.capabilities().maxSamples; samples *= 2)
            if (choice(ui, labelOf(samples).c_str(), entries.samples == samples, "hardcopy/samples/{}",
                       samples))
                entries.samples = samples;
        ImGui::EndCombo();
    }
    mark(ui, "hardcopy/samples");
    tooltip("Samples per pixel, which make edges smooth: `glibra render --samples`");
}

void framesEntry(Ui& ui, HardcopyEntries& entries) {
    fieldLabel("Frames");
    wholeEntry("##frames", entries.frames, 1, 1'000'000);
    mark(ui, "hardcopy/frames");
    if (entries.frames == 1 && !image::holdsAnimation(entries.file.data())) return;
    fieldLabel("Per second");
    double rate = entries.framesPerSecond;
    if (numberEntry("##rate", rate, "%.5g"))
        entries.framesPerSecond = std::clamp(static_cast<float>(rate), .001F, 1000.F);
    mark(ui, "hardcopy/rate");
    ImGui::TextDisabled("%.3g seconds, from %.3g s on",
                        entries.frames / static_cast<double>(entries.framesPerSecond),
                        ui.session.clock().time());
}

void labelsEntry(Ui& ui) {
    constexpr std::array kCorners{std::pair{LabelCorner::bottomLeft, "bottom left"},
                                  std::pair{LabelCorner::bottomRight, "bottom right"},
                                  std::pair{LabelCorner::topLeft, "top left"},
                                  std::pair{LabelCorner::topRight, "top right"}};
    const auto* chosen =
        std::ranges::find(kCorners, ui.settings.labelCorner, [](const auto& each) { return each.first; });
    const char* label = !ui.shared.showLabels ? "none" : chosen == kCorners.end() ? "" : chosen->second;
    fieldLabel("Labels");
    if (ImGui::BeginCombo("##corner", label)) {
        if (ImGui::Selectable("none", !ui.shared.showLabels)) ui.shared.showLabels = false;
        mark(ui, "hardcopy/labels/none");
        for (const auto& [corner, name] : kCorners)
            if (choice(ui, name, ui.shared.showLabels && corner == ui.settings.labelCorner,
                       "hardcopy/labels/{}", name)) {
                ui.shared.showLabels = true;
                ui.settings.labelCorner = corner;
            }
        ImGui::EndCombo();
    }
    mark(ui, "hardcopy/labels");
    tooltip("The values over the picture, on the screen and in the file (L)");
    if (!ui.shared.showLabels) return;
    fieldLabel("");
    labelChoice(ui, "##labelled", "hardcopy/labelChoice", -1);
}

/// Asks whether to replace a file.
void replaceDialog(Ui& ui, HardcopyEntries& entries) {
    constexpr const char* kTitle = "Replace the file?";
    if (std::exchange(entries.asks, false)) ImGui::OpenPopup(kTitle);
    if (!beginModal(kTitle)) return;
    const Hardcopy next = wanted(ui, entries);
    const fs::path other = freeName(next);
    ImGui::Text("%s exists.", firstFile(next).filename().generic_string().c_str());
    ImGui::Spacing();
    bool isDone = button(ui, "Replace", "hardcopy/replace");
    if (isDone) beginHardcopy(ui, entries, next);
    ImGui::SameLine();
    if (button(ui, ("Write " + other.filename().generic_string()).c_str(), "hardcopy/other")) {
        proposeFile(ui, entries, other);
        beginHardcopy(ui, entries, wanted(ui, entries));
        isDone = true;
    }
    ImGui::SameLine();
    if (button(ui, "Cancel", "hardcopy/cancel") || isKeyPressed(GLFW_KEY_ESCAPE)) isDone = true;
    if (isDone) ImGui::CloseCurrentPopup();
    ImGui::EndPopup();
}

/// A button for what was written last; the status line names it.
void showLast(Ui& ui, HardcopyEntries& entries) {
    if (entries.failed || entries.last.empty()) return;
    continueRowForButton("Show the file");
    if (button(ui, "Show the file", "hardcopy/show"))
        if (const std::string why = system::openForUser(entries.last); !why.empty())
            ui.notice = {"cannot start 'xdg-open': " + why, true};
}

/// Begins a hardcopy with the entries, to the next name that is free.
void writeHardcopy(Ui& ui, HardcopyEntries& entries) {
    if (!ui.session.hasScene() || entries.job) return;
    if (entries.file[0] == 0) entries.scene.clear();
    proposeIfNeeded(ui, entries);
    proposeFile(ui, entries, freeName(wanted(ui, entries)));
    beginHardcopy(ui, entries, wanted(ui, entries));
}

/// Writes the next frames of a running hardcopy.
void continueHardcopy(Ui& ui, HardcopyEntries& entries) {
    if (!entries.job) return;
    // Write several small frames at once, but never so many that the window seems to hang.
    constexpr std::chrono::milliseconds kAtOnce{30};
    const auto start = std::chrono::steady_clock::now();
    Diagnostics problems;
    while (!entries.job->isDone() && std::chrono::steady_clock::now() - start < kAtOnce)
        append(problems, entries.job->step());
    if (!entries.job->isDone()) return;
    endHardcopy(ui, entries, problems, outcome(entries));
}

void copyCommand(const Ui& ui, const Hardcopy& hardcopy) {
    ImGui::SetClipboardText(renderCommand(ui.session, hardcopy).c_str());
}

void hardcopyPanel(Ui& ui, HardcopyEntries& entries) {
    replaceDialog(ui, entries);
    if (!section(ui, "Hardcopy", "hardcopy", false)) return;
    proposeIfNeeded(ui, entries);
    fileEntry(ui, entries);
    sizeEntry(ui, entries);
    samplesEntry(ui, entries);
    framesEntry(ui, entries);
    labelsEntry(ui);
    if (entries.job) return progress(ui, entries);
    const Hardcopy next = wanted(ui, entries);
    ImGui::BeginDisabled(entries.file[0] == 0);
    if (button(ui, "Write", "hardcopy/write", "Write the file. H writes at once, to a name that is free.")) {
        entries.asks = replacesFile(next);
        if (!entries.asks) beginHardcopy(ui, entries, next);
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (button(ui, "Copy command", "hardcopy/copy")) copyCommand(ui, next);
    showLast(ui, entries);
}

class HardcopyPanel final : public Panel {
  public:
    void work(Ui& ui) override { continueHardcopy(ui, entries_); }
    [[nodiscard]] bool isWorking() const override { return entries_.job.has_value(); }
    void update(Ui& ui) override {
        if (ui.wanted.hardcopy) writeNow(ui);
    }
    void show(Ui& ui) override { hardcopyPanel(ui, entries_); }
    void writeNow(Ui& ui) { writeHardcopy(ui, entries_); }
    void copyNow(Ui& ui) {
        if (!ui.session.hasScene()) return;
        proposeIfNeeded(ui, entries_);
        copyCommand(ui, wanted(ui, entries_));
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["hardcopyMessage"] = entries_.job ? std::string() : entries_.message;
        state["hardcopyFile"] = entries_.file.data();
    }
    void releaseDevice() override { entries_.job.reset(); }

  private:
    HardcopyEntries entries_;
};

constexpr auto kHardcopyKeys = std::to_array<Shortcut>(
    {{KeyGroup::values, GLFW_KEY_H, false, "H", "write a hardcopy, to the next free name",
      call<&HardcopyPanel::writeNow>},
     // Without a key: for the list of commands.
     {KeyGroup::values, kNoKey, false, "", "copy the command of glibra render that writes the hardcopy",
      call<&HardcopyPanel::copyNow>}});

// Adds the current state to a suite as a shot.

/// The entries of the section.
struct SuiteEntries {
    std::filesystem::path scene;  ///< the scene that the proposed entries are for
    std::array<char, 1024> file{};
    std::array<char, 256> name{};
    std::string message;  ///< the result of the last click
    bool failed = false;
};

/// Proposes a suite in the scene's folder, or in one of the user's if the scene is an example, and a name
/// that the suite does not have yet.
void proposeShot(const Ui& ui, SuiteEntries& entries) {
    const Session& session = ui.session;
    if (entries.scene == session.path()) return;
    entries.scene = session.path();
    entries.message.clear();
    setField(entries.file, (ownFolder(ui) / "pictures.toml").generic_string());
    setField(entries.name, freeShotName(entries.file.data(), session));
}

void addShot(const Session& session, SuiteEntries& entries) {
    const std::filesystem::path file = entries.file.data();
    const std::string name = entries.name.data();
    Diagnostics problems = writingProblem(file);
    if (problems.empty()) problems = appendShot(file, name, session);
    entries.failed = !problems.empty();
    entries.message = entries.failed
                          ? toString(problems.front())
                          : fmt::format("added '{}' to {}; `glibra test --update` makes its golden picture",
                                        name, file.filename().generic_string());
    if (const std::string without = session.onlyOnScreen(); !entries.failed && !without.empty())
        entries.message += "; the shot is without " + without;
    if (!entries.failed) setField(entries.name, freeShotName(file, session));
}

void suitePanel(Ui& ui, SuiteEntries& entries) {
    if (!section(ui, "Suite shot", "suite", false)) return;
    proposeShot(ui, entries);
    fieldLabel("Suite");
    ImGui::InputTextWithHint("##suite", "pictures.toml", entries.file.data(), entries.file.size());
    mark(ui, "suite/file");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("A suite file for `glibra test`; it is created if it does not exist\n%s",
                          entries.file.data());
    fieldLabel("Shot");
    ImGui::InputText("##shot", entries.name.data(), entries.name.size());
    mark(ui, "suite/name");
    ImGui::BeginDisabled(entries.file[0] == 0 || entries.name[0] == 0);
    if (ImGui::Button("Add shot")) addShot(ui.session, entries);
    ImGui::EndDisabled();
    mark(ui, "suite/add");
    if (ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))
        ImGui::SetTooltip("Add the current values, time, view and size (%d x %d) as a shot", ui.look.width(),
                          ui.look.height());
    continueRowForButton("Copy as TOML");
    if (button(ui, "Copy as TOML", "suite/copy"))
        ImGui::SetClipboardText(shotText(ui.session, entries.name.data(),
                                         std::filesystem::path(entries.file.data()).parent_path())
                                    .c_str());
    if (!entries.message.empty()) ImGui::TextWrapped("%s", entries.message.c_str());
}

class SuitePanel final : public Panel {
  public:
    void show(Ui& ui) override { suitePanel(ui, entries_); }
    void addNow(Ui& ui) {
        if (!ui.session.hasScene()) return;
        proposeShot(ui, entries_);
        addShot(ui.session, entries_);
        ui.notice = {entries_.message, entries_.failed};
    }
    void addTo(nlohmann::ordered_json& state, const Ui& /*ui*/) const override {
        state["suiteMessage"] = entries_.message;
    }

  private:
    SuiteEntries entries_;
};

// Without a key: for the list of commands.
constexpr auto kSuiteKeys =
    std::to_array<Shortcut>({{KeyGroup::scenes, kNoKey, false, "", "add the picture to a suite, as a shot",
                              call<&SuitePanel::addNow>}});

}  // namespace

const PanelRow kHardcopyRow{
    .name = "hardcopy", .place = PanelPlace::section, .make = make<HardcopyPanel>, .keys = kHardcopyKeys};

const PanelRow kSuiteRow{
    .name = "suite", .place = PanelPlace::section, .make = make<SuitePanel>, .keys = kSuiteKeys};

}  // namespace glibra::view
