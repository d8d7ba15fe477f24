// The window "Verbose": what the scene does, statement by statement, and what was made for it.

#include <imgui.h>

#include <string>

#include "render/stats.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

std::string verboseText(const Session& session) {
    std::string text;
    for (const Diagnostic& each : session.diagnostics())
        if (each.id == "glib-N02") text += std::to_string(each.place.line) + ": " + each.text + "\n";
    return text + "\n" + render::toText(session.live().loadStats());
}

void verboseWindow(Ui& ui, bool& isOpen) {
    if (ui.session.hasScene() && ui.session.isVerbose() != isOpen) {
        ui.session.setVerbose(isOpen);
        ui.requests.reload = true;
    }
    if (!isOpen) return;
    placeFloating(ui, 30, 60, 620, 420);
    if (ImGui::Begin(kVerboseRow.title, &isOpen, ImGuiWindowFlags_NoCollapse)) {
        const std::string text = ui.session.hasScene() ? verboseText(ui.session) : std::string();
        if (button(ui, "Copy", "verbose/copy")) ImGui::SetClipboardText(text.c_str());
        ImGui::BeginChild("text", {0, 0}, true, ImGuiWindowFlags_HorizontalScrollbar);
        ImGui::PushFont(codeFont());
        ImGui::TextUnformatted(text.c_str(), text.c_str() + text.size());
        ImGui::PopFont();
        ImGui::EndChild();
        mark(ui, "verbose/text");
    }
    ImGui::End();
}

}  // namespace

const PanelRow kVerboseRow{.name = "verbose",
                           .place = PanelPlace::floating,
                           .make = make<Drawn<verboseWindow>>,
                           .isShared = true,
                           .title = "Verbose"};

}  // namespace glibra::view
