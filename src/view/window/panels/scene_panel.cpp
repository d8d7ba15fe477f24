// The buttons at the top of the panel, and the messages about the scene.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "view/edit/external_editor.h"
#include "view/edit/source_lines.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

const ImVec4 kErrorColor{.95F, .35F, .30F, 1};
const ImVec4 kWarningColor{.90F, .65F, .15F, 1};

void message(Ui& ui, const Diagnostic& each, int index) {
    ImGui::PushID(index);
    const bool isError = each.severity == Severity::error;
    if (each.severity != Severity::note)
        ImGui::PushStyleColor(ImGuiCol_Text, isError ? kErrorColor : kWarningColor);
    ImGui::TextWrapped("%s", toString(each).c_str());
    if (each.severity != Severity::note) ImGui::PopStyleColor();
    mark(ui, "message/{}", index);
    if (!each.place.file.empty()) {
        const std::string line = sourceLine(each.place);
        if (!line.empty()) {
            ImGui::PushFont(codeFont());
            const Excerpt shown = excerpt(line, each.place.column, roomForCode());
            ImGui::TextDisabled("%6d | %s", each.place.line, shown.text.c_str());
            ImGui::TextDisabled("       | %s", shown.caret.c_str());
            ImGui::PopFont();
        }
        if (isError && ui.session.hasScene()) translatedLines(ui, each.place);
        if (isError || each.severity == Severity::warning) {
            if (ui.session.hasScene()) {
                if (ImGui::SmallButton("Show")) showSource(ui, each.place);
                mark(ui, "message/{}/show", index);
                ImGui::SameLine();
            }
            if (ImGui::SmallButton("Edit")) ui.notice = openInEditor(each.place);
            mark(ui, "message/{}/edit", index);
            ImGui::SameLine();
        }
    }
    if (ImGui::SmallButton("Copy")) ImGui::SetClipboardText(toString(each).c_str());
    ImGui::PopID();
}

}  // namespace

void scenePanel(Ui& ui) {
    if (ImGui::Button("Open...")) {
        ui.shared.dialog.isWanted = true;
        ui.shared.dialog.inNewTab = false;
    }
    mark(ui, "scene/open");
    ImGui::SameLine();
    if (ImGui::Button("Examples")) ui.shared.examples.isOpen = !ui.shared.examples.isOpen;
    mark(ui, "scene/examples");
    ImGui::SameLine();
    ImGui::BeginDisabled(!ui.session.hasScene());
    if (ImGui::Button("Source")) ui.settings.showSource = !ui.settings.showSource;
    ImGui::EndDisabled();
    mark(ui, "scene/source");
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Edit the scene and its shaders (E)");
    ImGui::SameLine();
    if (ImGui::Button("Reload")) ui.requests.reload = true;
    mark(ui, "scene/reload");
    ImGui::SameLine();
    if (ImGui::Button("?")) ui.showHelp = !ui.showHelp;
    mark(ui, "help");
}

void messagesPanel(Ui& ui) {
    const Diagnostics& all = ui.session.diagnostics();
    const auto count = [&](Severity severity) {
        return std::count_if(all.begin(), all.end(),
                             [&](const Diagnostic& each) { return each.severity == severity; });
    };
    const auto errors = count(Severity::error);
    const auto warnings = count(Severity::warning);
    if (all.empty()) return;
    const auto counted = [](auto number, const char* word) {
        return fmt::format("{} {}{}", number, word, number == 1 ? "" : "s");
    };
    const std::string title =
        errors + warnings == 0
            ? fmt::format("Messages ({})###messages", counted(count(Severity::note), "note"))
            : fmt::format("Messages ({}, {})###messages", counted(errors, "error"),
                          counted(warnings, "warning"));
    if (errors > 0 && ui.lastErrors == 0) ImGui::SetNextItemOpen(true);
    ui.lastErrors = static_cast<int>(errors);
    const bool isOpen = ImGui::CollapsingHeader(title.c_str());
    mark(ui, "messages");
    if (!isOpen) return;
    int index = 0;
    for (const Severity severity : {Severity::error, Severity::warning, Severity::note})
        for (const Diagnostic& each : all)
            if (each.severity == severity) message(ui, each, index++);
}

}  // namespace glibra::view
