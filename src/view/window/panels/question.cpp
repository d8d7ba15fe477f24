// The dialog that asks before unsaved text or values would be lost.

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <string>
#include <utility>

#include "view/browse/example_scenes.h"
#include "view/edit/save_values.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/keys.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

/// Saves all files. Returns the first problem; empty on success.
std::string saveAll(Ui& ui, const Question& question) {
    for (const std::filesystem::path& each : question.files) {
        const auto found = ui.shared.sources.find(each);
        if (found == ui.shared.sources.end()) continue;
        const Diagnostics problems = found->second.save();
        if (!problems.empty()) return toString(problems.front());
        if (found->second.hasConflict())
            return each.filename().string() +
                   " was changed by another program. Press Cancel, then choose in the source panel which "
                   "version "
                   "to keep.";
    }
    for (const UnsavedValues& each : question.values)
        if (const Diagnostics problems = saveValues(each.scene, each.knobs, each.files); !problems.empty())
            return toString(problems.front());
    return {};
}

void discardAll(Ui& ui, const Question& question) {
    for (const std::filesystem::path& each : question.files) ui.shared.sources.erase(each);
}

void questionDialog(Ui& ui) {
    constexpr const char* kTitle = "Not saved";
    if (!ui.shared.question) return;
    if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {.5F, .5F});
    if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
        return;
    Question& question = *ui.shared.question;
    for (const std::filesystem::path& each : question.files) ImGui::BulletText("%s", each.filename().c_str());
    for (const UnsavedValues& each : question.values)
        ImGui::BulletText("the values that you have changed in %s", each.scene.filename().c_str());
    const bool isExampleOnly = std::any_of(question.values.begin(), question.values.end(),
                                           [](const UnsavedValues& each) { return isExample(each.scene); });
    if (!question.problem.empty()) {
        ImGui::PushTextWrapPos(420 * ui.shared.scale);
        ImGui::TextColored(asVector(palette().error), "%s", question.problem.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::Spacing();
    bool isDone = false;
    bool isConfirmed = false;
    bool inNewTab = false;
    if (question.about == Question::About::openScene) {
        if (ImGui::Button("Open in a new tab")) isDone = isConfirmed = inNewTab = true;
        mark(ui, "question/newTab");
        ImGui::SameLine();
    }
    if (!isExampleOnly) {
        if (ImGui::Button("Save")) {
            question.problem = saveAll(ui, question);
            isDone = isConfirmed = question.problem.empty();
        }
        mark(ui, "question/save");
        ImGui::SameLine();
    }
    if (ImGui::Button("Discard")) {
        discardAll(ui, question);
        isDone = isConfirmed = true;
    }
    mark(ui, "question/discard");
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || isKeyPressed(GLFW_KEY_ESCAPE)) {
        isDone = true;
        ui.wanted.keyboardForText = true;
    }
    mark(ui, "question/cancel");
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
