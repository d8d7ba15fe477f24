#include "view/window/panels_json.h"

#include <imgui.h>

#include <algorithm>

namespace glibra::view {

void addPanels(nlohmann::ordered_json& state, const Ui& ui) {
    using Json = nlohmann::ordered_json;
    Json tabs = Json::array();
    for (const TabTitle& each : ui.shared.tabs)
        tabs.push_back({{"label", each.label}, {"path", each.path}, {"unsaved", each.isUnsaved}});
    state["tabs"] = tabs;
    state["shownTab"] = ui.shared.shownTab;
    const SourceState& source = ui.sourceState;
    state["source"] = {{"shown", !source.file.empty()},
                       {"file", source.file},
                       {"line", source.line},
                       {"column", source.column},
                       {"active", source.isActive},
                       {"changed", source.isChanged},
                       {"conflict", source.hasConflict},
                       {"translation", ui.shownTranslation}};
    if (const FindBar& find = ui.source.find; find.isOpen)
        state["find"] = {{"words", find.words.data()},
                         {"replaces", find.replaces},
                         {"count", find.found.size()},
                         {"shown", find.shown}};
    const ExampleBrowser& examples = ui.shared.examples;
    const auto pictures = std::count_if(
        examples.tiles.begin(), examples.tiles.end(),
        [](const ExampleBrowser::Tile& each) { return each.thumbnail.state == Thumbnail::State::ready; });
    state["examples"] = {{"open", examples.isOpen},
                         {"scenes", examples.tiles.size()},
                         {"pictures", pictures},
                         {"drawing", examples.maker != nullptr}};
    state["folder"] = ui.shared.dialog.list.folder.string();
    state["question"] = ui.shared.question.has_value();
    state["takesText"] = ImGui::GetIO().WantTextInput;
    state["suiteMessage"] = ui.suite.message;
    state["lensWords"] = ui.lensWords;
    if (const NoiseWindow& noise = ui.shared.noise; noise.isOpen)
        state["noise"] = {{"command", noise::noiseCommand(noise.noise, noise.file.data())},
                          {"point", noise.chosen},
                          {"message", noise.message}};
    if (!ui.cost) return;
    Json passes = Json::array();
    for (const PassCost& each : ui.cost->passes)
        passes.push_back({{"target", each.target}, {"milliseconds", each.milliseconds}});
    state["cost"] = {
        {"frames", ui.cost->frames}, {"milliseconds", ui.cost->millisecondsAFrame}, {"passes", passes}};
}

}  // namespace glibra::view
