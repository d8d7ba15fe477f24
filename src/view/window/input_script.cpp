#include "view/window/input_script.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

namespace glibra::view {
namespace {

constexpr unsigned kButtons = 3;
constexpr float kFrameSeconds = 1.F / 60;

template <class T>
void read(const nlohmann::json& json, const char* key, T& value) {
    const auto found = json.find(key);
    if (found != json.end() && found->is_number()) value = found->get<T>();
}

}  // namespace

void InputRecorder::add(const FrameInput& frame) {
    nlohmann::ordered_json json{{"mouse", {frame.mouseX, frame.mouseY}}, {"buttons", frame.buttons}};
    if (frame.wheel != 0) json["wheel"] = frame.wheel;
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
    FrameInput frame;
    for (std::string line; std::getline(in, line);) {
        const nlohmann::json json = nlohmann::json::parse(line, nullptr, false);
        if (!json.is_object()) continue;
        frame = {frame.mouseX, frame.mouseY, frame.buttons, 0, {}, {}, {}, {}, {}};
        const auto isPair = [&](const char* key) {
            const auto found = json.find(key);
            return found != json.end() && found->is_array() && found->size() == 2 &&
                   (*found)[0].is_number() && (*found)[1].is_number();
        };
        if (isPair("mouse")) {
            frame.mouseX = json["mouse"][0].get<float>();
            frame.mouseY = json["mouse"][1].get<float>();
        }
        read(json, "buttons", frame.buttons);
        read(json, "wheel", frame.wheel);
        if (const auto keys = json.find("keys"); keys != json.end() && keys->is_array())
            for (const auto& each : *keys)
                if (each.is_number_integer()) frame.keys.push_back(each.get<int>());
        if (const auto text = json.find("text"); text != json.end() && text->is_string())
            frame.text = text->get<std::string>();
        if (isPair("size")) frame.windowSize = {json["size"][0].get<int>(), json["size"][1].get<int>()};
        if (const auto open = json.find("open"); open != json.end() && open->is_string())
            frame.open = open->get<std::string>();
        if (const auto drop = json.find("drop"); drop != json.end() && drop->is_array())
            for (const auto& each : *drop)
                if (each.is_string()) frame.dropped.push_back(each.get<std::string>());
        frames.push_back(frame);
    }
    return frames;
}

FrameInput presentInput() {
    const ImGuiIO& io = ImGui::GetIO();
    FrameInput frame;
    frame.mouseX = io.MousePos.x;
    frame.mouseY = io.MousePos.y;
    for (unsigned i = 0; i < kButtons; ++i)
        if (io.MouseDown[i]) frame.buttons |= 1U << i;
    frame.wheel = io.MouseWheel;
    for (int key = 0; key < GLFW_KEY_LAST; ++key)
        if (io.KeysDown[key]) frame.keys.push_back(key);
    for (const ImWchar each : io.InputQueueCharacters)
        if (each < 128) frame.text += static_cast<char>(each);
    return frame;
}

void imposeInput(const FrameInput& frame) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {frame.mouseX, frame.mouseY};
    for (unsigned i = 0; i < kButtons; ++i) io.MouseDown[i] = (frame.buttons >> i & 1U) != 0;
    io.MouseWheel = frame.wheel;
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    for (const int key : frame.keys)
        if (key >= 0 && key < static_cast<int>(std::size(io.KeysDown))) io.KeysDown[key] = true;
    const auto isDown = [&](int left, int right) { return io.KeysDown[left] || io.KeysDown[right]; };
    io.KeyCtrl = isDown(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL);
    io.KeyShift = isDown(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT);
    io.KeyAlt = isDown(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT);
    io.ClearInputCharacters();
    io.AddInputCharactersUTF8(frame.text.c_str());
    io.DeltaTime = kFrameSeconds;
}

}  // namespace glibra::view
