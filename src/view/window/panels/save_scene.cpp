#include "view/window/panels/ui.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <iterator>
#include <map>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/text.h"
#include "image/file.h"
#include "system/places.h"
#include "view/edit/edited_file.h"
#include "view/edit/recovery.h"
#include "view/edit/saved_scene.h"
#include "view/edit/source_files.h"
#include "view/session/comparison.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

namespace fs = std::filesystem;

/// The text of the session's scene as it would be saved: with unsaved edits, or else with the values.
Result<std::string> textToSave(const Ui& ui) {
    const fs::path& path = ui.session.path();
    if (const EditedFile* edited = knownSource(ui, path); edited && edited->isChanged())
        return edited->text();
    const auto bytes = image::readFile(path, {path.generic_string(), {path.generic_string(), 1, 1}});
    if (!bytes) return bytes.diagnostics;
    return withValues(
        withFiles({reinterpret_cast<const char*>(bytes->data()), bytes->size()}, ui.session.chosenFiles()),
        ui.values.knobs());
}

/// Returns the problem; empty on success.
std::string save(Ui& ui, fs::path target) {
    if (!target.has_extension()) target += ".glib";
    const Session& session = ui.session;
    const Result<std::string> text = textToSave(ui);
    Diagnostics problems = text.diagnostics;
    if (text) problems = writingProblem(target);
    std::vector<CopiedFile> files;
    if (problems.empty()) {
        files = filesOfCopy(session.live(), target, isExample(session.path()),
                            session.renderOptions().libraryRoots);
        problems = writeCopy(*text, target, files);
        if (problems.empty()) problems = copyExercise(session.path(), target);
    }
    if (!problems.empty()) return problems.front().text;
    ui.notice = "saved " + target.generic_string();
    if (!files.empty()) ui.notice.text += " and " + base::counted(files.size(), "file") + " that it reads";
    ui.requests.open = target;
    ui.requests.inNewTab = true;
    return {};
}

// The dialog that asks before unsaved text or values would be lost.

/// Saves all files. Returns the first problem; empty on success.
std::string saveAll(Ui& ui, const Question& question) {
    // The values first: their places are those in the files as they are now.
    for (const UnsavedValues& each : question.values)
        if (const Diagnostics problems =
                saveValues(each.scene, each.knobs, each.files, knownSource(ui, each.scene));
            !problems.empty())
            return toString(problems.front());
    for (const std::filesystem::path& each : question.files) {
        EditedFile* file = knownSource(ui, each);
        if (!file) continue;
        if (const Diagnostics problems = file->save(); !problems.empty()) return toString(problems.front());
        if (file->hasConflict())
            return each.filename().generic_string() +
                   " was changed by another program. Press Cancel, then choose in the source panel which "
                   "version to keep.";
    }
    return {};
}

