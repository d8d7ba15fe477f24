#include "view/session/history.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <system_error>
#include <utility>

#include "base/files.h"
#include "image/file.h"
#include "suite/golden/hash_list.h"
#include "system/folder.h"

namespace glibra::view {

History::State History::stateOf(const Session& session) {
    State state{{}, session.look().view()};
    const std::vector<render::Knob>& knobs = session.values().knobs();
    for (std::size_t i = 0; i < knobs.size(); ++i)
        state.values.push_back({knobs[i].program, knobs[i].tag, session.values().resting(i)});
    return state;
}

bool History::isCurrent(const Session& session) const {
    if (states_.empty() || states_[at_].view != session.look().view()) return false;
    const std::vector<Value>& values = states_[at_].values;
    const std::vector<render::Knob>& knobs = session.values().knobs();
    if (values.size() != knobs.size()) return false;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i].program != knobs[i].program || values[i].tag != knobs[i].tag ||
            values[i].values != session.values().resting(i))
            return false;
    return true;
}

void History::record(const Session& session) {
    if (isCurrent(session)) return;
    State state = stateOf(session);
    if (!states_.empty()) states_.resize(at_ + 1);
    states_.push_back(std::move(state));
    if (states_.size() > kMost) states_.erase(states_.begin());
    at_ = states_.size() - 1;
}

void History::restore(Session& session) const {
    const std::vector<render::Knob>& knobs = session.values().knobs();
    for (const Value& each : states_[at_].values)
        for (std::size_t i = 0; i < knobs.size(); ++i)
            if (knobs[i].program == each.program && knobs[i].tag == each.tag)
                session.values().set(i, each.values);
    session.look().setView(states_[at_].view);
}

bool History::undo(Session& session) {
    record(session);
    if (session.values().undoAnimations()) return true;
    if (at_ == 0) return false;
    --at_;
    restore(session);
    return true;
}

bool History::redo(Session& session) {
    session.values().undoAnimations();
    if (at_ + 1 >= states_.size()) return false;
    ++at_;
    restore(session);
    return true;
}

void History::takeBack(const Session& session) {
    if (at_ == 0) return;
    --at_;
    if (isCurrent(session))
        states_.resize(at_ + 1);
    else
        ++at_;
}

void History::clear() {
    states_.clear();
    at_ = 0;
}

