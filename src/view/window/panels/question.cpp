// The dialog that asks before unsaved text or values would be lost.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "view/edit/example_folders.h"
#include "view/edit/save_values.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

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

}  // namespace

const PanelRow kQuestionRow{
    .name = "question", .place = PanelPlace::floating, .make = make<Drawn<questionDialog>>, .isShared = true};

}  // namespace glibra::view
