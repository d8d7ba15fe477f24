// The tab "Try" of the window "Frame": another state for the chosen draw, which is drawn at once.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <string>

#include "view/debug_view/state_choices.h"
#include "view/window/panels/frame_window.h"
#include "view/window/panels/number_field.h"
#include "view/window/panels/ui.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

/// The next two columns: the key, brighter if another word than that of the scene is tried, and its words.
void label(std::string_view key, bool isTried) {
    ImGui::TableNextColumn();
    ImGui::AlignTextToFramePadding();
    if (isTried) ImGui::PushStyleColor(ImGuiCol_Text, asVector(palette().accent));
    ImGui::TextUnformatted(key.data(), key.data() + key.size());
    if (isTried) ImGui::PopStyleColor();
    ImGui::TableNextColumn();
}

/// True if another word was chosen.
bool chooseWord(Ui& ui, const StateChoice& choice, base::RasterState& state) {
    const std::size_t now = choice.wordOf(state);
    const std::string shown(now < choice.words.size() ? choice.words[now] : "as in the scene");
    const std::string id = "##" + std::string(choice.key);
    ImGui::SetNextItemWidth(105 * ui.shared.scale);
    const bool isOpen = ImGui::BeginCombo(id.c_str(), shown.c_str(), ImGuiComboFlags_HeightLarge);
    mark(ui, "frame/try/{}", choice.key);
    if (!isOpen) return false;
    bool isChosen = false;
    for (std::size_t i = 0; i < choice.words.size(); ++i) {
        if (ImGui::Selectable(std::string(choice.words[i]).c_str(), i == now) && i != now) {
            choice.choose(state, i);
            isChosen = true;
        }
        mark(ui, "frame/try/{}/{}", choice.key, choice.words[i]);
    }
    ImGui::EndCombo();
    return isChosen;
}

bool chooseOffset(Ui& ui, base::RasterState& state) {
    std::array<double, 2> values{state.offsetFactor, state.offsetUnits};
    ImGui::SetNextItemWidth(105 * ui.shared.scale);
    pairEntry(ui, "##offset", values, "%g");
    markPlace(ui, "frame/try/offset");
    // When the user has finished typing.
    if (!ImGui::IsItemDeactivatedAfterEdit()) return false;
    state.offsetFactor = values[0];
    state.offsetUnits = values[1];
    return true;
}

}  // namespace

void frameTrial(Ui& ui, const FrameWindow& window) {
    const FrameItem* item = window.item();
    const plan::PlannedDraw* planned =
        item == nullptr ? nullptr : plannedDraw(ui.session.live().plan(), *item);
    if (planned == nullptr) return ImGui::TextDisabled("Choose a draw to try another state for it.");
    const scene::Draw& draw = ui.session.live().plan().drawOf(*planned);
    const auto known = ui.session.triedStates().find(draw.id);
    const bool isTried = known != ui.session.triedStates().end() && known->second.wanted == *draw.raster;
    const base::RasterState& ofScene = isTried ? known->second.ofScene : *draw.raster;
    base::RasterState wanted = *draw.raster;
    bool isChosen = false;
    const float room = ImGui::GetContentRegionAvail().x;
    const int pairs = std::max(1, static_cast<int>(room / (195 * ui.shared.scale)));
    if (ImGui::BeginTable("try", 2 * pairs, ImGuiTableFlags_SizingFixedFit)) {
        for (const StateChoice& each : stateChoices()) {
            label(each.key, each.wordOf(*draw.raster) != each.wordOf(ofScene));
            isChosen = chooseWord(ui, each, wanted) || isChosen;
        }
        label("offset",
              ofScene.offsetFactor != wanted.offsetFactor || ofScene.offsetUnits != wanted.offsetUnits);
        isChosen = chooseOffset(ui, wanted) || isChosen;
        ImGui::EndTable();
    }
    const std::string statement = stateStatement(ofScene, *draw.raster);
    if (!statement.empty()) {
        ImGui::AlignTextToFramePadding();
        codeText(statement);
        ImGui::SameLine();
        if (smallButton(ui, "Copy", "frame/try/copy",
                        "Copies the statement, to stand before the command that draws"))
            ImGui::SetClipboardText(statement.c_str());
        ImGui::SameLine();
        if (smallButton(ui, "As in the scene", "frame/try/end")) {
            wanted = ofScene;
            isChosen = true;
        }
    }
    // Not before all widgets have read the draw, which is replaced.
    if (isChosen) ui.session.tryState(draw, wanted);
}

}  // namespace glibra::view
