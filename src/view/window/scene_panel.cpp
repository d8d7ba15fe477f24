// Which scene is shown, and what is wrong with it.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <utility>

#include "view/save_values.h"
#include "view/source_lines.h"
#include "view/window/editor.h"
#include "view/window/ui.h"

namespace glibra::view {
namespace {

const ImVec4 kErrorColor{.95F, .35F, .30F, 1};
const ImVec4 kWarningColor{.90F, .65F, .15F, 1};

void recentMenu(Ui& ui) {
    if (ImGui::Button("Open...") || std::exchange(ui.requests.openMenu, false)) ImGui::OpenPopup("open");
    mark(ui, "scene/open");
    if (!ImGui::BeginPopup("open")) return;
    ImGui::SetNextItemWidth(320 * ui.scale);
    if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
    const bool entered = ImGui::InputTextWithHint("##path", "path of a .glib file", ui.openEntry.data(),
                                                  ui.openEntry.size(), ImGuiInputTextFlags_EnterReturnsTrue);
    mark(ui, "scene/path");
    if (entered && ui.openEntry[0] != 0) {
        ui.requests.open = ui.openEntry.data();
        ImGui::CloseCurrentPopup();
    }
    const auto list = [&](const char* heading, const std::vector<std::string>& files) {
        if (files.empty()) return;
        ImGui::TextDisabled("%s", heading);
        for (const std::string& each : files)
            if (ImGui::Selectable(each.c_str())) ui.requests.open = each;
    };
    list("recent", ui.settings.recent);
    list("in this folder", ui.neighbours);
    ImGui::EndPopup();
}

void message(Ui& ui, const Diagnostic& each, int index) {
    ImGui::PushID(index);
    const bool isError = each.severity == Severity::error;
    if (each.severity != Severity::note)
        ImGui::PushStyleColor(ImGuiCol_Text, isError ? kErrorColor : kWarningColor);
    ImGui::TextWrapped("%s", toString(each).c_str());
    if (each.severity != Severity::note) ImGui::PopStyleColor();
    mark(ui, fmt::format("message/{}", index));
    if (!each.place.file.empty()) {
        const std::string line = sourceLine(each.place);
        if (!line.empty()) {
            ImGui::TextDisabled("%5d | %s", each.place.line, line.c_str());
            ImGui::TextDisabled("      | %s", caretLine(line, each.place.column).c_str());
        }
        if (isError || each.severity == Severity::warning) {
            if (ImGui::SmallButton("Edit")) ui.notice = openInEditor(each.place);
            ImGui::SameLine();
        }
    }
    if (ImGui::SmallButton("Copy")) ImGui::SetClipboardText(toString(each).c_str());
    ImGui::PopID();
}

}  // namespace

void scenePanel(Ui& ui) {
    recentMenu(ui);
    ImGui::SameLine();
    if (ImGui::Button("Reload")) ui.requests.reload = true;
    mark(ui, "scene/reload");
    ImGui::SameLine();
    ImGui::BeginDisabled(!ui.session.hasScene());
    if (ImGui::Button("Save values")) {
        const Diagnostics problems = saveValues(ui.session.path(), ui.session.knobs());
        ui.notice = problems.empty() ? "values saved into " + ui.session.path().filename().string()
                                     : toString(problems.front());
    }
    ImGui::EndDisabled();
    mark(ui, "scene/save");
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("Puts the present values into the Program lines of the .glib file");
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
    const std::string title =
        fmt::format("Messages ({} {}, {} {})###messages", errors, errors == 1 ? "error" : "errors", warnings,
                    warnings == 1 ? "warning" : "warnings");
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
