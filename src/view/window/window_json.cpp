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

/// Left, top and bottom of the text cursor, in screen coordinates.
Json cursorOf(const Ui& ui) {
    const auto view = ui.source.views.find(ui.source.chosen);
    const CodeView::Corner at =
        view == ui.source.views.end() ? CodeView::Corner() : view->second.cursorOnScreen;
    return Json::array({at.x, at.top, at.bottom});
}

void addProbe(Json& state, const ProbeWindow& probe) {
    Json values = Json::object();
    if (probe.pixel)
        for (const auto* list : {&probe.pixel->outputs, &probe.pixel->inputs, &probe.pixel->uniforms})
            for (const ProbedValue& each : *list) values[each.name] = each.numbers;
    state["probe"] = {{"on", probe.isOn},
                      {"drawn", probe.pixel && probe.pixel->isDrawn},
                      {"line", probe.pixel ? probe.pixel->draw.line : 0},
                      {"x", probe.pixel ? probe.pixel->x : -1},
                      {"y", probe.pixel ? probe.pixel->y : -1},
                      {"values", values}};
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
                       {"translation", ui.shownTranslation},
                       {"cursor", cursorOf(ui)},
                       {"live", ui.settings.compilesWhileTyping},
                       {"compiled", ui.session.texts().size()},
                       {"hover", ui.hoverText}};
    const CodeAssist& assist = ui.source.assist;
    Json words = Json::array();
    if (assist.isOpen)
        for (std::size_t i = 0; i < std::min<std::size_t>(assist.words.size(), 20); ++i)
            words.push_back({{"word", assist.words[i].word}, {"type", assist.words[i].type}});
    state["completion"] = {{"open", assist.isOpen}, {"chosen", assist.chosen}, {"words", words}};
    state["reference"] = {{"open", assist.showsReference},
                          {"word", assist.entry.word},
                          {"code", assist.entry.code},
                          {"text", assist.entry.text}};
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
                         {"found", examples.found},
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
                     {"isTimed", cost.isTimed},
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

Json compareJson(const CompareWindow& compare) {
    Json json = {{"scene", compare.comparison->path().string()}, {"problem", compare.problem}};
    if (const std::optional<Comparison::Score> score = compare.comparison->known())
        json["score"] = {score->flip, score->structure};
    return json;
}

void addPanels(Json& state, const Ui& ui) {
    state["picture"] = ui.picture;
    state["room"] = ui.room;
    state["scale"] = ui.scale;
    state["focusedSlider"] = ui.focusedName;
    state["mode"] = static_cast<int>(ui.mode);
    state["typing"] = ui.typing;
    state["notice"] = ui.notice.text;
    state["noticeIsError"] = ui.notice.isError;
    state["banner"] = ui.banner;
    addProbe(state, ui.probe);
    state["hardcopyMessage"] = ui.hardcopy.job ? std::string() : ui.hardcopy.message;
    state["lightTheme"] = ui.settings.lightTheme;
    state["inspected"] = ui.inspector.hovered;
    addInspector(state, ui.inspector);
    if (const CompareWindow& compare = ui.compare; compare.isOpen && compare.comparison)
        state["compare"] = compareJson(compare);
    addTabs(state, ui.shared);
    addSource(state, ui);
    addExamples(state, ui.shared.examples);
    state["folder"] = ui.shared.dialog.list.folder.string();
    state["question"] = ui.shared.question.has_value();
    state["messageBox"] = ui.messageBox.isShown ? ui.messageBox.texts : std::vector<std::string>();
    state["dialog"] = ui.shared.dialog.question ? ui.shared.dialog.question->title : std::string();
    state["hardcopyFile"] = ui.hardcopy.file.data();
    state["labels"] = ui.labels.texture && ui.showLabels ? ui.labels.lines : std::vector<std::string>();
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
