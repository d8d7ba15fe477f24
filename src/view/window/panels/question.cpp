// The dialog that asks before unsaved text would be lost.

#include <imgui.h>

#include <string>
#include <utility>

#include "view/window/panels/ui.h"

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
    return {};
}

void discardAll(Ui& ui, const Question& question) {
    for (const std::filesystem::path& each : question.files) ui.shared.sources.erase(each);
}

}  // namespace

void questionDialog(Ui& ui) {
    constexpr const char* kTitle = "Unsaved text";
    if (!ui.shared.question) return;
    if (!ImGui::IsPopupOpen(kTitle)) ImGui::OpenPopup(kTitle);
    const ImVec2 screen = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({screen.x / 2, screen.y / 2}, ImGuiCond_Always, {.5F, .5F});
    if (!ImGui::BeginPopupModal(kTitle, nullptr, ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove))
        return;
    Question& question = *ui.shared.question;
    for (const std::filesystem::path& each : question.files) ImGui::BulletText("%s", each.filename().c_str());
    if (!question.problem.empty()) {
        ImGui::PushTextWrapPos(420 * ui.scale);
        ImGui::TextColored({.95F, .35F, .30F, 1}, "%s", question.problem.c_str());
        ImGui::PopTextWrapPos();
    }
    ImGui::Spacing();
    bool isDone = false;
    bool isConfirmed = false;
    if (ImGui::Button("Save")) {
        question.problem = saveAll(ui, question);
        isDone = isConfirmed = question.problem.empty();
    }
    mark(ui, "question/save");
    ImGui::SameLine();
    if (ImGui::Button("Discard")) {
        discardAll(ui, question);
        isDone = isConfirmed = true;
    }
    mark(ui, "question/discard");
    ImGui::SameLine();
    if (ImGui::Button("Cancel") || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape))) isDone = true;
    mark(ui, "question/cancel");
    if (isDone) {
        ui.shared.answer = Answer{std::move(question), isConfirmed};
        ui.shared.question.reset();
        ImGui::CloseCurrentPopup();
    }
    ImGui::EndPopup();
}

}  // namespace glibra::view
