// The tab "State" of the window "Frame", and what the window reports.

#include <imgui.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <string>

#include "render/draw/view_matrices.h"
#include "view/debug_view/bound_target.h"
#include "view/debug_view/draw_state.h"
#include "view/window/panels/frame_window.h"
#include "view/window/panels/ui.h"
#include "view/window/panels/value_fields.h"
#include "view/window/platform/theme.h"

namespace glibra::view {
namespace {

std::vector<StateLine> linesOf(const Ui& ui, const FrameItem& item) {
    const render::LiveScene& live = ui.session.live();
    const plan::PlannedDraw* draw = plannedDraw(live.plan(), item);
    if (draw == nullptr) return {};
    const scene::NodeList& frame = live.scene().frame;
    const scene::Pass& pass = frame.passes.at(item.step.pass);
    const gpu::TextureSize size = sizeOf(live, pass, ui.look.width(), ui.look.height());
    render::ViewMatrices view = render::isMoved(frame, pass) ? live.view() : live.view().unmoved();
    if (render::isMoved(frame, pass) && pass.shift != glm::dmat4(1)) view = live.view().shifted(pass.shift);
    return stateOf(live.scene(), live.plan(), *draw, view, static_cast<double>(size.width) / size.height);
}

nlohmann::ordered_json json(const PixelState& state) {
    nlohmann::ordered_json made = {{"color", state.color}};
    if (state.depth) made["depth"] = *state.depth;
    if (state.stencil) made["stencil"] = *state.stencil;
    return made;
}

nlohmann::ordered_json pixelJson(const FrameWindow& window) {
    nlohmann::ordered_json events = nlohmann::ordered_json::array();
    for (const PixelEvent& each : window.history.events)
        if (each.item < window.items.size())
            events.push_back({{"item", window.items[each.item].key},
                              {"outcome", std::string(wordsOf(each.outcome))},
                              {"fragments", each.fragments},
                              {"passed", each.passed},
                              {"after", json(each.after)}});
    nlohmann::ordered_json made = {{"x", window.pixel->first},
                                   {"y", window.pixel->second},
                                   {"events", events},
                                   {"problem", window.history.problem}};
    if (!window.probed) return made;
    nlohmann::ordered_json values = nlohmann::ordered_json::object();
    for (const auto* list : {&window.probed->outputs, &window.probed->inputs, &window.probed->uniforms})
        for (const ProbedValue& each : *list) values[each.name] = each.numbers;
    made["probed"] = {{"drawn", window.probed->isDrawn},
                      {"hidden", window.probed->isHidden},
                      {"depth", window.probed->depth},
                      {"values", values}};
    return made;
}

// The tab "Try" of the window "Frame": another state for the chosen draw, which is drawn at once.

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

void frameState(Ui& ui, const FrameWindow& window) {
    const FrameItem* item = window.item();
    const std::vector<StateLine> lines = item != nullptr ? linesOf(ui, *item) : std::vector<StateLine>();
    if (lines.empty()) return ImGui::TextDisabled("Choose a draw to see its state.");
    if (!ImGui::BeginTable("state", 2, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingFixedFit)) return;
    for (const StateLine& each : lines) {
        ImGui::TableNextColumn();
        // What differs from the state at the beginning of a pass is bright.
        if (each.isChanged)
            ImGui::TextUnformatted(each.name.c_str());
        else
            ImGui::TextDisabled("%s", each.name.c_str());
        mark(ui, "frame/state/{}", each.name);
        ImGui::TableNextColumn();
        const bool isMatrix = each.value.find('\n') != std::string::npos;
        if (isMatrix) ImGui::PushFont(codeFont());
        ImGui::TextUnformatted(each.value.c_str());
        if (isMatrix) ImGui::PopFont();
        if (!each.texture) continue;
        ImGui::SameLine();
        ImGui::PushID(each.name.c_str());
        if (ImGui::SmallButton("Show"))
            ui.wanted.inspected = textureKey(ui.session.live().scene(), each.texture);
        mark(ui, "frame/texture/{}", each.name);
        ImGui::PopID();
    }
    ImGui::EndTable();
}

nlohmann::ordered_json frameJson(const Ui& ui, const FrameWindow& window) {
    nlohmann::ordered_json items = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < window.items.size(); ++i) {
        const FrameItem& each = window.items[i];
        nlohmann::ordered_json targets = nlohmann::ordered_json::array();
        for (const FrameTarget& target : each.targets) targets.push_back(target.name);
        items.push_back({{"key", each.key},
                         {"title", each.title},
                         {"line", each.place.line},
                         {"drawn", i < window.isDrawn.size() && window.isDrawn[i]},
                         {"thumbnail", i < window.thumbnails.size() && window.thumbnails[i].has_value()},
                         {"targets", targets}});
    }
    nlohmann::ordered_json made = {{"items", items},
                                   {"chosen", window.chosen},
                                   {"target", window.target},
                                   {"show", std::string(nameOf(window.shows))},
                                   {"problem", window.problem},
                                   {"hovered", window.view.hovered},
                                   {"range", {window.view.display.low, window.view.display.high}}};
    nlohmann::ordered_json tried = nlohmann::ordered_json::array();
    for (const auto& [draw, state] : ui.session.trials().states())
        tried.push_back(stateStatement(state.ofScene, state.wanted));
    made["tried"] = tried;
    made["layer"] = window.layer;
    made["times"] = window.times.milliseconds;
    made["layers"] = window.answer.layers;
    made["layerName"] = window.answer.layerName;
    if (window.answer.content) made["size"] = {window.answer.content->width, window.answer.content->height};
    if (const auto& mask = window.answer.mask)
        made["mask"] = {{"passed", mask->passedPixels}, {"hidden", mask->hiddenPixels}};
    if (window.pixel) made["pixel"] = pixelJson(window);
    nlohmann::ordered_json mesh = nlohmann::ordered_json::array();
    for (const MeshStage& each : window.mesh)
        mesh.push_back({{"title", each.title},
                        {"rows", each.rows},
                        {"corners", each.corners},
                        {"problem", each.problem}});
    if (!mesh.empty()) made["mesh"] = mesh;
    return made;
}

void frameTrial(Ui& ui, const FrameWindow& window) {
    const FrameItem* item = window.item();
    const plan::PlannedDraw* planned =
        item == nullptr ? nullptr : plannedDraw(ui.session.live().plan(), *item);
    if (planned == nullptr) return ImGui::TextDisabled("Choose a draw to try another state for it.");
    const scene::Draw& draw = ui.session.live().plan().drawOf(*planned);
    const auto known = ui.session.trials().states().find(draw.id);
    const bool isTried = known != ui.session.trials().states().end() && known->second.wanted == *draw.raster;
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