void questionDialog(Ui& ui) {
    constexpr const char* kTitle = "Not saved";
    if (!ui.shared.question) return;
    if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
    if (!beginModal(kTitle)) return;
    Question& question = *ui.shared.question;
    for (const std::filesystem::path& each : question.files)
        ImGui::BulletText("%s", each.filename().generic_string().c_str());
    for (const UnsavedValues& each : question.values)
        ImGui::BulletText("the values that you have changed in %s",
                          each.scene.filename().generic_string().c_str());
    const bool isExampleOnly =
        std::ranges::any_of(question.values, [](const UnsavedValues& each) { return isExample(each.scene); });
    if (!question.problem.empty()) {
        ImGui::PushTextWrapPos(420 * ui.shared.scale);
        ImGui::TextColored(asVector(palette().error), "%s", question.problem.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::Spacing();
    bool isDone = false, isConfirmed = false, inNewTab = false;
    if (question.about == Question::About::openScene) {
        if (button(ui, "Open in a new tab", "question/newTab")) isDone = isConfirmed = inNewTab = true;
        ImGui::SameLine();
    }
    if (!isExampleOnly) {
        if (button(ui, "Save", "question/save")) {
            question.problem = saveAll(ui, question);
            isDone = isConfirmed = question.problem.empty();
        }
        ImGui::SameLine();
    }
    if (button(ui, "Discard", "question/discard")) {
        for (const std::filesystem::path& each : question.files) ui.shared.sources.erase(each);
        isDone = isConfirmed = true;
    }
    ImGui::SameLine();
    if (button(ui, "Cancel", "question/cancel") || isKeyPressed(GLFW_KEY_ESCAPE))
        isDone = ui.wanted.keyboardForText = true;
    if (isDone) {
        ui.shared.answer = Answer{std::move(question), isConfirmed, inNewTab};
        ui.shared.question.reset();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

// Keeps the texts that are not saved in files (edit/recovery.h), and offers them when their scene is opened
// again after the program has ended unexpectedly.

constexpr double kBetweenWrites = .3;  ///< seconds

class RecoveryPanel final : public Panel {
  public:
    void work(Ui& ui) override {
        offer(ui);
        SafetyCopies& copies = ui.shared.copies;
        for (auto known = kept_.begin(); known != kept_.end();) {
            const auto source = ui.shared.sources.find(known->first);
            const bool isThere = source != ui.shared.sources.end() && source->second.isChanged();
            if (!isThere) copies.forget(known->first);
            known = isThere ? std::next(known) : kept_.erase(known);
        }
        isWaiting_ = false;
        const double now = ImGui::GetTime();
        for (const auto& [path, source] : ui.shared.sources) {
            if (!source.isChanged()) continue;
            Kept& kept = kept_[path];
            // Somebody may have removed the copy.
            if (kept.text == source.text() && copies.isKept(path)) continue;
            if (now - kept.at < kBetweenWrites) {
                isWaiting_ = true;
                continue;
            }
            kept = {source.text(), now};
            copies.keep(path, kept.text);
        }
    }
    [[nodiscard]] bool isWorking() const override { return isWaiting_; }

  private:
    /// Looks for texts of a scene that was loaded.
    void offer(Ui& ui) {
        if (!ui.session.hasScene()) return;
        auto& loaded = loaded_[&ui.session];
        if (std::exchange(loaded, ui.session.timesLoaded()) == ui.session.timesLoaded()) return;
        for (const SourceFile& each : sourceFiles(ui.session.live())) {
            if (kept_.contains(each.path) || ui.shared.recovered.contains(each.path)) continue;
            SafetyCopies::Others others = ui.shared.copies.othersOf(each.path);
            if (others.isOpen && told_.insert(each.path).second)
                ui.notice = "another window has text of " + each.path.filename().generic_string() +
                            " that is not saved; it is not in this window";
            if (!others.left) continue;
            if (const EditedFile file(each.path);
                file.text() == others.left->text || !file.whyReadOnly().empty()) {
                SafetyCopies::remove(*others.left);
                continue;
            }
            ui.shared.recovered.insert_or_assign(each.path, std::move(*others.left));
            showSource(ui, {each.path.generic_string(), 1, 1});
        }
    }

    struct Kept {
        std::string text;
        double at = -1;  ///< ImGui::GetTime() of the last writing
    };
    std::map<std::filesystem::path, Kept> kept_;
    std::map<const Session*, std::uint64_t> loaded_;
    std::set<std::filesystem::path> told_;  ///< that other windows have text of these
    bool isWaiting_ = false;
};

}  // namespace

fs::path ownFolder(const Ui& ui) {
    if (ui.session.hasScene() && !isExample(ui.session.path())) return ui.session.path().parent_path();
    std::error_code failure;
    for (const std::string& each : ui.settings.recent)
        if (const fs::path folder = fs::path(each).parent_path();
            !isExample(each) && fs::is_directory(folder, failure))
            return folder;
    if (const fs::path here = fs::current_path(failure);
        !here.empty() && here != "/" && !isExample(here / "x"))
        return here;
    const fs::path home = system::homeFolder();
    return home.empty() ? "." : home;
}

void saveScene(Ui& ui) {
    if (!ui.session.hasScene()) return;
    if (isExample(ui.session.path())) return saveSceneAs(ui);
    const Diagnostics problems = saveValues(ui.session.path(), ui.values.knobs(), ui.session.chosenFiles(),
                                            knownSource(ui, ui.session.path()));
    if (!problems.empty()) {
        ui.notice = problems.front();
        return;
    }
    ui.notice = "saved the values in " + ui.session.path().filename().generic_string();
    ui.session.forgetChosenFiles();
}

void saveSceneAs(Ui& ui) {
    if (!ui.session.hasScene()) return;
    const bool isCopy = isExample(ui.session.path());
    const std::string name = ui.session.path().filename().generic_string();
    askForFile(
        ui,
        {.kind = FileQuestion::Kind::save,
         .title = (isCopy ? "Save a copy of " : "Save as: ") + name,
         .button = "Save",
         .hint = isCopy ? "Examples stay as they are. The copy gets your values, and the shaders and "
                          "other files of the scene are copied into its folder."
                        : "The scene with its values. Files that it would not find there are copied, too.",
         .endings = ".glib",
         .entry = name,
         .chosen = save},
        ownFolder(ui));
}

const PanelRow kQuestionRow{
    .name = "question", .place = PanelPlace::floating, .make = make<Drawn<questionDialog>>, .isShared = true};

const PanelRow kRecoveryRow{
    .name = "recovery", .place = PanelPlace::floating, .make = make<RecoveryPanel>, .isShared = true};

}  // namespace glibra::view
