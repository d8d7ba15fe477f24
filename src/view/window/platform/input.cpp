#include "view/window/platform/input.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <tuple>

namespace glibra::view {
namespace {

using EventKind = Display::InputEvent::Kind;

bool isModifier(int key) {
    return key >= GLFW_KEY_LEFT_SHIFT && key <= GLFW_KEY_RIGHT_SUPER;
}
/// True for a key that without modifiers only types a character.
bool isPrinted(int key) {
    return key >= GLFW_KEY_SPACE && key <= GLFW_KEY_WORLD_2;
}

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

void InputQueue::add(std::span<const Display::InputEvent> events) {
    for (const Display::InputEvent& each : events)
        if (each.kind != EventKind::key || (each.code > 0 && each.code < static_cast<int>(kKeys)))
            waiting_.push_back(each);
}

void InputQueue::takeMouse(const Display::InputEvent& event, Frame& frame) {
    switch (event.kind) {
        case EventKind::move:
            mouse_ = event.at;
            if (buttons_ != 0) frame.way.push_back(event.at);
            return;
        case EventKind::leave:
            if (buttons_ == 0) mouse_.reset();  // a drag goes on outside
            return;
        case EventKind::wheel:
            frame.wheel += event.at.y;
            return;
        default:
            const unsigned bit = 1U << static_cast<unsigned>(event.code);
            buttons_ = event.isDown ? buttons_ | bit : buttons_ & ~bit;
    }
}

InputQueue::Frame InputQueue::next() {
    Frame frame;
    std::vector<int> released;
    bool isFull = false, hasKeys = false, hasButton = false, hasMoved = false, hasAlt = false;
    for (; !waiting_.empty() && !isFull; waiting_.pop_front()) {
        const Display::InputEvent event = waiting_.front();
        const bool isKey = event.kind == EventKind::key || event.kind == EventKind::character;
        if (!isKey) {
            const bool isButton = event.kind == EventKind::button;
            if (hasButton || (isButton && (hasKeys || hasMoved || !frame.way.empty()))) break;
            hasButton = isButton;
            const std::optional<MousePoint> before = mouse_;
            takeMouse(event, frame);
            hasMoved = hasMoved || mouse_ != before;
            continue;
        }
        if (hasButton || !frame.way.empty()) break;
        hasKeys = true;
        const bool control = isEitherDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
        const bool alt = isEitherDown(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
        if (event.kind == EventKind::character) {
            if (control && !alt) continue;  // Windows has a blank for Ctrl+Space
            // A word at most, so that undo goes by words however slow frames are.
            if (event.code != ' ' && !frame.characters.empty() && frame.characters.back() == ' ') break;
            frame.characters.push_back(static_cast<unsigned>(event.code));
            continue;
        }
        // A key must be up for one frame before it can be pressed again.
        if (event.isDown && std::ranges::find(released, event.code) != released.end()) break;
        const bool edits =
            event.isDown && !isModifier(event.code) && (control || alt || !isPrinted(event.code));
        // Alt alone opens the menu; ImGui has to see it down.
        const bool isAlt = event.code == GLFW_KEY_LEFT_ALT || event.code == GLFW_KEY_RIGHT_ALT;
        if (isAlt && !event.isDown && hasAlt) break;
        hasAlt = hasAlt || (isAlt && event.isDown);
        // What takes such a key, such as the list of words, has to know the text before it.
        if (edits && !frame.characters.empty()) break;
        down_.at(static_cast<std::size_t>(event.code)) = event.isDown;
        if (!event.isDown) released.push_back(event.code);
        if (!event.isDown || isModifier(event.code)) continue;
        const bool shift = isEitherDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
        frame.pressed.push_back({event.code, control, shift});
        isFull = edits;
    }
    frame.mouse = mouse_;
    frame.buttons = buttons_;
    return frame;
}

bool isDown(const FrameInput& input, int left, int right) {
    return std::ranges::any_of(input.keys, [&](int key) { return key == left || key == right; });
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

void InputRecord::addDropped(const std::vector<std::string>& files) {
    dropped_.insert(dropped_.end(), files.begin(), files.end());
}

void InputRecord::add(FrameInput frame, const std::vector<MousePoint>& way, std::pair<int, int> size) {
    if (way.size() > 1) frame.way = way;
    if (size != size_) frame.windowSize = size_ = size;
    frame.dropped = std::exchange(dropped_, {});
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

const FrameInput& InputReplay::next() {
    const FrameInput& frame = frames_[next_++];
    const bool control = isDown(frame, GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    const bool shift = isDown(frame, GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    pressed_.clear();
    for (const int key : frame.keys)
        if (std::ranges::find(keys_, key) == keys_.end()) pressed_.push_back({key, control, shift});
    keys_ = frame.keys;
    return frame;
}

}  // namespace glibra::view
