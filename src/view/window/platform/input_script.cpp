#include "view/window/platform/input_script.h"

#include <nlohmann/json.hpp>
#include <tuple>

namespace glibra::view {
namespace {

// These read a member if it is there and has the right type.

template <class T>
void readNumber(const nlohmann::json& json, const char* key, T& value) {
    const auto found = json.find(key);
    if (found != json.end() && found->is_number()) value = found->get<T>();
}

bool isPair(const nlohmann::json& json) {
    return json.is_array() && json.size() == 2 && json[0].is_number() && json[1].is_number();
}

template <class T>
std::optional<std::pair<T, T>> readPair(const nlohmann::json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !isPair(*found)) return std::nullopt;
    return std::pair((*found)[0].get<T>(), (*found)[1].get<T>());
}

std::optional<std::string> readText(const nlohmann::json& json, const char* key) {
    const auto found = json.find(key);
    if (found == json.end() || !found->is_string()) return std::nullopt;
    return found->get<std::string>();
}

/// The elements of a list, without those of another type.
template <class T>
std::vector<T> readList(const nlohmann::json& json, const char* key, bool (nlohmann::json::*isType)() const) {
    std::vector<T> values;
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array()) return values;
    for (const nlohmann::json& each : *found)
        if ((each.*isType)()) values.push_back(each.get<T>());
    return values;
}

/// Without the elements that are no points.
std::vector<MousePoint> readPoints(const nlohmann::json& json, const char* key) {
    std::vector<MousePoint> points;
    const auto found = json.find(key);
    if (found == json.end() || !found->is_array()) return points;
    for (const nlohmann::json& each : *found)
        if (isPair(each)) points.push_back({each[0].get<double>(), each[1].get<double>()});
    return points;
}

/// A missing mouse position and missing buttons are those of the frame before.
FrameInput frameOf(const nlohmann::json& json, const FrameInput& before) {
    FrameInput frame;
    std::tie(frame.mouseX, frame.mouseY) =
        readPair<float>(json, "mouse").value_or(std::pair(before.mouseX, before.mouseY));
    frame.buttons = before.buttons;
    readNumber(json, "buttons", frame.buttons);
    readNumber(json, "wheel", frame.wheel);
    frame.way = readPoints(json, "way");
    frame.keys = readList<int>(json, "keys", &nlohmann::json::is_number_integer);
    frame.text = readText(json, "text").value_or("");
    frame.windowSize = readPair<int>(json, "size");
    frame.open = readText(json, "open");
    frame.dropped = readList<std::string>(json, "drop", &nlohmann::json::is_string);
    return frame;
}

}  // namespace

void InputRecorder::add(const FrameInput& frame) {
    nlohmann::ordered_json json{{"mouse", {frame.mouseX, frame.mouseY}}, {"buttons", frame.buttons}};
    if (frame.wheel != 0) json["wheel"] = frame.wheel;
    for (const MousePoint& each : frame.way) json["way"].push_back({each.x, each.y});
    if (!frame.keys.empty()) json["keys"] = frame.keys;
    if (!frame.text.empty()) json["text"] = frame.text;
    if (frame.windowSize) json["size"] = {frame.windowSize->first, frame.windowSize->second};
    if (frame.open) json["open"] = *frame.open;
    if (!frame.dropped.empty()) json["drop"] = frame.dropped;
    out_ << json.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace) << '\n' << std::flush;
}

std::vector<FrameInput> readInput(const std::filesystem::path& file) {
    std::vector<FrameInput> frames;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line);) {
        const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
        if (json.is_object()) frames.push_back(frameOf(json, frames.empty() ? FrameInput{} : frames.back()));
    }
    return frames;
}

}  // namespace glibra::view
