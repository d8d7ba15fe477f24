#include "view/session/state_json.h"

#include <array>
#include <nlohmann/json.hpp>

namespace glibra::view {
namespace {

using Json = nlohmann::ordered_json;

// In the orders of their enumerations.
constexpr std::array kProjections{"scene", "perspective", "orthographic"};
constexpr std::array kWidgets{"slider", "checkBox", "color", "numbers"};

template <class Enum>
const char* wordIn(Enum value, const auto& words) {
    return words.at(static_cast<std::size_t>(value));
}

Json knobsJson(const Session& session) {
    Json knobs = Json::array();
    for (std::size_t i = 0; i < session.knobs().size(); ++i) {
        const Knob& each = session.knobs()[i];
        knobs.push_back({{"program", each.title},
                         {"tag", each.tag},
                         {"widget", wordIn(each.widget, kWidgets)},
                         {"minimum", each.minimum},
                         {"maximum", each.maximum},
                         {"initial", each.initial},
                         {"current", each.current},
                         {"animated", session.isAnimated(i)}});
    }
    return knobs;
}

Json viewJson(const ViewState& view) {
    Json objects = Json::array();
    for (const ViewState::Object& each : view.objects)
        objects.push_back({{"line", each.line}, {"matrix", each.matrix}});
    Json json{{"scene", view.scene},
              {"eye", view.eye},
              {"texture", view.texture},
              {"objects", objects},
              {"projection", wordIn(view.projection, kProjections)}};
    if (view.background) json["background"] = *view.background;
    return json;
}

}  // namespace

nlohmann::ordered_json stateOf(const Session& session) {
    Json messages = Json::array();
    for (const Diagnostic& each : session.diagnostics())
        messages.push_back({{"severity", name(each.severity)},
                            {"id", each.id},
                            {"text", each.text},
                            {"file", each.place.file},
                            {"line", each.place.line},
                            {"column", each.place.column}});
    Json json{{"scene", session.path().string()},
              {"framesDrawn", session.framesDrawn()},
              {"time", session.clock().time()},
              {"playing", session.clock().isPlaying()},
              {"speed", session.clock().speed()},
              {"moving", session.isMoving()},
              {"animated", session.usesTime()},
              {"axes", session.axes()},
              {"wireframe", session.wireframe()},
              {"debugView", nameOf(session.debugView())},
              {"width", session.width()},
              {"height", session.height()},
              {"samples", session.picture() ? session.picture()->samples() : 0},
              {"view", viewJson(session.view())},
              {"camera", session.camera()},
              {"knobs", knobsJson(session)},
              {"messages", messages}};
    if (session.hasScene()) {
        Json steps = Json::array();
        for (const render::Simulation::Progress& each : session.live().steps())
            steps.push_back({{"line", each.place.line}, {"rate", each.rate}, {"steps", each.steps}});
        json["steps"] = steps;
    }
    if (const auto& picked = session.picked())
        json["picked"] = {{"line", picked->draw.line},
                          {"word", picked->word},
                          {"eye", {picked->eye.x, picked->eye.y, picked->eye.z}},
                          {"centre", {picked->centre.x, picked->centre.y, picked->centre.z}}};
    json["measuresObjects"] = session.measuresObjects();
    if (const auto time = session.objectMilliseconds()) json["objectMilliseconds"] = *time;
    return json;
}

}  // namespace glibra::view
