#include "view/window/window_json.h"

#include <imgui.h>

#include <nlohmann/json.hpp>

#include "system/places.h"
#include "view/session/value_keeper.h"

namespace glibra::view {
namespace {

using Json = nlohmann::ordered_json;

}  // namespace

std::string windowJson(const Ui& ui, const LoopState& loop) {
    Json state = stateOf(ui.session);
    state["window"] = {loop.windowSize.first, loop.windowSize.second};
    state["framesPresented"] = loop.framesPresented;
    state["reloads"] = loop.reloads;
    state["loadMilliseconds"] = loop.loadMilliseconds;
    state["firstDrawMilliseconds"] = loop.firstDrawMilliseconds;
    state["editToPictureMilliseconds"] = loop.editToPictureMilliseconds;
    state["refreshRate"] = loop.refreshRate;
    state["swapControl"] = loop.hasSwapControl;
    state["waiting"] = loop.isWaiting;
    state["cpuSeconds"] = system::processorSeconds();
    state["picture"] = ui.frame.picture;
    state["room"] = ui.frame.room;
    state["scale"] = ui.shared.scale;
    state["focused"] = ui.frame.focusedName;
    state["mode"] = static_cast<int>(ui.mode);
    state["typing"] = ui.sliders.typing;
    state["notice"] = ui.notice.text;
    state["noticeIsError"] = ui.notice.isError;
    state["lightTheme"] = ui.settings.lightTheme;
    state["question"] = ui.shared.question.has_value();
    state["takesText"] = ImGui::GetIO().WantTextInput;
    state["tabs"] = Json::array();
    for (const TabTitle& each : ui.shared.tabs)
        state["tabs"].push_back({{"label", each.label}, {"path", each.path}, {"unsaved", each.isUnsaved}});
    state["shownTab"] = ui.shared.shownTab;
    for (const PanelUse& each : ui.panels) each.panel->addTo(state, ui);
    state["widgets"] = ui.frame.widgets;
    return state.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace glibra::view
