#include "view/window/window_json.h"

#include <imgui.h>

#include <algorithm>
#include <ctime>
#include <nlohmann/json.hpp>

#include "view/session/state_json.h"

namespace glibra::view {
namespace {

using Json = nlohmann::ordered_json;

double cpuSeconds() {
    constexpr double kSecondsPerNanosecond = 1e-9;
    timespec cpu{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
    return static_cast<double>(cpu.tv_sec) + static_cast<double>(cpu.tv_nsec) * kSecondsPerNanosecond;
}

void addLoop(Json& state, const LoopState& loop) {
    state["window"] = {loop.windowSize.first, loop.windowSize.second};
    state["framesPresented"] = loop.framesPresented;
    state["reloads"] = loop.reloads;
    state["loadMilliseconds"] = loop.loadMilliseconds;
    state["firstDrawMilliseconds"] = loop.firstDrawMilliseconds;
    state["editToPictureMilliseconds"] = loop.editToPictureMilliseconds;
    state["refreshRate"] = loop.refreshRate;
    state["swapControl"] = loop.hasSwapControl;
    state["waiting"] = loop.isWaiting;
    state["cpuSeconds"] = cpuSeconds();
}

void addTabs(Json& state, const Shared& shared) {
    Json tabs = Json::array();
    for (const TabTitle& each : shared.tabs)
        tabs.push_back({{"label", each.label}, {"path", each.path}, {"unsaved", each.isUnsaved}});
    state["tabs"] = tabs;
    state["shownTab"] = shared.shownTab;
}

void addSource(Json& state, const Ui& ui) {
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
}

void addExamples(Json& state, const ExampleBrowser& examples) {
    const auto pictures = std::count_if(
        examples.tiles.begin(), examples.tiles.end(),
        [](const ExampleBrowser::Tile& each) { return each.thumbnail.state == Thumbnail::State::ready; });
    state["examples"] = {{"open", examples.isOpen},
                         {"scenes", examples.tiles.size()},
                         {"pictures", pictures},
                         {"drawing", examples.maker != nullptr}};
}

Json nodesJson(const std::vector<NodeCost>& nodes) {
    Json json = Json::array();
    for (const NodeCost& each : nodes)
        json.push_back({{"what", each.what}, {"line", each.line}, {"milliseconds", each.milliseconds}});
    return json;
}

void addCost(Json& state, const FrameCost& cost) {
    Json blocks = Json::array();
    for (const BlockCost& each : cost.blocks)
        blocks.push_back({{"what", each.what},
                          {"line", each.line},
                          {"runs", each.runs},
                          {"milliseconds", each.milliseconds},
                          {"nodes", nodesJson(each.nodes)}});
    state["cost"] = {{"frames", cost.frames},
                     {"milliseconds", cost.millisecondsPerFrame},
                     {"nodes", nodesJson(cost.nodes)},
                     {"blocks", blocks}};
}

void addInspector(Json& state, const Inspector& inspector) {
    if (!inspector.isOpen) return;
    Json columns = Json::array();
    for (const BufferColumn& each : inspector.table.columns) columns.push_back(each.name);
    Json head = Json::array();
    for (std::size_t i = 0; i < inspector.head.size(); ++i)
        head.push_back({inspector.table.head[i].name, inspector.head[i]});
    state["inspector"] = {{"chosen", inspector.chosen},
                          {"level", inspector.level},
                          {"layer", inspector.layer},
                          {"width", inspector.content ? inspector.content->width : 0},
                          {"height", inspector.content ? inspector.content->height : 0},
                          {"range", {inspector.display.low, inspector.display.high}},
                          {"zoom", inspector.zoom},
                          {"problem", inspector.problem},
                          {"columns", columns},
                          {"head", head},
                          {"firstRow", inspector.firstRow},
                          {"rows", inspector.rows}};
}

void addPanels(Json& state, const Ui& ui) {
    state["picture"] = ui.picture;
    state["mode"] = static_cast<int>(ui.mode);
    state["typing"] = ui.typing;
    state["notice"] = ui.notice;
    state["hardcopyMessage"] = ui.hardcopy.job ? std::string() : ui.hardcopy.message;
    state["lightTheme"] = ui.settings.lightTheme;
    state["inspected"] = ui.inspector.hovered;
    addInspector(state, ui.inspector);
    addTabs(state, ui.shared);
    addSource(state, ui);
    addExamples(state, ui.shared.examples);
    state["folder"] = ui.shared.dialog.list.folder.string();
    state["question"] = ui.shared.question.has_value();
    state["takesText"] = ImGui::GetIO().WantTextInput;
    state["suiteMessage"] = ui.suite.message;
    state["debugViewText"] = ui.debugViewText;
    if (const NoiseWindow& noise = ui.shared.noise; noise.isOpen)
        state["noise"] = {{"command", noise::noiseCommand(noise.noise, noise.file.data())},
                          {"point", noise.chosen},
                          {"message", noise.message}};
    if (ui.cost) addCost(state, *ui.cost);
    state["widgets"] = ui.widgets;
}

}  // namespace

std::string windowJson(const Ui& ui, const LoopState& loop) {
    Json state = stateOf(ui.session);
    addLoop(state, loop);
    addPanels(state, ui);
    return state.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace glibra::view