namespace {

using Json = nlohmann::ordered_json;

// In the orders of their enumerations.
constexpr std::array kProjections{"scene", "perspective", "orthographic"};
constexpr std::array kWidgets{"slider", "checkBox", "color", "numbers"};

template <class Enum>
const char* wordIn(Enum value, const auto& words) {
    return words.at(static_cast<std::size_t>(value));
}

Json knobsJson(const SceneValues& values) {
    Json knobs = Json::array();
    for (std::size_t i = 0; i < values.knobs().size(); ++i) {
        const render::Knob& each = values.knobs()[i];
        knobs.push_back({{"program", each.title},
                         {"tag", each.tag},
                         {"widget", wordIn(each.widget, kWidgets)},
                         {"minimum", each.minimum},
                         {"maximum", each.maximum},
                         {"initial", each.initial},
                         {"current", each.current},
                         {"animated", values.isAnimated(i)}});
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

namespace fs = std::filesystem;

constexpr double kBetweenWrites = .5;  ///< seconds
constexpr std::size_t kMostScenes = 1000;
constexpr std::uint64_t kLargestKept = 8ULL << 20;

fs::path fileOf(const fs::path& folder, const fs::path& scene) {
    const std::string path = system::wholePath(scene).generic_string();
    return folder / (suite::toText(suite::hashOf(std::as_bytes(std::span(path)))) + ".json");
}

/// Removes what was not written for longest if there are too many files.
void tidy(const fs::path& folder) {
    std::vector<std::pair<fs::file_time_type, fs::path>> files;
    std::error_code failure;
    for (fs::directory_iterator each(folder, failure), end; !failure && each != end; each.increment(failure))
        files.emplace_back(each->last_write_time(failure), each->path());
    if (files.size() <= kMostScenes) return;
    std::ranges::sort(files);
    for (std::size_t i = 0; i < files.size() - kMostScenes; ++i) fs::remove(files[i].second, failure);
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
    const Look& look = session.look();
    Json json{{"scene", session.path().generic_string()},
              {"framesDrawn", session.framesDrawn()},
              {"time", session.clock().time()},
              {"playing", session.clock().isPlaying()},
              {"speed", session.clock().speed()},
              {"moving", session.isMoving()},
              {"animated", session.usesTime()},
              {"axes", look.axes()},
              {"wireframe", look.wireframe()},
              {"debugView", nameOf(look.debugView())},
              {"width", look.width()},
              {"height", look.height()},
              {"samples", session.picture() ? session.picture()->samples() : 0},
              {"view", viewJson(look.view())},
              {"camera", look.camera()},
              {"knobs", knobsJson(session.values())},
              {"messages", messages}};
    if (session.hasScene()) {
        Json steps = Json::array();
        for (const render::Simulation::Progress& each : session.live().steps())
            steps.push_back({{"line", each.place.line}, {"rate", each.rate}, {"steps", each.steps}});
        json["steps"] = steps;
    }
    if (const auto& picked = look.picked())
        json["picked"] = {{"line", picked->draw.line},
                          {"word", picked->word},
                          {"eye", {picked->eye.x, picked->eye.y, picked->eye.z}},
                          {"centre", {picked->centre.x, picked->centre.y, picked->centre.z}}};
    json["measuresObjects"] = session.measuresObjects();
    if (const auto time = session.objectMilliseconds()) json["objectMilliseconds"] = *time;
    return json;
}

bool ValueKeeper::isSeen(const Session& session) const {
    if (seen_.size() != session.values().knobs().size() || scene_ != session.path()) return false;
    for (std::size_t i = 0; i < seen_.size(); ++i)
        if (seen_[i] != session.values().resting(i)) return false;
    return true;
}

void ValueKeeper::see(const Session& session) {
    scene_ = session.path();
    seen_.clear();
    for (std::size_t i = 0; i < session.values().knobs().size(); ++i)
        seen_.push_back(session.values().resting(i));
}

bool ValueKeeper::restore(Session& session) {
    changedAt_ = -1;
    bool isRestored = false;
    if (!folder_.empty() && session.hasScene()) {
        const fs::path file = fileOf(folder_, session.path());
        if (const auto bytes = image::readFile(file, {file.generic_string(), {}}, kLargestKept))
            isRestored = session.values().setKept(render::KeptValues::ofText(base::asText(*bytes)));
    }
    see(session);
    return isRestored;
}

double ValueKeeper::keep(const Session& session, double now) {
    if (!session.hasScene()) return -1;
    if (!isSeen(session)) {
        see(session);
        if (changedAt_ < 0) changedAt_ = now;
    }
    if (changedAt_ < 0) return -1;
    const double left = changedAt_ + kBetweenWrites - now;
    if (left > 0) return left;
    keepNow(session);
    return -1;
}

void ValueKeeper::keepNow(const Session& session) {
    if (folder_.empty() || !session.hasScene() || (changedAt_ < 0 && isSeen(session))) return;
    see(session);
    changedAt_ = -1;
    const fs::path file = fileOf(folder_, session.path());
    const std::string text = session.values().kept().text();
    std::error_code failure;
    if (text.empty()) {
        fs::remove(file, failure);
        return;
    }
    fs::create_directories(folder_, failure);
    if (!fs::exists(file, failure)) tidy(folder_);
    image::writeFileAtomically(file, std::as_bytes(std::span(text)));
}

void ValueKeeper::forget(const Session& session) {
    changedAt_ = -1;
    std::error_code failure;
    if (!folder_.empty() && session.hasScene()) fs::remove(fileOf(folder_, session.path()), failure);
}

}  // namespace glibra::view
